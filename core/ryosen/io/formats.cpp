#include "ryosen/io/formats.h"

#include <algorithm>
#include <cassert>
#include <fstream>

#include "ryosen/base/interruption.h"
#include "ryosen/base/open_table.h"
#include "ryosen/base/rows.h"
#include "ryosen/io/file_target.h"
#include "ryosen/io/gzip.h"
#include "ryosen/io/input_file.h"
#include "ryosen/io/numbers.h"
#include "ryosen/io/reporter.h"
#include "ryosen/io/safe_write.h"
#include "ryosen/io/system_reason.h"

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

// The failure for a file that cannot be any mesh format: empty, compressed, UTF-16, or starting with only zeros.
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

// The failure for non-text content that was not recognised as a binary format.
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

// The extension, before any .gz.
std::string extension_of(const std::filesystem::path& path) {
  std::string extension = without_gzip(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), lower_case);
  return extension;
}

Failure unsupported(const std::string& extension, const Format* looks_like) {
  Text text{"Files of the kind " + extension + " cannot be read.", extension + " 形式のファイルは読み込めません。"};
  if (looks_like) {
    text.en += " The content looks like " + looks_like->name.en + ".";
    text.ja += "内容は " + looks_like->name.ja + " のようです。";
  }
  return malformed("unsupported_format", std::move(text), FilePlace::at_byte(0));
}

const Format* looks_like(std::string_view bytes, Likeness wanted) {
  for (const Format& format : formats())
    if (format.sniff(bytes.substr(0, sniffed_bytes), bytes.size()) == wanted) return &format;
  return nullptr;
}

}  // namespace

const Format* find_format(std::string_view id) { return find_row(formats(), id); }

const Format* format_of_extension(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  for (const Format& format : formats())
    if (std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end())
      return &format;
  return nullptr;
}

const Format* format_to_write(const std::filesystem::path& path, const MeshFile& source) {
  const Format* const format = format_of_extension(path);
  return format || !is_stream(path) ? format : source.format;
}

bool may_be_mesh(const std::filesystem::path& path) {
  const Format* const format = format_of_extension(path);
  if (!format || !format->shares_name) return format != nullptr;
  std::ifstream file(path, std::ios::binary);
  char head[512] = {};
  file.read(head, sizeof head);
  std::string text(head, static_cast<std::size_t>(file.gcount()));
  if (is_gzip(text)) text = unpacked_head(text, 64);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && (text[begin] == '-' || is_digit(text[begin]));
}

Result<const Format*> recognise(std::string_view bytes, const std::filesystem::path& path) {
  const std::string_view head = bytes.substr(0, sniffed_bytes);
  if (const Format* const named = format_of_extension(path); bytes.empty() && named && named->may_be_empty)
    return named;
  if (auto refusal = refuse_before_sniffing(head)) return std::move(*refusal);
  const Format* const by_content = looks_like(bytes, Likeness::sure);
  const std::string extension = extension_of(path);
  if (is_unread_extension(extension)) return unsupported(extension, by_content);
  const Format* const by_extension = format_of_extension(path);
  if (by_content && by_extension && by_content != by_extension && by_extension->is_name_binding) {
    return malformed("content_mismatch",
                     {"The name says " + by_extension->name.en + ", the content looks like " + by_content->name.en +
                          "; rename the file to read it.",
                      "名前は " + by_extension->name.ja + " ですが、内容は " + by_content->name.ja +
                          " のようです。ファイル名を直してください。"},
                     FilePlace::at_byte(0));
  }
  if (by_content) return by_content;
  const bool may_be = by_extension && by_extension->sniff(head, bytes.size()) != Likeness::no;
  if (!may_be) {
    if (auto refusal = refuse_binary(head)) return std::move(*refusal);
  }
  if (by_extension) return by_extension;
  if (const Format* const possible = looks_like(bytes, Likeness::maybe)) return possible;
  return malformed("unknown_format",
                   {"The content is of no known mesh format, and neither is the name.",
                    "内容からもファイル名からも、メッシュの形式を判別できません。"},
                   FilePlace::at_byte(0));
}

