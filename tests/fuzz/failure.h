// How a fuzz target tells what it does and stops where something is wrong.
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>

namespace ryosen::fuzz {

// Whether each step is printed before it is done: asked for when an input is replayed.
inline bool is_telling() {
  static const bool telling = std::getenv("RYOSEN_FUZZ_TELL") != nullptr;
  return telling;
}

inline void tell(const std::string& line) {
  if (is_telling()) std::cerr << line << std::endl;
}

// Ends the program as a crash, so that the fuzzer keeps the input.
[[noreturn]] inline void fail(const std::string& sentence) {
  std::cerr << "wrong: " << sentence << std::endl;
  std::abort();
}

inline void expect(bool holds, const std::string& sentence) {
  if (!holds) fail(sentence);
}

}  // namespace ryosen::fuzz
