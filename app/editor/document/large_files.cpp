#include "app/editor/document/large_files.h"

#include <system_error>

namespace ryosen {

std::uintmax_t bytes_of_plain_file(const std::filesystem::path& file) {
  std::error_code fault;
  const std::uintmax_t bytes =
      std::filesystem::is_regular_file(file, fault) ? std::filesystem::file_size(file, fault) : 0;
  return fault ? 0 : bytes;
}

bool is_long_to_read(const std::filesystem::path& file) { return bytes_of_plain_file(file) > 1000000; }

}  // namespace ryosen
