// How well a simplified mesh keeps colours and texture, for tests/bench/quality_of_values.sh.
//   measure_values normals|checker INPUT.off PAINTED.off   colours by its normals, or by a checker of 20 cells
//   measure_values atlas INPUT.off PAINTED.obj             texture in six charts by the largest part of a normal
//   measure_values colours INPUT.off OUTPUT.off            prints the RMS of colours, both ways, and of distances in
//                                                          percent of the diagonal
//   measure_values texture INPUT.obj OUTPUT.obj            prints the median and 99th percentile of how much the
//   texture
//                                                          is stretched against that of the nearest face
#include <algorithm>
#include <cmath>

#include "tests/bench/plain_obj.h"
#include "tests/bench/plain_surface.h"

namespace {

using namespace plain;

constexpr std::size_t places = 200000;

double length(const Point& p) { return std::sqrt(dot(p, p)); }
Point scaled(const Point& p, double factor) { return {factor * p[0], factor * p[1], factor * p[2]}; }

Point lowest_corner(const Triangles& mesh) {
  Point low{1e300, 1e300, 1e300};
  for (const Point& p : mesh.points)
    for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]);
  return low;
}

double largest_side(const Triangles& mesh) {
  const Point low = lowest_corner(mesh);
  double side = 0;
  for (const Point& p : mesh.points)
    for (std::size_t i = 0; i < 3; ++i) side = std::max(side, p[i] - low[i]);
  return side;
}

void paint_by_normals(Triangles& mesh) {
  const Surface surface(mesh);
  mesh.colours.assign(mesh.points.size(), Point{});
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    for (const std::uint32_t corner : mesh.faces[f])
      mesh.colours[corner] = along(mesh.colours[corner], surface.normal(f), 1);
  for (Point& colour : mesh.colours) {
    const double own = length(colour);
    colour = along({0.5, 0.5, 0.5}, colour, own > 0 ? 0.5 / own : 0);
  }
}

void paint_checker(Triangles& mesh) {
  constexpr double cells = 20;
  const Point low = lowest_corner(mesh);
  const double width = largest_side(mesh) / cells;
  mesh.colours.clear();
  for (const Point& p : mesh.points) {
    int sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += static_cast<int>((p[i] - low[i]) / width);
    const double grey = sum % 2;
    mesh.colours.push_back({grey, grey, grey});
  }
}

// Waves, so that the map is not linear within a chart.
TexturedTriangles with_atlas(Triangles mesh) {
  const Surface surface(mesh);
  const Point low = lowest_corner(mesh);
  const double side = largest_side(mesh);
  TexturedTriangles textured{std::move(mesh), {}};
  for (std::uint32_t f = 0; f < textured.triangles.faces.size(); ++f) {
    const Point normal = surface.normal(f);
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    const double chart = 2 * double(axis) + (normal[axis] < 0);
    auto& corners = textured.texture.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Point p = scaled(minus(textured.triangles.points[textured.triangles.faces[f][i]], low), 1 / side);
      const double u = p[(axis + 1) % 3], v = p[(axis + 2) % 3];
      corners[i] = {1.5 * chart + u + 0.02 * std::sin(25 * v), v + 0.02 * std::sin(20 * u)};
    }
  }
  return textured;
}

Point colour_at(const Surface& surface, std::uint32_t f, const Point& shares) {
  Point colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour = along(colour, surface.mesh().colours[surface.mesh().faces[f][i]], shares[i]);
  return colour;
}

// The shares of the corners at the place of a triangle nearest to a point.
Point shares_of_nearest(const Surface& surface, std::uint32_t f, const Point& p) {
  const auto corners = surface.corners(f);
  const Point u = minus(corners[1], corners[0]), v = minus(corners[2], corners[0]), way = minus(p, corners[0]);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), square = uu * vv - uv * uv;
  if (square > 0) {
    const double second = (vv * dot(u, way) - uv * dot(v, way)) / square,
                 third = (uu * dot(v, way) - uv * dot(u, way)) / square;
    if (second >= 0 && third >= 0 && second + third <= 1) return {1 - second - third, second, third};
  }
  Point best{1, 0, 0};
  double least = 1e300;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &a = corners[i], d = minus(corners[(i + 1) % 3], a);
    const double t = dot(d, d) > 0 ? std::clamp(dot(minus(p, a), d) / dot(d, d), 0.0, 1.0) : 0;
    const Point rest = minus(p, along(a, d, t));
    if (!(dot(rest, rest) < least)) continue;
    least = dot(rest, rest);
    best = {};
    best[i] = 1 - t;
    best[(i + 1) % 3] = t;
  }
  return best;
}

