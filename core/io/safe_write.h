// Atomic writing of files.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace ryosen {

// Puts `bytes` in the place of the file: written beside it, brought to the disk, then renamed, and the folder is
// brought to the disk too. Links are followed, the permissions of a file that is replaced stay. A device, a pipe that
// somebody reads, and what a descriptor is of that the program was handed (/dev/stdout) are written to instead; there the
// rest does not hold. Whatever moment the process is killed at, there is the whole old or the whole new file; what it
// had written beside stays then as `.NAME.PROCESS.N`, which nobody reads.
//
// On failure (exit code output_not_writable) the old file is unchanged and no temporary file remains, with one
// exception: with the code output_not_durable the new file is in place, but syncing the folder failed (see
// is_in_place). A file system without sync support is not a failure.
Status safe_write(const std::filesystem::path& path, std::string_view bytes);

// Whether the new file is in place: success, or the failure output_not_durable.
bool is_in_place(const Status& status);

}  // namespace ryosen
