#include "app/opening.h"

#include <cstdio>
#include <utility>

#include "core/base/interruption.h"

namespace ryosen {

namespace {

std::uintmax_t bytes_of(const std::filesystem::path& file) {
  std::error_code fault;
  const std::uintmax_t bytes =
      std::filesystem::is_regular_file(file, fault) ? std::filesystem::file_size(file, fault) : 0;
  return fault ? 0 : bytes;
}

}  // namespace

Opening::Opening(std::filesystem::path file) : file_(std::move(file)), bytes_(bytes_of(file_)) {
  found_ = std::async(std::launch::async, [this] {
    const Interruptible while_wanted(&is_unwanted_);
    return Document::open(file_);
  });
}

Opening::~Opening() {
  is_unwanted_ = true;
  if (found_.valid()) found_.wait();
}

Text Opening::told() const {
  char size[32];
  std::snprintf(size, sizeof size, "%.1f MB", static_cast<double>(bytes_) / 1e6);
  const std::string name = file_.filename().string();
  return {"Reading " + name + ", " + size, name + " を読み込み中（" + size + "）"};
}

bool is_long_to_open(const std::filesystem::path& file) { return bytes_of(file) > 1000000; }

}  // namespace ryosen
