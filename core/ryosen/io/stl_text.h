// Reader for ascii STL.
#pragma once

#include <string_view>

#include "ryosen/base/result.h"
#include "ryosen/io/face_list.h"
#include "ryosen/io/mesh_file.h"
#include "ryosen/io/reporter.h"

namespace ryosen {

// Whether `token` is this keyword, case-insensitively. `word` is in lower case.
bool is_stl_word(std::string_view token, std::string_view word);

Result<MeshFile> read_stl_text(std::string_view bytes);

// Quarantines the unusable faces, reports the welding and returns the file.
MeshFile finish_stl(MeshFile& file, FaceList& faces, Reporter& reporter);

}  // namespace ryosen
