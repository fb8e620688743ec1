// Functions that a fuzzer hands its inputs to. Each ends the program where something is wrong.
#pragma once

#include <cstdint>
#include <span>

namespace ryosen::fuzz {

using Input = std::span<const std::uint8_t>;

void fuzz_gzip(Input input);
void fuzz_hull(Input input);
void fuzz_ops(Input input);
void fuzz_round_trip(Input input);

}  // namespace ryosen::fuzz
