// How good a simplified mesh is, by means that none of those compared has a part in: random points and a plain grid.
//   measure_quality INPUT.off OUTPUT.off
// Prints faces, RMS and largest distance found in percent of the input's diagonal (over the points of both surfaces),
// edges with three or more faces, and faces turned by 90 degrees or more from the nearest face of the input.
#include <algorithm>
#include <cmath>
#include <map>

#include "tests/bench/plain_surface.h"

namespace {

using namespace plain;

struct Sampled {
  double square_mean = 0, largest = 0;
};

// Random points, and the corners for the largest.
Sampled sample(const Surface& from, const Surface& to, std::size_t points) {
  Sampled result;
  visit_random_places(from, points, [&](std::uint32_t, const Point& p, const Point&) {
    const double square = to.nearest(p).square;
    result.square_mean += square / double(points);
    result.largest = std::max(result.largest, square);
  });
  for (const auto& face : from.mesh().faces)
    if (const double square = to.nearest(from.mesh().points[face[0]]).square; square > result.largest)
      result.largest = square;
  result.largest = std::sqrt(result.largest);
  return result;
}

std::size_t count_nonmanifold(const plain::Triangles& mesh) {
  std::map<Point, std::uint32_t> numbers;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  const auto number = [&](std::uint32_t corner) {
    return numbers.try_emplace(mesh.points[corner], static_cast<std::uint32_t>(numbers.size())).first->second;
  };
  for (const auto& face : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::minmax({number(face[i]), number(face[(i + 1) % 3])}));
  std::sort(edges.begin(), edges.end());
  std::size_t found = 0;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    for (end = i; end < edges.size() && edges[end] == edges[i]; ++end) {
    }
    if (end - i > 2) ++found;
  }
  return found;
}

std::size_t count_turned(const Surface& input, const Surface& output) {
  std::size_t turned = 0;
  for (std::uint32_t f = 0; f < output.mesh().faces.size(); ++f) {
    const auto [a, b, c] = output.corners(f);
    const Point n = output.normal(f);
    if (!(dot(n, n) > 0)) continue;
    const Point middle = {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
    const Point m = input.normal(input.nearest(middle).face);
    if (dot(m, m) > 0 && dot(n, m) <= 0) ++turned;
  }
  return turned;
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  const Surface input(plain::read_off(words[1])), output(plain::read_off(words[2]));
  if (input.mesh().faces.empty() || output.mesh().faces.empty()) {
    std::printf("%zu - - - -\n", output.mesh().faces.size());
    return 0;
  }
  constexpr std::size_t points = 300000;
  const Sampled forward = sample(input, output, points), backward = sample(output, input, points);
  const double percent = 100 / input.diagonal();
  std::printf("%zu %.5f %.5f %zu %zu\n", output.mesh().faces.size(),
              percent * std::sqrt((forward.square_mean + backward.square_mean) / 2),
              percent * std::max(forward.largest, backward.largest), count_nonmanifold(output.mesh()),
              count_turned(input, output));
}
