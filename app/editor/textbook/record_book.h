// The forms of the source texts for the mesh that is open, kept to look records up in them.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "ryosen/document/document.h"
#include "ryosen/textbook/forms/records.h"

namespace ryosen {

// All forms of a revision of a document are built beside the frames, from a copy of its mesh: once, and only for the
// last revision that was asked for. Nothing here waits but wait_for() and the end, where a thread is to be had.
class RecordBook {
 public:
  // Begins work on a thread of its own; throws std::system_error where there is none to be had.
  using Start = std::function<std::thread(std::function<void()> work)>;

  RecordBook() = default;
  explicit RecordBook(Start start) : start_(std::move(start)) {}
  ~RecordBook();
  RecordBook(const RecordBook&) = delete;
  RecordBook& operator=(const RecordBook&) = delete;

  // Asks for those of the document as it is now: begins to build them, or lets what is built for an older revision end
  // first, which it does between two forms. Call it in each frame that wants them.
  void ask(const Document& document);
  // Whether those were asked for last.
  bool is_of(const Document& document) const {
    return is_asked_ && serial_ == document.serial() && revision_ == document.revision();
  }
  bool is_ready() const { return is_asked_ && built_ && built_->is_of(serial_, revision_) && built_->is_whole(); }
  // Asks, and waits until they are there.
  void wait_for(const Document& document);
  // In the order of all_forms(); they must be ready. Throws what was thrown when they were built.
  std::span<const forms::Records> records() const;
  // Nobody wants them any more: ends what goes on and gives back the memory, beside the frames. Call it again in the
  // next frame while it is false.
  bool rest();

 private:
  struct Build {
    std::uint64_t serial, revision;
    std::vector<forms::Records> records;
    std::exception_ptr thrown;
    std::atomic<bool> is_done = false, is_cancelled = false;

    bool is_of(std::uint64_t s, std::uint64_t r) const { return serial == s && revision == r; }
    bool is_whole() const { return is_done && !is_cancelled; }
  };
  static void build(Build& build, const Mesh& mesh);
  // On a thread that first waits for the one before it: that may still be destroying what was built, which takes time
  // too.
  template <class Work>
  void go_on_with(Work work);
  void begin(const Document& document);

  Start start_ = [](std::function<void()> work) { return std::thread(std::move(work)); };
  bool is_asked_ = false;
  std::uint64_t serial_ = 0, revision_ = 0;  // that were asked for last
  std::shared_ptr<Build> built_;             // done, or what the thread is at
  std::thread thread_;
};

}  // namespace ryosen
