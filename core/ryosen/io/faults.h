// Why a file is refused, and at how many places.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "ryosen/base/result.h"
#include "ryosen/io/reporter.h"

namespace ryosen {

// Keeps the first fault of a reader. Where that is a value that cannot be, the reader goes on without keeping anything,
// so that all such places are counted; where it is one that leaves nothing to go on with, the reader stops. Both return
// false, as what reads a piece does that has a fault.
class Faults {
 public:
  // A value that cannot be; `text` is a function that makes the sentence. Lines count once.
  template <class MakeText>
  bool add(Code code, FilePlace place, MakeText&& text) {
    if (!failure_) failure_ = malformed(code, std::forward<MakeText>(text)(), place);
    if (failure_->message.code == code) count(place);
    return false;
  }
  // Nothing behind this place can be read.
  bool stop(Failure failure) {
    if (!failure_) failure_ = std::move(failure);
    is_stopped_ = true;
    return false;
  }

  bool any() const { return failure_.has_value(); }
  bool is_stopped() const { return is_stopped_; }
  // The first fault, with the number of those like it and where the first of these are. There must be one.
  Failure take();

 private:
  static constexpr std::size_t most_named = 5;

  void count(FilePlace place);

  std::optional<Failure> failure_;
  std::array<std::uint64_t, most_named> named_{};  // lines, or bytes
  std::uint64_t count_ = 0, last_ = 0;
  bool is_stopped_ = false;
};

// The failure of a text file that holds NUL bytes, with the first of them and how many there are; none if there is
// none.
std::optional<Failure> refuse_nul_bytes(std::string_view bytes);

}  // namespace ryosen
