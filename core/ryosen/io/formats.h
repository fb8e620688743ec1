// The table of file formats, and reading and writing through it. To add a format, write a pair of files and a row.
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/io/format.h"

namespace ryosen {

// The rows, built-in ones first. Addresses are stable while a row exists.
const std::deque<Format>& formats();

// Adds a row during its lifetime: for programs with a format of their own, and for tests. Destroy in reverse order of
// construction, not while another thread uses the table, and after all files read with it.
class ScopedFormat {
 public:
  explicit ScopedFormat(Format format);  // its id must be unique
  ~ScopedFormat();
  ScopedFormat(const ScopedFormat&) = delete;
  ScopedFormat& operator=(const ScopedFormat&) = delete;

  const Format& row() const { return *row_; }

 private:
  const Format* row_;
};
// By id, or by the extension of a path (case-insensitive, before any .gz); null if there is none.
const Format* find_format(std::string_view id);
const Format* format_of_extension(const std::filesystem::path& path);
// That of a file to be written; a pipe or device (is_stream) gets the format of the source where its name says none.
const Format* format_to_write(const std::filesystem::path& path, const MeshFile& source);
// Whether the extension belongs to a well-known mesh format that is not supported.
bool is_unread_extension(std::string_view extension);

// Whether to treat a file found in a folder as a mesh, by its extension; if that is also used for plain text, only if
// its (unpacked) content starts with a number.
bool may_be_mesh(const std::filesystem::path& path);

// The format of a file by its content (unpacked), else by its extension. Fails, each with its own code, for files that
// are empty (empty_file), compressed (compressed_file), UTF-16 (utf16), all zeros (zeros), unknown binary
// (binary_content), of a known unsupported format (unsupported_format), or of no known format (unknown_format).
Result<const Format*> recognise(std::string_view bytes, const std::filesystem::path& path);

// Reads the file at `path`, once. gzip is unpacked if the name ends in .gz or has no known extension; places in
// messages then refer to the unpacked content. A path that is missing, unreadable or a folder fails with exit code
// input_missing, content that cannot be read with input_malformed. MeshFile::format is set, warnings are in
// MeshFile::messages. `taken_for` receives the detected format, even if reading fails; null if none.
Result<MeshFile> read_mesh_file(const std::filesystem::path& path, const Format** taken_for = nullptr);

// The same for bytes of a known format; `path` may be empty.
Result<MeshFile> read_mesh(std::string_view bytes, const Format& format, const std::filesystem::path& path = {});

struct WriteOptions {
  const Format* format = nullptr;           // null: by the extension of the path
  Encoding encoding = Encoding::automatic;  // automatic: as read, if the format supports that encoding
};

// By the id of a format or of a variant.
std::optional<WriteOptions> find_target(std::string_view id);
// The encoding in which the file would be written; automatic for formats with only one.
Encoding encoding_of(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);
// Serialises a file in a writable format.
std::string bytes_of(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);
// What would be lost in a writable format; empty if nothing.
std::vector<Loss> losses_of(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);
// The failure if these warnings are not allowed (--strict).
Failure refusal_of_losses();
// Warnings about the losses, and one about vertices that are written although they were removed from the mesh.
std::vector<Message> loss_messages(const MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);

// Whether a file in a writable format may give back other vertices and faces than were written: one without a list of
// vertices makes one of those at one place.
bool gives_back_others(const MeshFile& file, const Format& format);
// The file as writing it and reading it again gives it; itself where that gives the same vertices and faces. Cost: that
// of both.
MeshFile given_back(MeshFile file, const Format& format);

// Takes away what uses vertices beside the faces and cannot be held by the format: lines and points, elements such as
// the edges of PLY. What counts on the file then counts as on the one to be written. Returns the warnings about them.
std::vector<Message> give_up_lost_elements(MeshFile& file, const Format& format, Encoding wanted = Encoding::automatic);

// Why a file of this name cannot be written in this format (null if the extension is unknown): unknown or read-only
// format (exit code usage, code unknown_format).
std::optional<Failure> refusal_of_target(const std::filesystem::path& path, const Format* format);

// Writes the file atomically (see safe_write), unless refusal_of_target refuses; gzipped if the name ends in .gz.
Status write_mesh_file(const std::filesystem::path& path, const MeshFile& file, const WriteOptions& options = {});

}  // namespace ryosen
