#include "tests/support/core/farthest_sample.h"

#include <algorithm>
#include <limits>

#include "tests/support/core/slow_distance.h"

namespace ryosen::test {

double farthest_sample(const TriangleCorners& triangle, const std::vector<NearTarget>& targets, int k) {
  double most = 0;
  for (int i = 0; i <= k; ++i)
    for (int j = 0; i + j <= k; ++j) {
      const double a = double(i) / k, b = double(j) / k;
      const glm::dvec3 p = a * triangle[0] + b * triangle[1] + (1 - a - b) * triangle[2];
      double least = std::numeric_limits<double>::infinity();
      for (const NearTarget& target : targets)
        least = std::min(least, static_cast<double>(slow_distance(p, SlowTriangle(target.corners))) + target.bound);
      most = std::max(most, least);
    }
  return most;
}

}  // namespace ryosen::test
