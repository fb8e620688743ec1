#include "core/io/sniff.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "core/io/numbers.h"
#include "core/io/off.h"
#include "core/io/reporter.h"
#include "core/io/stl.h"
#include "core/io/stl_text.h"
#include "core/io/text_lines.h"

namespace ryosen {
namespace {

struct Signature {
  std::string_view bytes;
  std::string_view name;
};

constexpr std::string_view gzip("\x1f\x8b", 2);
constexpr Signature compressed[] = {{gzip, "gzip"},
                                    {"PK\x03\x04", "zip"},
                                    {"BZh", "bzip2"},
                                    {"\xfd"
                                     "7zXZ",
                                     "xz"},
                                    {"\x28\xb5\x2f\xfd", "zstd"},
                                    {"7z\xbc\xaf", "7z"}};

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x09 || (byte > 0x0d && byte < 0x20) || byte == 0x7f;
}

// UTF-16 without its mark: Latin text, so that every other byte is zero.
bool has_zero_every_second(std::string_view head) {
  if (head.size() < 8) return false;
  std::size_t zeros[2] = {0, 0};
  for (std::size_t i = 0; i < head.size(); ++i) zeros[i % 2] += head[i] == '\0' ? 1 : 0;
  const std::size_t half = head.size() / 2;
  return (zeros[0] >= half * 9 / 10 && zeros[1] == 0) || (zeros[1] >= half * 9 / 10 && zeros[0] == 0);
}

}  // namespace

std::optional<Failure> refuse_before_sniffing(std::string_view head) {
  const FilePlace start = FilePlace::at_byte(0);
  if (head.empty()) {
    return malformed("empty_file", {"The file is empty, it has no vertices.", "ファイルが空です。頂点がありません。"},
                     start);
  }
  for (const Signature& signature : compressed) {
    if (!head.starts_with(signature.bytes)) continue;
    const std::string name(signature.name);
    return malformed("compressed_file",
                     {"The content is compressed (" + name + "); unpack it first.",
                      "内容が圧縮されています(" + name + ")。先に展開してください。"},
                     start);
  }
  if (head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff") || has_zero_every_second(head)) {
    return malformed("utf16",
                     {"The file is text in UTF-16; save it as UTF-8 or ASCII.",
                      "ファイルが UTF-16 のテキストです。UTF-8 か ASCII で保存してください。"},
                     start);
  }
  if (std::all_of(head.begin(), head.end(), [](char c) { return c == '\0'; })) {
    return malformed("zeros",
                     {"The file begins with nothing but zero bytes; it is damaged.",
                      "ファイルの先頭が 0 のバイトばかりです。壊れています。"},
                     start);
  }
  return std::nullopt;
}

std::optional<Failure> refuse_binary(std::string_view head) {
  const auto first = std::find_if(head.begin(), head.end(), is_control);
  if (first == head.end()) return std::nullopt;
  const auto byte = static_cast<std::uint64_t>(first - head.begin());
  if (*first == '\0' && std::count_if(head.begin(), head.end(), is_control) == 1) return nul_byte_failure(byte);
  return malformed(
      "binary_content",
      {"The content is binary, of no known mesh format.", "内容がバイナリーで、既知のメッシュ形式ではありません。"},
      FilePlace::at_byte(byte));
}

Likeness looks_like_obj(std::string_view head) {
  constexpr std::string_view with_number[] = {"v", "vt", "vn", "f", "l", "p"};
  constexpr std::string_view with_text[] = {"g", "o", "s"};
  constexpr std::string_view telling[] = {"mtllib", "usemtl"};
  const auto is_one_of = [](std::string_view word, const auto& words) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
  };
  Likeness likeness = Likeness::no;
  TextLines lines(head, false);
  TextLine line;
  while (lines.next(line)) {
    std::string_view rest = line.text;
    const std::string_view word = take_word(rest);
    if (word.empty() || word[0] == '#') continue;
    if (is_one_of(word, telling)) return Likeness::sure;
    const std::string_view value = take_word(rest);
    const bool is_number = !value.empty() && (value[0] == '-' || value[0] == '+' || value[0] == '.' ||
                                              (value[0] >= '0' && value[0] <= '9'));
    if (is_one_of(word, with_number) && is_number) return Likeness::sure;
    if (!is_one_of(word, with_number) && !is_one_of(word, with_text)) return likeness;
    likeness = Likeness::maybe;
  }
  return likeness;
}

Likeness looks_like_off(std::string_view head) {
  TextLines lines(head, false);
  TextLine line;
  while (lines.next(line)) {
    std::string_view rest = line.text;
    const std::string_view word = take_word(rest);
    if (word.empty() || word[0] == '#') continue;
    return OffKind::from_word(word.substr(0, word.find('#'))) ? Likeness::sure : Likeness::no;
  }
  return Likeness::no;
}

Likeness looks_like_ply(std::string_view head) {
  const std::size_t end = head.find_first_of("\r\n");
  return trimmed(head.substr(0, end)) == "ply" ? Likeness::sure : Likeness::no;
}

Likeness looks_like_stl(std::string_view head, std::uint64_t size) {
  if (is_whole_binary_stl(head, size)) return Likeness::sure;
  if (!may_be_ascii_stl(head)) return size >= stl_head_bytes + 4 ? Likeness::maybe : Likeness::no;
  TextLines lines(head, false);
  TextLine line;
  bool has_solid = false;
  while (lines.next(line)) {
    std::string_view rest = line.text;
    const std::string_view word = take_word(rest);
    if (word.empty()) continue;
    if (has_solid) return is_stl_word(word, "facet") || is_stl_word(word, "endsolid") ? Likeness::sure : Likeness::no;
    if (!is_stl_word(word, "solid")) return Likeness::no;
    has_solid = true;
  }
  return has_solid ? Likeness::maybe : Likeness::no;
}

// Two whole numbers, then a line of three numbers.
Likeness looks_like_txt(std::string_view head) {
  TextLines lines(head, false);
  TextLine line;
  bool has_counts = false;
  while (lines.next(line)) {
    std::string_view rest = line.text;
    std::size_t words = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++words) {
      std::int64_t count = 0;
      double value = 0;
      if (has_counts ? read_real(word, value) == NumberRead::unreadable : !read_integer(word, count))
        return Likeness::no;
    }
    if (words == 0) continue;
    if (has_counts) return words == 3 ? Likeness::sure : Likeness::no;
    if (words != 2) return Likeness::no;
    has_counts = true;
  }
  return has_counts ? Likeness::maybe : Likeness::no;
}

}  // namespace ryosen
