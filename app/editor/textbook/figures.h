// The meshes of the source texts' figures: the files in assets/figures, which are part of the program, each with where
// it stands in the texts and how it was found again where its picture is lost.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ryosen/base/message.h"
#include "ryosen/base/result.h"
#include "ryosen/io/mesh_file.h"

namespace ryosen {

struct Figure {
  std::string_view id;  // of the text and of the figure in it: 000-4b
  std::string_view name_en, name_ja;
  std::string_view found_en, found_ja;  // how
};

// In the order of the texts.
std::span<const Figure> figures();
const Figure* find_figure(std::string_view id);
// "000-3|000-4a|...".
std::string figure_ids();
// Its mesh, as it is in the file.
Result<MeshFile> mesh_of_figure(const Figure& figure);

// A file of assets/figures: the name of its format and its bytes.
struct FigureFile {
  std::string_view id, format, bytes;
};
std::span<const FigureFile> figure_files();

}  // namespace ryosen
