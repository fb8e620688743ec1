// A row of the table of file formats: all that the program knows of a format.
#pragma once

#include <cstdint>
#include <filesystem>
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
  // The bytes of the file, and what a file in this encoding can hold; both null if the format is only read.
  std::string (*write)(const MeshFile& file, Encoding encoding) = nullptr;
  Holds (*holds)(Encoding encoding) = nullptr;
  std::vector<FormatVariant> variants = {};  // empty where there is one encoding alone; else the usual one first
  bool shares_name = false;                  // files of this name are often no meshes; see may_be_mesh
  bool is_name_binding = false;  // a file of this name with the content of another format is refused, not read as that
};

inline constexpr std::size_t sniffed_bytes = 4096;

}  // namespace ryosen
