#include "ryosen/io/sniff.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "ryosen/io/faults.h"

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

// UTF-16 without a byte order mark: in Latin text every other byte is zero.
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
  if (head.empty()) return empty_file();
  for (const Signature& signature : compressed) {
    if (!head.starts_with(signature.bytes)) continue;
    const std::string name(signature.name);
    Text text{"The content is compressed (" + name + "); unpack it first.",
              "内容が圧縮されています(" + name + ")。先に展開してください。"};
    if (signature.bytes == gzip) {
      text.en = "The content is compressed (gzip); put .gz at the end of the name, or unpack it first.";
      text.ja = "内容が圧縮されています(gzip)。名前の末尾に .gz を付けるか、先に展開してください。";
    }
    return malformed("compressed_file", std::move(text), start);
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
  if (*first == '\0' && std::count_if(head.begin(), head.end(), is_control) == 1) return refuse_nul_bytes(head);
  return malformed(
      "binary_content",
      {"The content is binary, of no known mesh format.", "内容がバイナリーで、既知のメッシュ形式ではありません。"},
      FilePlace::at_byte(byte));
}

}  // namespace ryosen