Result<MeshFile> read_mesh(std::string_view bytes, const Format& format, const std::filesystem::path& path) {
  if (!(bytes.empty() && format.may_be_empty))
    if (auto refusal = refuse_before_sniffing(bytes.substr(0, sniffed_bytes))) return std::move(*refusal);
  Result<MeshFile> file = format.read(bytes, path);
  if (file) file->format = &format;
  return file;
}

namespace {

// The bytes, unpacked if the name ends in .gz or has no known extension.
Result<FileBytes> unpacked(FileBytes bytes, const std::filesystem::path& path) {
  if (!is_gzip(bytes.view()) || (!has_gzip_name(path) && format_of_extension(path))) return bytes;
  Result<FileBytes> out = unpack_gzip(bytes.view());
  if (out && is_gzip(out->view())) {
    return malformed("compressed_twice",
                     {"The content of the gzip file is packed with gzip once more; unpack it first.",
                      "gzip ファイルの中身がさらに gzip で圧縮されています。先に展開してください。"},
                     FilePlace::at_byte(0));
  }
  return out;
}

void say_first(MeshFile& file, Text text) {
  file.messages.insert(file.messages.begin(), make_message(Severity::warning, "content_mismatch", std::move(text)));
}

}  // namespace

Result<MeshFile> read_mesh_file(const std::filesystem::path& path, const Format** taken_for) {
  if (taken_for) *taken_for = nullptr;
  Result<FileBytes> whole = read_whole_file(path);
  if (!whole) return std::move(whole).failure();
  stop_if_interrupted();
  const bool is_misnamed = has_gzip_name(path) && !whole->view().empty() && !is_gzip(whole->view());
  const Result<FileBytes> bytes = unpacked(std::move(whole).value(), path);
  if (!bytes) return bytes.failure();
  const Result<const Format*> format = recognise(bytes->view(), path);
  if (!format) return format.failure();
  if (taken_for) *taken_for = *format;
  stop_if_interrupted();
  Result<MeshFile> file = read_mesh(bytes->view(), **format, path);
  stop_if_interrupted();
  if (!file) return file;
  const Format* const by_name = format_of_extension(path);
  if (by_name && by_name != *format) {
    say_first(
        *file,
        {"The name says " + by_name->name.en + ", the content is " + (*format)->name.en + " and was read as that.",
         "名前は " + by_name->name.ja + " ですが、内容は " + (*format)->name.ja + " なので、そのように読みました。"});
  }
  if (is_misnamed) {
    say_first(*file, {"The name says gzip, the content is not packed and was read as it is.",
                      "名前は gzip ですが、内容は圧縮されていないので、そのまま読みました。"});
  }
  return file;
}

namespace {

// ".obj, .off, ..."
std::string endings_that_are_written() {
  std::string endings;
  for (const Format& format : formats())
    if (format.write && !format.extensions.empty())
      endings += (endings.empty() ? "" : ", ") + std::string(format.extensions.front());
  return endings;
}

}  // namespace

std::optional<Failure> refusal_of_target(const std::filesystem::path& path, const Format* format) {
  if (format && format->write) return std::nullopt;
  Message message;
  message.code = "unknown_format";
  if (format) {
    message.text = {
        "Files of the format " + format->name.en + " are only read, not written: " + path.string() +
            ". Choose another format.",
        format->name.ja + " 形式は読み込みだけで、書き出せません(" + path.string() + ")。別の形式を選んでください。"};
  } else if (path.empty()) {
    message.text = empty_name();
  } else {
    const std::string written = endings_that_are_written();
    message.text = {
        "The name " + path.string() + " does not say in which format to write: it may end in " + written + ".",
        "ファイル名 " + path.string() + " からは、書き出す形式が決まりません（" + written + "）。"};
  }
  return Failure{ExitCode::usage, std::move(message)};
}

Status write_mesh_file(const std::filesystem::path& path, const MeshFile& file, const WriteOptions& options) {
  const Format* const format = options.format ? options.format : format_of_extension(path);
  if (std::optional<Failure> refusal = refusal_of_target(path, format)) return std::move(*refusal);
  std::string bytes = bytes_of(file, *format, options.encoding);
  if (has_gzip_name(path)) bytes = pack_gzip(bytes);
  return safe_write(path, bytes);
}

