#include "ryosen/io/unfinished_files.h"

#include <unistd.h>

#include <array>
#include <atomic>

namespace ryosen {
namespace {

std::array<std::atomic<const char*>, 8> unfinished_paths{};
std::atomic<bool> is_file_in_place = false;
std::atomic<bool> is_stream_begun = false;

}  // namespace

UnfinishedFile::UnfinishedFile(const char* path) noexcept : place_(0) {
  for (; place_ < unfinished_paths.size(); ++place_) {
    const char* none = nullptr;
    if (unfinished_paths[place_].compare_exchange_strong(none, path)) return;
  }
}

UnfinishedFile::~UnfinishedFile() {
  if (place_ < unfinished_paths.size()) unfinished_paths[place_] = nullptr;
}

void remove_unfinished_files() noexcept {
  for (const auto& listed : unfinished_paths)
    if (const char* const path = listed) ::unlink(path);
}

bool is_something_written() noexcept { return is_file_in_place; }
bool is_stream_unfinished() noexcept { return is_stream_begun; }
void note_begun_stream() noexcept { is_stream_begun = true; }

void note_what_is_written() noexcept {
  is_file_in_place = true;
  is_stream_begun = false;
}

void forget_what_is_written() noexcept { is_file_in_place = false; }

}  // namespace ryosen
