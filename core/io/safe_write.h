// Writes a file whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace ryosen {

// Puts `bytes` in the place of the file: written beside it, brought to the disk, then renamed, and the folder is
// brought to the disk too. Links are followed, the permissions of a file that is replaced stay; a device or pipe is
// written to directly. On failure (exit code output_not_writable) what was there before is unchanged and nothing new
// remains.
Status safe_write(const std::filesystem::path& path, std::string_view bytes);

}  // namespace ryosen
