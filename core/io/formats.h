// The table of file formats, and reading and writing through it. A new format is one pair of files and one row.
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/format.h"

namespace ryosen {

// The rows, those of the program first. A row stays where it is for as long as it is there.
const std::deque<Format>& formats();

// Adds a row for as long as it lives: for programs that bring a format of their own, and for tests. Rows go in the
// opposite order of their coming, and neither while another thread asks the table nor before the files read with them.
class AddedFormat {
 public:
  explicit AddedFormat(Format format);  // its id must be new
  ~AddedFormat();
  AddedFormat(const AddedFormat&) = delete;
  AddedFormat& operator=(const AddedFormat&) = delete;

  const Format& row() const { return *row_; }

 private:
  const Format* row_;
};
// By id or by the extension of a path (in any case, that before .gz where it ends so); null if there is none.
const Format* find_format(std::string_view id);
const Format* format_of_extension(const std::filesystem::path& path);
// Whether files with this extension are meshes of a well-known format that has no row.
bool is_unread_extension(std::string_view extension);

// Whether a file found in a folder is to be taken for a mesh by its name; where the name is that of texts too, only if
// it, or what is packed in it, begins with a number.
bool may_be_mesh(const std::filesystem::path& path);

// The format of a file by its content (unpacked), else by its extension. Refuses, each with its own code, files that
// are empty (empty_file), compressed (compressed_file), UTF-16 (utf16), full of zeros (zeros), binary of no known kind
// (binary_content), of a known format that cannot be read (unsupported_format), or of none (unknown_format).
Result<const Format*> recognise(std::string_view bytes, const std::filesystem::path& path);

// Reads the file at `path`, once. Bytes packed with gzip are unpacked where the name ends in .gz or says no format; the
// places in messages are then those of what is packed. A path that is missing, unreadable or a folder fails with exit
// code input_missing, content that cannot be read with input_malformed. MeshFile::format is set, warnings are in
// MeshFile::messages. `taken_for` gets the format that a file, also a refused one, was taken for; null where none.
Result<MeshFile> read_mesh_file(const std::filesystem::path& path, const Format** taken_for = nullptr);

// The same for bytes of a known format; `path` may be empty.
Result<MeshFile> read_mesh(std::string_view bytes, const Format& format, const std::filesystem::path& path = {});

struct WriteOptions {
  const Format* format = nullptr;           // null: by the name of the path
  Encoding encoding = Encoding::automatic;  // automatic: as the file was read, if the format knows that encoding
};

// By the id of a format or of a variant.
std::optional<WriteOptions> find_target(std::string_view id);
// The encoding in which the file would be written; automatic for formats with one alone.
Encoding encoding_of(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);
// The bytes of a file in a format that can be written.
std::string bytes_of(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);
// What would be lost in a format that can be written; empty where nothing.
std::vector<Loss> losses_of(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);
// Why nothing is written where these warnings are not allowed.
Failure refusal_of_losses();
// The warnings of the losses, and one about the vertices that are written although they were removed from the mesh.
std::vector<Message> loss_messages(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);

// Why a file of this name cannot be written in this format, which is null where the name says none: it is not known, or
// only read (exit code usage, code unknown_format).
std::optional<Failure> refusal_of_target(const std::filesystem::path& path, const Format* format);

// Writes the file whole or not at all (see safe_write), where refusal_of_target allows it; packed with gzip where the
// name ends in .gz.
Status write_mesh_file(const std::filesystem::path& path, const MeshFile& file, const WriteOptions& options = {});

}  // namespace ryosen
