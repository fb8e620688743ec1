// The forms of the source texts for the mesh that is open, kept to look records up in them.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <thread>
#include <vector>

#include "app/editor/document.h"
#include "core/forms/records.h"

namespace ryosen {

// All forms are built once for a revision of a document, from a copy of its mesh.
class RecordBook {
 public:
  RecordBook() = default;
  ~RecordBook() { wait(); }
  RecordBook(const RecordBook&) = delete;
  RecordBook& operator=(const RecordBook&) = delete;

  // Begins to build them as the document is now, on a thread of its own where one is to be had.
  void begin(const Document& document);
  // Whether that is what was begun last.
  bool is_of(const Document& document) const {
    return is_begun_ && serial_ == document.serial() && revision_ == document.revision();
  }
  bool is_ready() const { return is_begun_ && is_done_; }
  void wait() {
    if (thread_.joinable()) thread_.join();
  }
  // In the order of all_forms(); it must be ready. Throws what was thrown when they were built.
  std::span<const forms::Records> records() const;

 private:
  void build(const Mesh& mesh);

  bool is_begun_ = false;
  std::uint64_t serial_ = 0, revision_ = 0;
  std::vector<forms::Records> records_;
  std::exception_ptr thrown_;
  std::atomic<bool> is_done_ = false;
  std::thread thread_;
};

}  // namespace ryosen
