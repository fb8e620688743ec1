// The table of file formats, and reading and writing through it. A new format is one pair of files and one row.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/io/losses.h"
#include "core/io/mesh_file.h"

namespace ryosen {

// How much the first bytes of a file look like a format.
enum class Likeness { no, maybe, sure };

// A name under which a format is written in one of several encodings.
struct FormatVariant {
  std::string_view id;  // for --format
  Encoding encoding;
};

struct Format {
  std::string_view id;                       // stable, for --format and JSON
  Text name;                                 // for menus and help
  std::vector<std::string_view> extensions;  // lower case with the dot; the first is the usual one
  // Gets at most sniffed_bytes, and how many bytes the file has.
  Likeness (*sniff)(std::string_view head, std::uint64_t size);
  Result<MeshFile> (*read)(std::string_view bytes, const std::filesystem::path& path);
  // The bytes of the file; null if the format is only read.
  std::string (*write)(const MeshFile& file, Encoding encoding);
  Holds (*holds)(Encoding encoding);         // what a file in this encoding can hold
  std::vector<FormatVariant> variants = {};  // empty where there is one encoding alone; else the usual one first
  bool shares_name = false;                  // files of this name are often no meshes; see may_be_mesh
  bool is_name_binding = false;  // a file of this name with the content of another format is refused, not read as that
};

inline constexpr std::size_t sniffed_bytes = 4096;

std::span<const Format> formats();
// By id or by the extension of a path (in any case); null if there is none.
const Format* find_format(std::string_view id);
const Format* format_of_extension(const std::filesystem::path& path);

// Whether a file found in a folder is to be taken for a mesh by its name; where the name is that of texts too, only if
// it begins with a number.
bool may_be_mesh(const std::filesystem::path& path);

// The format of a file by its content, else by its extension. Refuses, each with its own code, files that are empty
// (empty_file), compressed (compressed_file), UTF-16 (utf16), full of zeros (zeros), binary of no known kind
// (binary_content), of a known format that cannot be read (unsupported_format), or of none (unknown_format).
Result<const Format*> recognise(std::string_view bytes, const std::filesystem::path& path);

// Reads the file at `path`. A path that is missing, unreadable or a folder fails with exit code input_missing, content
// that cannot be read with input_malformed. MeshFile::format is set, warnings are in MeshFile::messages.
Result<MeshFile> read_mesh_file(const std::filesystem::path& path);

// The same for bytes of a known format; `path` may be empty.
Result<MeshFile> read_mesh(std::string_view bytes, const Format& format, const std::filesystem::path& path = {});

struct WriteOptions {
  const Format* format = nullptr;           // null: by the extension of the path
  Encoding encoding = Encoding::automatic;  // automatic: as the file was read, if the format knows that encoding
};

// By the id of a format or of a variant.
std::optional<WriteOptions> find_target(std::string_view id);
// The encoding in which the file would be written; automatic for formats with one alone.
Encoding encoding_of(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);
// The bytes of a file in a format that can be written.
std::string bytes_of(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);
// What would be lost; empty where nothing.
std::vector<Loss> losses_of(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);
// Why nothing is written where these warnings are not allowed.
Failure refusal_of_losses();
// The warnings of the losses, and one about the vertices that are written although they were removed from the mesh.
std::vector<Message> loss_messages(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);

// Writes the file whole or not at all (see safe_write). An extension of no format in the table that can be written is a
// failure with exit code usage and code unknown_format.
Status write_mesh_file(const std::filesystem::path& path, const MeshFile& file, const WriteOptions& options = {});

}  // namespace ryosen
