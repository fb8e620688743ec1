#include "app/window/opening.h"

#include <cstdio>
#include <utility>

#include "app/editor/document/large_files.h"
#include "ryosen/base/interruption.h"

namespace ryosen {

Opening::Opening(std::filesystem::path file) : file_(std::move(file)), bytes_(bytes_of_plain_file(file_)) {
  found_ = std::async(std::launch::async, [this] {
    const Interruptible while_wanted(&is_unwanted_);
    return Document::open(file_);
  });
}

Opening::~Opening() {
  give_up();
  if (found_.valid()) found_.wait();
}

Text Opening::told() const {
  char size[32];
  std::snprintf(size, sizeof size, "%.1f MB", static_cast<double>(bytes_) / 1e6);
  const std::string name = file_.filename().string();
  return {"Reading " + name + ", " + size, name + " を読み込み中（" + size + "）"};
}

}  // namespace ryosen
