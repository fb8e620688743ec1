// Whether the long random walks and comparisons are asked for (`tests/run.sh --long`).
#pragma once

#include <cstdlib>

namespace ryosen::test {

inline bool is_long_run() { return std::getenv("RYOSEN_LONG") != nullptr; }

}  // namespace ryosen::test
