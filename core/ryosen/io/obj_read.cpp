// Feeds an OBJ file to tinyobjloader line by line; its callbacks classify each line.
#include <tiny_obj_loader.h>

#include <algorithm>
#include <istream>
#include <memory>
#include <streambuf>
#include <vector>

#include "ryosen/base/parallel.h"
#include "ryosen/io/numbers.h"
#include "ryosen/io/obj.h"
#include "ryosen/io/obj_builder.h"
#include "ryosen/io/text_lines.h"

namespace ryosen {
namespace {

// A stream buffer that provides one logical line at a time, without copying if it is contiguous in the file. Lines for
// which no callback came before the next one is requested (s, l, p, mtllib, a bare keyword, unknown words) are
// classified by their first word. Comments and blank lines are skipped.
class ObjFeed : public std::streambuf {
 public:
  ObjFeed(TextLines& lines, ObjBuilder& builder) : lines_(lines), builder_(builder) {}

  // What follows the keyword, for the callback of a line.
  std::string_view after_keyword(std::size_t keyword_length) {
    has_called_ = true;
    return text_.substr(keyword_length);
  }
  ObjBuilder& builder() { return builder_; }

 protected:
  int_type underflow() override {
    if (!has_called_) take_line_without_callback();
    has_called_ = true;
    TextLine line;
    while (!builder_.is_done() && lines_.next(line)) {
      const char* begin = line.text.data();
      const char* const end = begin + line.text.size();
      while (begin != end && (*begin == ' ' || *begin == '\t')) ++begin;
      if (begin == end) continue;
      text_ = {begin, static_cast<std::size_t>(end - begin)};
      if (*begin == '#') {
        builder_.comment(text_);
        continue;
      }
      has_called_ = false;
      // setg() takes non-const pointers, but the stream only reads. Includes the line end.
      char* const area = const_cast<char*>(begin);
      setg(area, area, const_cast<char*>(end) + (*end == '\r' ? 2 : 1));
      return traits_type::to_int_type(*begin);
    }
    setg(nullptr, nullptr, nullptr);
    return traits_type::eof();
  }

 private:
  void take_line_without_callback() {
    using Kind = ObjBuilder::NameKind;
    std::string_view rest = text_;
    const std::string_view word = take_word(rest);
    if (word == "f") return builder_.face(rest);
    if (word == "l" || word == "p") return builder_.element(word == "p", rest);
    if (word == "s") return builder_.name(Kind::smoothing, rest);
    if (word == "g") return builder_.name(Kind::group, rest);
    if (word == "o") return builder_.name(Kind::object, rest);
    if (word == "usemtl") return builder_.name(Kind::material, rest);
    if (word == "mtllib") return builder_.material_library(rest);
    if (word == "v") return builder_.vertex(rest);
    if (word == "vt") return builder_.texcoord(rest);
    if (word == "vn") return builder_.normal(rest);
    builder_.unknown(word);
  }

  TextLines& lines_;
  ObjBuilder& builder_;
  std::string_view text_;   // the current line, without leading blanks
  bool has_called_ = true;  // false: the current line had no callback yet
};

// Callbacks of lines with values, and of those with a name, behind a keyword of so many letters. What tinyobjloader
// makes of them is ignored: its numbers are inexact and wrap around. The builder parses the line itself.
template <auto take, std::size_t keyword, class... Ignored>
void on_values(void* data, Ignored...) {
  ObjFeed& feed = *static_cast<ObjFeed*>(data);
  (feed.builder().*take)(feed.after_keyword(keyword));
}
template <ObjBuilder::NameKind kind, std::size_t keyword, class... Ignored>
void on_name(void* data, Ignored...) {
  ObjFeed& feed = *static_cast<ObjFeed*>(data);
  feed.builder().name(kind, feed.after_keyword(keyword));
}

// Passes the lines through tinyobjloader's callbacks to the builder.
void feed(TextLines& lines, ObjBuilder& builder) {
  ObjFeed source(lines, builder);
  std::istream stream(&source);
  stream.exceptions(std::ios_base::badbit);  // otherwise the stream swallows exceptions thrown while reading a line
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = on_values<&ObjBuilder::vertex, 1>;
  callbacks.normal_cb = on_values<&ObjBuilder::normal, 2>;
  callbacks.texcoord_cb = on_values<&ObjBuilder::texcoord, 2>;
  callbacks.index_cb = on_values<&ObjBuilder::face, 1>;
  callbacks.usemtl_cb = on_name<ObjBuilder::NameKind::material, 6>;
  callbacks.group_cb = on_name<ObjBuilder::NameKind::group, 1>;
  callbacks.object_cb = on_name<ObjBuilder::NameKind::object, 1>;
  // Without a material reader the library opens no file. Its result is ignored: every line is checked here.
  tinyobj::LoadObjWithCallback(stream, callbacks, &source, nullptr, nullptr, nullptr);
}

// A piece of the file, parsed independently.
struct Piece {
  Piece(std::string_view piece_bytes, const std::filesystem::path& path, bool is_later)
      : bytes(piece_bytes), lines(bytes, true), builder(lines, path, is_later) {}

