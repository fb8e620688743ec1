// Any bytes to the reader of lists of points.
#include "tests/fuzz/reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ryosen::fuzz::fuzz_reader("xyz", data, size);
}