std::optional<WriteOptions> find_target(std::string_view id) {
  for (const Format& format : formats()) {
    if (format.id == id) return WriteOptions{&format, Encoding::automatic};
    for (const FormatVariant& variant : format.variants)
      if (variant.id == id) return WriteOptions{&format, variant.encoding};
  }
  return std::nullopt;
}

Encoding encoding_of(const MeshFile& file, const Format& format, Encoding wanted) {
  if (format.variants.empty()) return Encoding::automatic;
  // A format with a single binary encoding uses it for either byte order.
  const Encoding binary = file.encoding == Encoding::binary_big ? Encoding::binary_little : file.encoding;
  for (const Encoding encoding : {wanted, file.encoding, binary}) {
    for (const FormatVariant& variant : format.variants)
      if (variant.encoding == encoding) return encoding;
  }
  return format.variants[0].encoding;
}

std::string bytes_of(const MeshFile& file, const Format& format, Encoding wanted) {
  assert(format.write);
  return format.write(file, encoding_of(file, format, wanted));
}

std::vector<Loss> losses_of(const MeshFile& file, const Format& format, Encoding wanted) {
  assert(format.holds);
  return find_losses(file, format.holds(encoding_of(file, format, wanted)));
}

Failure refusal_of_losses() {
  return make_failure(ExitCode::refused, "refused",
                      {"Nothing was written: --strict allows none of these warnings.",
                       "何も書き出していません。--strict はこれらの警告を許しません。"});
}

std::vector<Message> loss_messages(const MeshFile& file, const Format& format, Encoding wanted) {
  std::vector<Message> messages;
  for (const Loss& loss : losses_of(file, format, wanted)) messages.push_back(loss.message(format.name));
  if (file.kept_vertices == 0 || !holds(format.holds(encoding_of(file, format, wanted)), Holds::vertices))
    return messages;
  const std::string count = std::to_string(file.kept_vertices);
  const bool one = file.kept_vertices == 1;
  messages.push_back(
      make_message(Severity::warning, "keeps_vertices",
                   {(one ? "One vertex that was removed stays" : count + " vertices that were removed stay") +
                        std::string(" in the file, at its last place and without a face: a face set aside, ") +
                        "a line, a point or an edge of the file uses " + (one ? "it." : "them."),
                    "削除した頂点のうち " + count +
                        " 個は、隔離された面・線・点・稜線の要素が使うため、面のない頂点としてファイルに残ります。"}));
  return messages;
}

std::vector<Message> give_up_lost_elements(MeshFile& file, const Format& format, Encoding wanted) {
  if (!format.holds) return {};
  const Encoding encoding = encoding_of(file, format, wanted);
  const Holds held = format.holds(encoding);
  const auto is_other = [](const PropertyTable& table) { return table.is_further(); };
  const std::vector<PropertyTable>& tables = file.properties.tables;
  const bool loses_elements = !holds(held, Holds::elements) && !file.elements.items.empty();
  const bool loses_tables = !holds(held, Holds::properties) && std::any_of(tables.begin(), tables.end(), is_other);
  if (!loses_elements && !loses_tables) return {};
  const std::vector<Loss> before = losses_of(file, format, encoding);
  if (loses_elements) file.elements = {};
  if (loses_tables) std::erase_if(file.properties.tables, is_other);
  const std::vector<Loss> after = losses_of(file, format, encoding);
  std::vector<Message> messages;
  for (const Loss& loss : before)
    if (std::none_of(after.begin(), after.end(),
                     [&](const Loss& left) { return left.kind == loss.kind && left.count == loss.count; }))
      messages.push_back(loss.message(format.name));
  return messages;
}

bool gives_back_others(const MeshFile& file, const Format& format) {
  return format.holds && !holds(format.holds(encoding_of(file, format)), Holds::vertices);
}

MeshFile given_back(MeshFile file, const Format& format) {
  if (!gives_back_others(file, format)) return file;
  Result<MeshFile> read = read_mesh(bytes_of(file, format), format);
  return read ? std::move(read).value() : std::move(file);
}

}  // namespace ryosen
