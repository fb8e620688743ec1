#include "core/io/formats.h"

#include <algorithm>

#include "core/io/input_file.h"
#include "core/io/obj.h"
#include "core/io/off.h"
#include "core/io/reporter.h"
#include "core/io/safe_write.h"
#include "core/io/sniff.h"

namespace ryosen {
namespace {

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

// Formats of meshes that the table has no row for, so that a file of theirs gets its own sentence.
bool is_unsupported_extension(std::string_view extension) {
  constexpr std::string_view known[] = {".stl", ".ply", ".glb", ".gltf", ".fbx", ".3mf", ".dae", ".3ds"};
  return std::find(std::begin(known), std::end(known), extension) != std::end(known) &&
         !format_of_extension(std::string("x") + std::string(extension));
}

Failure unsupported(const std::string& extension, const Format* looks_like) {
  Text text{"Files of the kind " + extension + " cannot be read.", extension + " 形式のファイルは読み込めません。"};
  if (looks_like) {
    text.en += " The content looks like " + looks_like->name.en + ".";
    text.ja += "内容は " + looks_like->name.ja + " のようです。";
  }
  return malformed("unsupported_format", std::move(text), FilePlace::at_byte(0));
}

const Format* looks_like(std::string_view head) {
  for (const Format& format : formats()) {
    if (format.sniff(head) == Likeness::sure) return &format;
  }
  return nullptr;
}

}  // namespace

std::span<const Format> formats() {
  static const std::vector<Format> table = {
      {"obj", {"Wavefront OBJ", "Wavefront OBJ"}, {".obj"}, looks_like_obj, read_obj, write_obj, obj_losses},
      {"off",
       {"OFF (COFF, NOFF, STOFF)", "OFF(COFF、NOFF、STOFF)"},
       {".off", ".coff", ".noff", ".stoff"},
       looks_like_off,
       read_off,
       write_off,
       off_losses},
  };
  return table;
}

const Format* find_format(std::string_view id) {
  const auto table = formats();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Format& format) { return format.id == id; });
  return found == table.end() ? nullptr : &*found;
}

const Format* format_of_extension(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  for (const Format& format : formats()) {
    if (std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end()) {
      return &format;
    }
  }
  return nullptr;
}

Result<const Format*> recognise(std::string_view bytes, const std::filesystem::path& path) {
  const std::string_view head = bytes.substr(0, sniffed_bytes);
  if (auto refusal = refuse_before_sniffing(head)) return std::move(*refusal);
  const Format* const by_content = looks_like(head);
  const std::string extension = extension_of(path);
  if (is_unsupported_extension(extension)) return unsupported(extension, by_content);
  if (by_content) return by_content;
  if (auto refusal = refuse_binary(head)) return std::move(*refusal);
  const Format* const by_extension = format_of_extension(path);
  if (by_extension) return by_extension;
  for (const Format& format : formats()) {
    if (format.sniff(head) == Likeness::maybe) return &format;
  }
  return malformed("unknown_format",
                   {"The content is of no known mesh format, and neither is the name.",
                    "内容からもファイル名からも、メッシュの形式を判別できません。"},
                   FilePlace::at_byte(0));
}

Result<MeshFile> read_mesh(std::string_view bytes, const Format& format, const std::filesystem::path& path) {
  if (auto refusal = refuse_before_sniffing(bytes.substr(0, sniffed_bytes))) return std::move(*refusal);
  Result<MeshFile> file = format.read(bytes, path);
  if (file) file->format = &format;
  return file;
}

Result<MeshFile> read_mesh_file(const std::filesystem::path& path) {
  Result<FileBytes> bytes = read_whole_file(path);
  if (!bytes) return std::move(bytes).failure();
  const Result<const Format*> format = recognise(bytes->view(), path);
  if (!format) return format.failure();
  Result<MeshFile> file = read_mesh(bytes->view(), **format, path);
  const Format* const by_name = format_of_extension(path);
  if (file && by_name && by_name != *format) {
    file->messages.insert(file->messages.begin(),
                          make_message(Severity::warning, "content_mismatch",
                                       {"The name says " + by_name->name.en + ", the content is " + (*format)->name.en +
                                            " and was read as that.",
                                        "名前は " + by_name->name.ja + " ですが、内容は " + (*format)->name.ja +
                                            " なので、そのように読みました。"}));
  }
  return file;
}

Status write_mesh_file(const std::filesystem::path& path, const MeshFile& file, const WriteOptions& options) {
  const Format* const format = options.format ? options.format : format_of_extension(path);
  if (!format || !format->write) {
    Message message;
    message.code = "unknown_format";
    message.text = {"The name " + path.string() + " does not say in which format to write.",
                    "ファイル名 " + path.string() + " からは、書き出す形式が決まりません。"};
    return Failure{ExitCode::usage, std::move(message)};
  }
  return safe_write(path, format->write(file));
}

}  // namespace ryosen
