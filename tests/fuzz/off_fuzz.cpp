// Any bytes to the reader of OFF.
#include "tests/fuzz/reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ryosen::fuzz::fuzz_reader("off", data, size);
}
