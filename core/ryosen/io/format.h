// A row of the table of file formats (format_table.cpp): all facts about a format. A small one to begin from is txt;
// one that is only read is xyz.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/result.h"
#include "ryosen/io/losses.h"
#include "ryosen/io/mesh_file.h"

namespace ryosen {

// How well the first bytes of a file match a format.
enum class Likeness { no, maybe, sure };

// An id for writing a format in one of several encodings.
struct FormatVariant {
  std::string_view id;  // for --format
  Encoding encoding;
};

struct Format {
  std::string_view id;                       // stable, for --format and JSON
  Text name;                                 // for menus and help
  std::vector<std::string_view> extensions;  // lower case with the dot; the first is the default
  // Gets at most sniffed_bytes, and the size of the file. The first row that is sure gets the file, else the format of
  // its name, else the first row that may be. Nobody asks where the content is packed, UTF-16 or empty: formats.cpp
  // refuses that before (refuse_before_sniffing()), where a format inside of an archive has to be let through.
  Likeness (*sniff)(std::string_view head, std::uint64_t size);
  Result<MeshFile> (*read)(std::string_view bytes, const std::filesystem::path& path);
  // Serialises the file; null where the format is read-only.
  std::string (*write)(const MeshFile& file, Encoding encoding) = nullptr;
  // What a file in this encoding can hold; null where the format is read-only.
  Holds (*holds)(Encoding encoding) = nullptr;
  std::vector<FormatVariant> variants = {};  // empty if there is only one encoding; else the default first
  bool shares_name = false;                  // files with this extension are often not meshes; see may_be_mesh
  bool is_name_binding = false;              // a file with this extension but the content of another format is refused
  bool may_be_empty = false;                 // a file of this name without a byte is one without elements
};

inline constexpr std::size_t sniffed_bytes = 4096;

}  // namespace ryosen
