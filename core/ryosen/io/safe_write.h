// Atomic writing of files, and what saves have begun to write, for whoever ends the program in the middle of one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/result.h"

namespace ryosen {

// Replaces the content of the file by `bytes`: written to a temporary file beside it, synced, renamed, and the folder
// synced too. Links are followed and the permissions of a replaced file are kept. A device, a pipe with a reader, and
// an inherited descriptor (/dev/stdout) are written directly, without these guarantees. If the process is killed at any
// moment, the file is completely old or completely new; the temporary file may be left as `.NAME.ryosen-PROCESS.N`. It
// is locked (flock) while it is written, and the next save of that file deletes those that nobody has locked.
//
// On failure (exit code output_not_writable) the old file is unchanged and no temporary file remains, with one
// exception: with the code output_not_durable the new file is in place, but syncing the folder failed (see
// is_in_place). A file system without sync support is not a failure.
Status safe_write(const std::filesystem::path& path, std::string_view bytes);

// The files that safe_write() has put in place in this process, as they were named, each once, in the order of their
// first time.
std::vector<std::string> files_put_in_place();

// The failure of a file that cannot be written, with this errno value.
Failure not_writable(const std::filesystem::path& path, int error);

// Whether the new file is in place: success, or the failure output_not_durable.
bool is_in_place(const Status& status);

// Deletes the temporary files of saves under way. May be called within a signal handler, while no section is under way.
void remove_unfinished_files() noexcept;

// Whether a pipe, a device or a descriptor that was handed over is being written, or was left in the middle.
bool is_stream_unfinished() noexcept;

// Whether a file has been written whole, and its name is in place, since the start or the last call of
// forget_what_is_written().
bool is_something_written() noexcept;
void forget_what_is_written() noexcept;

}  // namespace ryosen
