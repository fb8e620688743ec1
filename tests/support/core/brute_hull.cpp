#include "tests/support/core/brute_hull.h"

namespace ryosen::test {

namespace {
__extension__ using Wide = __int128;
}  // namespace

BruteHull brute_hull(std::span<const GridPoint> points) { return BruteForce<std::int64_t, Wide>(points).hull(); }

}  // namespace ryosen::test
