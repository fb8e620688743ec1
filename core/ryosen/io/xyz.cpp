#include "ryosen/io/xyz.h"

#include <algorithm>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/io/numbers.h"
#include "ryosen/io/reporter.h"
#include "ryosen/io/text_lines.h"

namespace ryosen {
namespace {

// Hands out the words of a line.
class LineWords {
 public:
  explicit LineWords(std::string_view text) : text_(text) {
    mark_ = text.find(';') != std::string_view::npos ? ';' : text.find(',') != std::string_view::npos ? ',' : ' ';
    if (mark_ == ' ') return;
    const std::string_view last = trimmed(text_);
    if (last.back() == mark_) text_.remove_suffix(static_cast<std::size_t>(text_.end() - last.end()) + 1);
  }

  // The first word with a comma if semicolons keep the words apart; empty if there is none.
  std::string_view comma_between_semicolons() const {
    const std::size_t comma = mark_ == ';' ? text_.find(',') : std::string_view::npos;
    if (comma == std::string_view::npos) return {};
    const std::size_t begin = text_.substr(0, comma).rfind(';') + 1;  // npos + 1 is 0
    return trimmed(text_.substr(begin, std::min(text_.find(';', comma), text_.size()) - begin));
  }
  // The next word; what stands between two marks may have blanks in it.
  std::string_view next() {
    if (mark_ == ' ') return take_word(text_);
    const std::size_t end = std::min(text_.find(mark_), text_.size());
    const std::string_view word = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    const std::string_view inner = trimmed(word);
    return inner.empty() ? word.substr(0, 0) : inner;
  }
  bool is_at_end() const { return is_blank(text_); }
  const char* rest() const { return text_.data(); }

 private:
  std::string_view text_;
  char mark_ = ' ';
};

// Whether it is a number with a comma in place of its point, or several of them that blanks keep apart.
bool has_decimal_comma(std::string_view word) {
  const std::size_t comma = word.find_first_of(", \t");
  return comma != std::string_view::npos && comma + 1 < word.size() && is_digit(word[comma + 1]);
}

Text unreadable(std::string_view word) {
  Text text = not_a_number(word);
  if (!has_decimal_comma(word)) return text;
  text.en += " Numbers with a decimal comma are not read; write them with a point.";
  text.ja += "小数点がコンマの数は読めません。ピリオドにしてください。";
  return text;
}

// Every step returns false where the line has a fault.
class XyzReader {
 public:
  explicit XyzReader(std::string_view bytes) : lines_(bytes, false) {}

  Result<MeshFile> read() {
    TextLine line;
    while (lines_.next(line)) {
      const std::string_view text = line.text.substr(0, line.text.find('#'));
      if (is_blank(text)) continue;
      glm::dvec3 p;
      if (!read_point(text, p) || faults_.any()) continue;
      if (!is_finite(p)) warn_of_non_finite_vertex(reporter_, FilePlace::at_line(lines_.count()));
      file_.mesh.positions.push_back(p);
      file_.mesh.vertex_lines.add(lines_.count());
    }
    if (faults_.any()) return faults_.take();
    file_.left_out = reporter_.left_out();
    file_.messages = reporter_.take();
    return std::move(file_);
  }

 private:
  bool read_point(std::string_view text, glm::dvec3& p) {
    std::string_view plain = text;
    if (take_number(plain, p.x) && take_number(plain, p.y) && take_number(plain, p.z) && is_blank(plain)) return true;
    LineWords words(text);
    if (const std::string_view word = words.comma_between_semicolons(); !word.empty()) return refuse(word);
    for (int i = 0; i < 3; ++i)
      if (!read_number(words, p[i])) return false;
    if (words.is_at_end()) return true;
    warn_of_extra_values(reporter_, lines_.place(words.rest()));
    return true;
  }

  bool read_number(LineWords& words, double& value) {
    const std::string_view word = words.next();
    if (word.empty())
      return faults_.add("missing_number", lines_.place(word.data()), [] {
        return Text{"The line has fewer than the three numbers of a point.", "この行には点の座標 3 個が必要です。"};
      });
    return read_real(word, value) != NumberRead::unreadable || refuse(word);
  }

  bool refuse(std::string_view word) {
    return faults_.add("unreadable_number", lines_.place(word.data()), [&] { return unreadable(word); });
  }

  TextLines lines_;
  MeshFile file_;
  Reporter reporter_;
  Faults faults_;
};

// Whether a line may be one of points: three numbers or more, or blank.
bool may_be_point(std::string_view text, bool& is_point) {
  is_point = !is_blank(text);
  LineWords words(text);
  for (int i = 0; i < 3 && is_point; ++i) {
    double value = 0;
    const std::string_view word = words.next();
    if (word.empty() || read_real(word, value) == NumberRead::unreadable) return false;
  }
  return true;
}

}  // namespace

Result<MeshFile> read_xyz(std::string_view bytes, const std::filesystem::path&) {
  if (std::optional<Failure> refusal = refuse_nul_bytes(bytes)) return std::move(*refusal);
  return XyzReader(bytes).read();
}

Likeness looks_like_xyz(std::string_view head, std::uint64_t size) {
  if (head.size() < size) head = head.substr(0, head.rfind('\n') + 1);  // the last line may be cut
  TextLines lines(head, false);
  TextLine line;
  bool has_point = false;
  while (lines.next(line)) {
    bool is_point = false;
    if (!may_be_point(line.text.substr(0, line.text.find('#')), is_point)) return Likeness::no;
    has_point = has_point || is_point;
  }
  return has_point ? Likeness::maybe : Likeness::no;
}

}  // namespace ryosen
