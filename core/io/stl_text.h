// The ascii form of STL.
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/io/face_list.h"
#include "core/io/mesh_file.h"
#include "core/io/reporter.h"

namespace ryosen {

// Whether `token` is this word of the format, in any case. `word` is in lower case.
bool is_stl_word(std::string_view token, std::string_view word);

Result<MeshFile> read_stl_text(std::string_view bytes);

// Sets the unusable faces aside, tells of the welding and hands the file over.
MeshFile finish_stl(MeshFile& file, FaceList& faces, Reporter& reporter);

}  // namespace ryosen