struct Means {
  double colour = 0, distance = 0;  // of squares; a colour's is that of its channels
};

Means means_of(const Surface& from, const Surface& to) {
  Means means;
  visit_random_places(from, places, [&](std::uint32_t f, const Point& p, const Point& shares) {
    const auto [square, face] = to.nearest(p);
    const Point rest = minus(colour_at(from, f, shares), colour_at(to, face, shares_of_nearest(to, face, p)));
    means.colour += dot(rest, rest) / 3 / double(places);
    means.distance += square / double(places);
  });
  return means;
}

void measure_colours(const char* input_path, const char* output_path) {
  const Surface input(read_off(input_path)), output(read_off(output_path));
  const Means forward = means_of(input, output), back = means_of(output, input);
  std::printf("%zu %.5f %.5f\n", output.mesh().faces.size(), std::sqrt((forward.colour + back.colour) / 2),
              100 / input.diagonal() * std::sqrt((forward.distance + back.distance) / 2));
}

// The gradients of both texture coordinates on a face; none without area.
std::array<Point, 2> gradients(const Surface& surface, const TexturedTriangles& mesh, std::uint32_t f) {
  const auto [a, b, c] = surface.corners(f);
  const Point u = minus(b, a), v = minus(c, a), normal = cross(u, v);
  const double square = dot(normal, normal);
  std::array<Point, 2> found{};
  if (!(square > 0)) return found;
  const auto& values = mesh.texture[f];
  for (std::size_t i = 0; i < 2; ++i)
    found[i] = scaled(
        along(scaled(cross(v, normal), values[1][i] - values[0][i]), cross(normal, u), values[2][i] - values[0][i]),
        1 / square);
  return found;
}

// How much longer or shorter the texture makes a way on the surface than the other texture does, at most; 1000 where it
// has no area.
double stretch(const std::array<Point, 2>& is, const std::array<Point, 2>& was, const Point& normal) {
  constexpr double most = 1000;
  const Point n = scaled(normal, 1 / length(normal));
  const Point first = scaled(is[0], 1 / std::max(length(is[0]), 1e-300)), second = cross(n, first);
  const auto in_plane = [&](const std::array<Point, 2>& g) {
    return std::array<double, 4>{dot(g[0], first), dot(g[0], second), dot(g[1], first), dot(g[1], second)};
  };
  const auto a = in_plane(is), b = in_plane(was);
  const double area = b[0] * b[3] - b[1] * b[2];
  if (!(std::abs(area) > 0)) return 1;
  const std::array<double, 4> m{(a[0] * b[3] - a[1] * b[2]) / area, (a[1] * b[0] - a[0] * b[1]) / area,
                                (a[2] * b[3] - a[3] * b[2]) / area, (a[3] * b[0] - a[2] * b[1]) / area};
  const double sum = m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + m[3] * m[3], product = m[0] * m[3] - m[1] * m[2];
  const double root = std::sqrt(std::max(0.0, sum * sum - 4 * product * product));
  const double largest = std::sqrt((sum + root) / 2), least = std::sqrt(std::max(0.0, (sum - root) / 2));
  return std::min(most, std::max(largest, least > 0 ? 1 / least : most));
}

void measure_texture(const char* input_path, const char* output_path) {
  const TexturedTriangles before = read_obj(input_path), after = read_obj(output_path);
  const Surface input(before.triangles), output(after.triangles);
  std::vector<double> stretches;
  visit_random_places(output, places, [&](std::uint32_t f, const Point& p, const Point&) {
    stretches.push_back(
        stretch(gradients(output, after, f), gradients(input, before, input.nearest(p).face), output.normal(f)));
  });
  std::sort(stretches.begin(), stretches.end());
  const auto at = [&](double share) { return stretches[static_cast<std::size_t>(share * double(places - 1))]; };
  std::printf("%zu %.4f %.4f\n", after.texture.size(), at(0.5), at(0.99));
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  const std::string what = words[1];
  if (what == "colours") {
    measure_colours(words[2], words[3]);
  } else if (what == "texture") {
    measure_texture(words[2], words[3]);
  } else if (what == "atlas") {
    write_obj(words[3], with_atlas(read_off(words[2])));
  } else {
    Triangles mesh = read_off(words[2]);
    what == "normals" ? paint_by_normals(mesh) : paint_checker(mesh);
    write_off(words[3], mesh);
  }
}