  void read() {
    has_nul = bytes.find('\0') != std::string_view::npos;
    if (!has_nul) feed(lines, builder);
  }

  std::string_view bytes;
  TextLines lines;
  ObjBuilder builder;
  bool has_nul = false;
};

using Pieces = std::vector<std::unique_ptr<Piece>>;

// Appends the other pieces to the builder of the first, as parsed or by parsing their lines again.
Result<MeshFile> join(const Pieces& pieces, unsigned threads) {
  std::vector<ObjBuilder*> builders;
  for (const auto& piece : pieces) builders.push_back(&piece->builder);
  ObjBuilder& builder = *builders[0];
  if (pieces.size() > 1) builder.reserve_for(builders);
  std::uint64_t lines_before = pieces[0]->lines.count();
  for (std::size_t i = 1; i < pieces.size() && !builder.is_done();) {
    if (builder.has_fault() && builders[i]->is_joinable()) {  // there is none in this one
      lines_before += pieces[i++]->lines.count();
      continue;
    }
    const std::size_t begin = i;
    while (!builder.has_fault() && i < pieces.size() && builders[i]->is_joinable()) ++i;
    lines_before = builder.append(std::span(builders).subspan(begin, i - begin), lines_before, threads);
    if (i == pieces.size()) break;
    TextLines lines(pieces[i++]->bytes, true, lines_before);
    builder.continue_with(lines);
    feed(lines, builder);
    lines_before = lines.count();
  }
  return builder.finish();
}

}  // namespace

Likeness looks_like_obj(std::string_view head, std::uint64_t) {
  Likeness likeness = Likeness::no;
  TextLines lines(head, false);
  TextLine line;
  while (lines.next(line)) {
    std::string_view rest = line.text;
    const std::string_view word = take_word(rest);
    if (word.empty() || word[0] == '#') continue;
    if (word == "mtllib" || word == "usemtl") return Likeness::sure;
    const std::string_view value = take_word(rest);
    const bool is_number =
        !value.empty() && (value[0] == '-' || value[0] == '+' || value[0] == '.' || is_digit(value[0]));
    if (announces_numbers(word) && is_number) return Likeness::sure;
    if (!announces_numbers(word) && word != "g" && word != "o" && word != "s") return likeness;
    likeness = Likeness::maybe;
  }
  return likeness;
}

std::vector<std::string_view> cut_obj(std::string_view bytes, std::size_t piece_bytes) {
  std::vector<std::string_view> pieces;
  std::size_t begin = 0;
  for (std::size_t end = piece_bytes; end < bytes.size();) {
    end = bytes.find('\n', end);
    if (end == std::string_view::npos || ++end == bytes.size()) break;
    const std::size_t line_end = end >= 2 && bytes[end - 2] == '\r' ? end - 2 : end - 1;
    const std::size_t last = bytes.substr(begin, line_end - begin).find_last_not_of(" \t");
    const bool goes_on = last != std::string_view::npos && bytes[begin + last] == '\\';
    if (goes_on || bytes[end] == byte_order_mark.front()) continue;
    pieces.push_back(bytes.substr(begin, end - begin));
    begin = end;
    end += piece_bytes;
  }
  pieces.push_back(bytes.substr(begin));
  return pieces;
}

Result<MeshFile> read_obj_pieces(std::span<const std::string_view> parts, const std::filesystem::path& path,
                                 unsigned threads) {
  Pieces pieces;
  for (const std::string_view part : parts)
    pieces.push_back(std::make_unique<Piece>(part, path, part.data() != parts.front().data()));
  for_each_task(static_cast<unsigned>(pieces.size()), threads, [&](unsigned i) { pieces[i]->read(); });
  for (const auto& piece : pieces) {
    const char* const begin = parts.front().data();
    if (piece->has_nul)
      return *refuse_nul_bytes({begin, static_cast<std::size_t>(parts.back().data() - begin) + parts.back().size()});
  }
  return join(pieces, threads);
}

Result<MeshFile> read_obj(std::string_view bytes, const std::filesystem::path& path) {
  constexpr std::size_t piece_bytes = std::size_t{1} << 20;  // keeps the columns of a piece small
  const unsigned threads = threads_for(bytes.size() / 16);
  // For larger files the 32-bit numbering must be checked across pieces.
  const bool in_pieces = threads > 1 && bytes.size() < no_index;
  return read_obj_pieces(cut_obj(bytes, in_pieces ? piece_bytes : bytes.size()), path, threads);
}

}  // namespace ryosen
