// Reading of whole files into memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

#include "ryosen/base/result.h"

namespace ryosen {

struct FileBytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;

  std::string_view view() const { return {data.get(), size}; }
};

// Reads regular files, and pipes, the null device and a terminal inherited by the program (/dev/stdin, /dev/fd/N);
// other pipes, devices and sockets, which may block forever, are refused without waiting. Failures have the exit code
// input_missing and one of the codes input_missing, input_is_folder, input_not_a_file, input_unreadable.
Result<FileBytes> read_whole_file(const std::filesystem::path& path);

}  // namespace ryosen
