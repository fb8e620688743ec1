// How good a simplified mesh is, by means that none of those compared has a part in: random points and a plain grid.
//   measure_quality INPUT.off OUTPUT.off
// Prints faces, RMS and largest distance found in percent of the input's diagonal (over the points of both surfaces),
// edges with three or more faces, faces turned by 90 degrees or more from the nearest face of the input, and in percent
// of what the input has the length of all loops of its boundary and that of the largest hole: of the loops of a surface
// the longest is its rim, the next one the largest hole, or the rim where it is the only one.
#include <algorithm>
#include <cmath>
#include <future>
#include <map>
#include <numeric>

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

struct Edges {
  std::size_t nonmanifold = 0;
  double boundary = 0;  // the length of all loops, and of the largest hole
  double largest_hole = 0;
};

// Points at one place are one.
Edges measure_edges(const plain::Triangles& mesh) {
  std::map<Point, std::uint32_t> numbers;
  std::vector<Point> places;
  const auto number = [&](std::uint32_t corner) {
    const auto [at, is_new] = numbers.try_emplace(mesh.points[corner], static_cast<std::uint32_t>(numbers.size()));
    if (is_new) places.push_back(mesh.points[corner]);
    return at->second;
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& face : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::minmax({number(face[i]), number(face[(i + 1) % 3])}));
  std::sort(edges.begin(), edges.end());
  std::vector<std::uint32_t> parent(places.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root_of = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  Edges found;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> boundary;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    for (end = i; end < edges.size() && edges[end] == edges[i]; ++end) {
    }
    if (end - i > 2) ++found.nonmanifold;
    if (end - i > 1) continue;
    boundary.push_back(edges[i]);
    parent[root_of(edges[i].first)] = root_of(edges[i].second);
  }
  std::map<std::uint32_t, double> loops;
  for (const auto& [a, b] : boundary) {
    const Point d = minus(places[a], places[b]);
    loops[root_of(a)] += std::sqrt(dot(d, d));
  }
  std::vector<double> lengths;
  for (const auto& [root, length] : loops) lengths.push_back(length);
  std::sort(lengths.rbegin(), lengths.rend());
  found.boundary = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  if (!lengths.empty()) found.largest_hole = lengths[std::min<std::size_t>(lengths.size() - 1, 1)];
  return found;
}

void print_share(double is, double was) {
  if (was > 0)
    std::printf(" %.1f", 100 * is / was);
  else
    std::printf(" -");
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
    std::printf("%zu - - - - - -\n", output.mesh().faces.size());
    return 0;
  }
  constexpr std::size_t points = 100000;
  auto forward_to_come = std::async(std::launch::async, [&] { return sample(input, output, points); });
  const Sampled backward = sample(output, input, points), forward = forward_to_come.get();
  const double percent = 100 / input.diagonal();
  const Edges before = measure_edges(input.mesh()), after = measure_edges(output.mesh());
  std::printf("%zu %.5f %.5f %zu %zu", output.mesh().faces.size(),
              percent * std::sqrt((forward.square_mean + backward.square_mean) / 2),
              percent * std::max(forward.largest, backward.largest), after.nonmanifold, count_turned(input, output));
  print_share(after.boundary, before.boundary);
  print_share(after.largest_hole, before.largest_hole);
  std::printf("\n");
}
