#include "core/io/formats.h"

#include <algorithm>
#include <fstream>

#include "core/io/input_file.h"
#include "core/io/obj.h"
#include "core/io/off.h"
#include "core/io/ply.h"
#include "core/io/reporter.h"
#include "core/io/safe_write.h"
#include "core/io/sniff.h"
#include "core/io/stl.h"
#include "core/io/txt.h"

namespace ryosen {
namespace {

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

// Formats of meshes that the table has no row for, so that a file of theirs gets its own sentence.
bool is_unsupported_extension(std::string_view extension) {
  constexpr std::string_view known[] = {".glb", ".gltf", ".fbx", ".3mf", ".dae", ".3ds"};
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

const Format* looks_like(std::string_view bytes, Likeness wanted) {
  for (const Format& format : formats()) {
    if (format.sniff(bytes.substr(0, sniffed_bytes), bytes.size()) == wanted) return &format;
  }
  return nullptr;
}

constexpr Holds per_vertex_values = Holds::vertex_texcoords | Holds::vertex_normals | Holds::vertex_colours;

Holds obj_holds(Encoding) {
  return Holds::polygons | per_vertex_values | Holds::corner_texcoords | Holds::third_texcoord | Holds::corner_normals |
         Holds::groups | Holds::names | Holds::missing_colours | Holds::weights | Holds::elements | Holds::quarantine |
         Holds::any_vertex_colours | Holds::vertices | Holds::comments | Holds::doubles;
}

Holds off_holds(Encoding) {
  return Holds::polygons | per_vertex_values | Holds::missing_colours | Holds::face_colours | Holds::any_face_colours |
         Holds::quarantine | Holds::vertices | Holds::comments | Holds::doubles;
}

Holds ply_holds(Encoding) {
  return Holds::polygons | per_vertex_values | Holds::corner_texcoords | Holds::face_colours | Holds::quarantine |
         Holds::any_vertex_colours | Holds::vertices | Holds::properties | Holds::facet_attributes | Holds::comments |
         Holds::doubles;
}

Holds stl_holds(Encoding encoding) {
  const Holds both = Holds::flat_triangles;
  return encoding == Encoding::ascii ? both | Holds::groups | Holds::doubles | Holds::free_facets
                                     : both | Holds::facet_attributes | Holds::first_comment;
}

Holds txt_holds(Encoding) { return Holds::odd_triangles | Holds::vertices | Holds::doubles; }

}  // namespace

std::span<const Format> formats() {
  static const std::vector<Format> table = {
      {"obj",
       {"Wavefront OBJ", "Wavefront OBJ"},
       {".obj"},
       [](std::string_view head, std::uint64_t) { return looks_like_obj(head); },
       read_obj,
       [](const MeshFile& file, Encoding) { return write_obj(file); },
       obj_holds},
      {"ply",
       {"PLY (ascii, binary)", "PLY(テキスト、バイナリー)"},
       {".ply"},
       [](std::string_view head, std::uint64_t) { return looks_like_ply(head); },
       read_ply,
       write_ply,
       ply_holds,
       {{"ply-little", Encoding::binary_little}, {"ply-big", Encoding::binary_big}, {"ply-ascii", Encoding::ascii}}},
      {"off",
       {"OFF (COFF, NOFF, STOFF)", "OFF(COFF、NOFF、STOFF)"},
       {".off", ".coff", ".noff", ".stoff"},
       [](std::string_view head, std::uint64_t) { return looks_like_off(head); },
       read_off,
       [](const MeshFile& file, Encoding) { return write_off(file); },
       off_holds},
      {"stl",
       {"STL (ascii, binary)", "STL(テキスト、バイナリー)"},
       {".stl"},
       looks_like_stl,
       read_stl,
       write_stl,
       stl_holds,
       {{"stl-binary", Encoding::binary_little}, {"stl-ascii", Encoding::ascii}},
       false,
       true},
      {"txt",
       {"indexed triangle list", "三角形の番号リスト"},
       {".txt"},
       [](std::string_view head, std::uint64_t) { return looks_like_txt(head); },
       read_txt,
       [](const MeshFile& file, Encoding) { return write_txt(file); },
       txt_holds,
       {},
       true},
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

bool may_be_mesh(const std::filesystem::path& path) {
  const Format* const format = format_of_extension(path);
  if (!format || !format->shares_name) return format != nullptr;
  std::ifstream file(path, std::ios::binary);
  char head[64] = {};
  file.read(head, sizeof head);
  const std::string_view text(head, static_cast<std::size_t>(file.gcount()));
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && (text[begin] == '-' || (text[begin] >= '0' && text[begin] <= '9'));
}

Result<const Format*> recognise(std::string_view bytes, const std::filesystem::path& path) {
  const std::string_view head = bytes.substr(0, sniffed_bytes);
  if (auto refusal = refuse_before_sniffing(head)) return std::move(*refusal);
  const Format* const by_content = looks_like(bytes, Likeness::sure);
  const std::string extension = extension_of(path);
  if (is_unsupported_extension(extension)) return unsupported(extension, by_content);
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
  return safe_write(path, bytes_of(file, *format, options.encoding));
}

std::optional<WriteOptions> find_target(std::string_view id) {
  for (const Format& format : formats()) {
    if (format.id == id) return WriteOptions{&format, Encoding::automatic};
    for (const FormatVariant& variant : format.variants) {
      if (variant.id == id) return WriteOptions{&format, variant.encoding};
    }
  }
  return std::nullopt;
}

Encoding encoding_of(const MeshFile& file, const Format& format, Encoding wanted) {
  if (format.variants.empty()) return Encoding::automatic;
  // A format with one binary form takes that for any binary.
  const Encoding binary = file.encoding == Encoding::binary_big ? Encoding::binary_little : file.encoding;
  for (const Encoding encoding : {wanted, file.encoding, binary}) {
    for (const FormatVariant& variant : format.variants) {
      if (variant.encoding == encoding) return encoding;
    }
  }
  return format.variants[0].encoding;
}

std::string bytes_of(const MeshFile& file, const Format& format, Encoding wanted) {
  return format.write(file, encoding_of(file, format, wanted));
}

std::vector<Loss> losses_of(const MeshFile& file, const Format& format, Encoding wanted) {
  return find_losses(file, format.holds(encoding_of(file, format, wanted)));
}

Failure refusal_of_losses() {
  Failure failure;
  failure.exit_code = ExitCode::refused;
  failure.message.code = "refused";
  failure.message.text = {"Nothing was written: --strict allows none of these warnings.",
                          "何も書き出していません。--strict はこれらの警告を許しません。"};
  return failure;
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

}  // namespace ryosen
