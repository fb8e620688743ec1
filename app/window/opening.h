// A file that is read on a thread of its own, while the window says so.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <memory>

#include "ryosen/document/document.h"

namespace ryosen {

class Opening {
 public:
  explicit Opening(std::filesystem::path file);
  // Ends it before its time, and waits for that.
  ~Opening();
  Opening(const Opening&) = delete;
  Opening& operator=(const Opening&) = delete;

  // Whether it is, or becomes so within a time.
  bool is_done(std::chrono::milliseconds within) const { return found_.wait_for(within) == std::future_status::ready; }
  // Waits for it. Once.
  Result<std::unique_ptr<Document>> take() { return found_.get(); }
  // Nobody wants it any more: it ends as soon as it can, and nobody may take it.
  void give_up() { is_unwanted_ = true; }
  // What is being done: the file, and how large it is.
  Text told() const;

 private:
  std::filesystem::path file_;
  std::uintmax_t bytes_ = 0;
  std::atomic<bool> is_unwanted_ = false;
  std::future<Result<std::unique_ptr<Document>>> found_;
};

}  // namespace ryosen
