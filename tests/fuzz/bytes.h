// The bytes that a fuzzer hands to a target, read as choices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ryosen::fuzz {

// Past the end every read gives 0, so each input means something.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> all) : rest_(all) {}

  bool at_end() const { return rest_.empty(); }
  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const std::uint8_t first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
  }
  // 0 .. n-1; n from 1 to 256.
  std::size_t below(std::size_t n) { return byte() % n; }
  bool coin() { return byte() & 1; }
  std::string_view rest() const { return {reinterpret_cast<const char*>(rest_.data()), rest_.size()}; }

 private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace ryosen::fuzz
