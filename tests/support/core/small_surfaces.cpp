#include "tests/support/core/small_surfaces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <set>

namespace ryosen::test {
namespace {

using oracle::Corners;

constexpr int most_vertices = 10;

class SurfaceSearch {
 public:
  SurfaceSearch(int vertices, std::map<std::string, Surface>& found) : n_(vertices), found_(found) {}

  void search() {
    for (degree_ = 3; degree_ < n_; ++degree_) {
      State state;
      bool fits = true;
      for (int i = 1; i <= degree_; ++i) fits = fits && state.add(0, i, i % degree_ + 1, degree_);
      if (fits) complete(state);
    }
  }

 private:
  // Triangles so far. The link of a vertex is a set of paths, given by their two ends, or one cycle.
  struct State {
    std::vector<Corners> triangles;
    std::array<std::array<std::uint8_t, most_vertices>, most_vertices> count{};  // triangles at an edge
    std::array<std::array<std::int8_t, most_vertices>, most_vertices> other_end{};
    std::array<std::array<std::uint8_t, most_vertices>, most_vertices> length{};  // edges of the path with this end
    std::array<std::uint8_t, most_vertices> links{}, neighbours{};
    std::array<bool, most_vertices> closed{};
    int used = 0;

    bool add_link(int v, int x, int y) {
      if (closed[v]) return false;
      const auto end_of = [&](int u) { return count[v][u] == 0 ? u : other_end[v][u]; };
      const auto length_of = [&](int u) { return count[v][u] == 0 ? 0 : length[v][u]; };
      ++links[v];
      const int p = end_of(x), q = end_of(y), edges = length_of(x) + length_of(y) + 1;
      if (p == y) {
        // The path closes; then it must be all that lies around v.
        if (length_of(x) + 1 != links[v]) return false;
        closed[v] = true;
        return true;
      }
      other_end[v][p] = static_cast<std::int8_t>(q);
      other_end[v][q] = static_cast<std::int8_t>(p);
      length[v][p] = length[v][q] = static_cast<std::uint8_t>(edges);
      return true;
    }

    bool add(int a, int b, int c, int most_neighbours) {
      if (count[a][b] > 1 || count[b][c] > 1 || count[a][c] > 1) return false;
      if (!add_link(a, b, c) || !add_link(b, a, c) || !add_link(c, a, b)) return false;
      for (auto [x, y] : {std::pair(a, b), std::pair(b, c), std::pair(a, c)}) {
        if (count[x][y] == 0 && (++neighbours[x] > most_neighbours || ++neighbours[y] > most_neighbours)) return false;
        ++count[x][y];
        ++count[y][x];
      }
      used = std::max({used, a + 1, b + 1, c + 1});
      triangles.push_back({a, b, c});
      return true;
    }
  };

  void complete(const State& state) {
    for (int a = 0; a < state.used; ++a) {
      for (int b = a + 1; b < state.used; ++b) {
        if (state.count[a][b] != 1) continue;
        for (int c = 0; c < std::min(n_, state.used + 1); ++c) {
          if (c == a || c == b || is_triangle(state, a, b, c)) continue;
          State next = state;
          if (next.add(a, b, c, degree_)) complete(next);
        }
        return;
      }
    }
    if (state.used == n_) keep(state.triangles);
  }

  static bool is_triangle(const State& state, int a, int b, int c) {
    Corners wanted{a, b, c};
    std::sort(wanted.begin(), wanted.end());
    return std::any_of(state.triangles.begin(), state.triangles.end(), [&](Corners triangle) {
      std::sort(triangle.begin(), triangle.end());
      return triangle == wanted;
    });
  }

  void keep(const std::vector<Corners>& triangles) {
    std::string code = code_of_triangles(triangles);
    if (found_.contains(code)) return;
    Surface surface{n_, triangles, true};
    orient(surface);
    found_.emplace(std::move(code), std::move(surface));
  }

  // The smallest list of triangles that numbering from some corner of some triangle on, in either direction, gives.
  std::string code_of_triangles(const std::vector<Corners>& triangles) const {
    std::string smallest;
    for (const Corners& triangle : triangles) {
      Corners start = triangle;
      std::sort(start.begin(), start.end());
      do {
        const std::string code = code_from(triangles, start);
        if (smallest.empty() || code < smallest) smallest = code;
      } while (std::next_permutation(start.begin(), start.end()));
    }
    return smallest;
  }

  std::string code_from(const std::vector<Corners>& triangles, const Corners& start) const {
    std::array<int, most_vertices> label;
    label.fill(-1);
    std::vector<Corners> queue{start};  // with labelled corners
    int labels = 0;
    for (int v : start) label[v] = labels++;
    std::set<Corners> seen;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      Corners at = queue[i];
      std::sort(at.begin(), at.end(), [&](int x, int y) { return label[x] < label[y]; });
      const Corners labelled{label[at[0]], label[at[1]], label[at[2]]};
      if (!seen.insert(labelled).second) continue;
      for (auto [x, y] : {std::pair(at[0], at[1]), std::pair(at[0], at[2]), std::pair(at[1], at[2])}) {
        for (const Corners& beside : triangles) {
          if (std::count(beside.begin(), beside.end(), x) + std::count(beside.begin(), beside.end(), y) != 2) continue;
          for (int v : beside)
            if (label[v] < 0) label[v] = labels++;
          Corners sorted{label[beside[0]], label[beside[1]], label[beside[2]]};
          std::sort(sorted.begin(), sorted.end());
          if (!seen.contains(sorted)) queue.push_back(beside);
        }
      }
    }
    std::string code;
    for (const Corners& triangle : seen)
      for (int v : triangle) code += static_cast<char>('a' + v);
    return code;
  }

  static bool runs(const Corners& face, int a, int b) {
    for (std::size_t i = 0; i < face.size(); ++i)
      if (face[i] == a && face[(i + 1) % face.size()] == b) return true;
    return false;
  }

  static void orient(Surface& surface) {
    std::vector<Corners>& faces = surface.triangles;
    std::vector<std::size_t> queue{0};
    std::vector<char> done(faces.size(), 0);
    done[0] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Corners face = faces[queue[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = face[k], b = face[(k + 1) % 3];
        for (std::size_t g = 0; g < faces.size(); ++g) {
          if (g == queue[i] || (!runs(faces[g], a, b) && !runs(faces[g], b, a))) continue;
          if (!done[g] && runs(faces[g], a, b)) std::swap(faces[g][0], faces[g][1]);
          if (!done[g]) queue.push_back(g);
          done[g] = 1;
          surface.orientable = surface.orientable && runs(faces[g], b, a);
        }
      }
    }
  }

  int n_;
  std::map<std::string, Surface>& found_;
  int degree_ = 0;
};

// Dissolves edges one after another as long as the faces stay simple; a face that is not simple never becomes so again.
class Dissolver {
 public:
  Dissolver(const Surface& surface, const VisitFaces& visit) : faces_(surface.triangles), visit_(visit) {
    std::map<std::pair<int, int>, int> face_of;
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f)
      for (std::size_t i = 0; i < 3; ++i) face_of[{faces_[f][i], faces_[f][(i + 1) % 3]}] = f;
    for (const auto& [side, f] : face_of)
      if (side.first < side.second)
        edges_.push_back({side.first, side.second, f, face_of.at({side.second, side.first})});
  }

  void run() {
    Parts parts;
    for (const Corners& face : faces_) {
      parts.part.push_back(static_cast<int>(parts.part.size()));
      std::uint32_t corners = 0;
      for (int v : face) corners |= 1u << v;
      parts.corners.push_back(corners);
    }
    go(0, parts, 0);
  }

 private:
  struct EdgeBetween {
    int a, b, left, right;
  };
  struct Parts {
    std::vector<int> part;               // of each triangle
    std::vector<std::uint32_t> corners;  // of each part, as a set of bits
  };

  void go(std::size_t edge, const Parts& parts, std::uint32_t dissolved) {
    if (edge == edges_.size()) return tell(parts, dissolved);
    go(edge + 1, parts, dissolved);
    const int p = parts.part[edges_[edge].left], q = parts.part[edges_[edge].right];
    if (p == q || std::popcount(parts.corners[p] & parts.corners[q]) != 2) return;
    Parts united = parts;
    std::replace(united.part.begin(), united.part.end(), q, p);
    united.corners[p] |= united.corners[q];
    go(edge + 1, united, dissolved | 1u << edge);
  }

  void tell(const Parts& parts, std::uint32_t dissolved) {
    std::map<int, std::map<int, int>> next;  // per part, after each corner
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f)
      for (std::size_t i = 0; i < 3; ++i) next[parts.part[f]][faces_[f][i]] = -1;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (dissolved >> e & 1u) continue;
      next[parts.part[edges_[e].left]][edges_[e].a] = edges_[e].b;
      next[parts.part[edges_[e].right]][edges_[e].b] = edges_[e].a;
    }
    std::vector<Corners> polygons;
    for (const auto& [part, after] : next) {
      Corners polygon;
      for (int v = after.begin()->first; polygon.size() < after.size(); v = after.at(v)) polygon.push_back(v);
      polygons.push_back(polygon);
    }
    visit_(polygons);
  }

  const std::vector<Corners>& faces_;
  const VisitFaces& visit_;
  std::vector<EdgeBetween> edges_;
};

}  // namespace

std::vector<Surface> closed_surfaces(int n) {
  std::map<std::string, Surface> found;
  SurfaceSearch(n, found).search();
  std::vector<Surface> surfaces;
  for (const auto& [code, surface] : found) surfaces.push_back(surface);
  return surfaces;
}

void for_each_dissolution(const Surface& surface, const VisitFaces& visit) { Dissolver(surface, visit).run(); }

void for_each_connected_part(const std::vector<Corners>& faces, Through through, const VisitFaces& visit) {
  const std::size_t n = faces.size();
  std::map<std::pair<int, int>, std::uint32_t> at;  // faces at each pair, or vertex (as a pair with itself)
  for (std::size_t f = 0; f < n; ++f)
    for (std::size_t i = 0; i < faces[f].size(); ++i) {
      const int a = faces[f][i], b = through == Through::edges ? faces[f][(i + 1) % faces[f].size()] : a;
      at[{std::min(a, b), std::max(a, b)}] |= 1u << f;
    }
  std::vector<std::uint32_t> beside(n, 0);
  for (const auto& [pair, both] : at)
    for (std::size_t f = 0; f < n; ++f)
      if (both >> f & 1u) beside[f] |= both;
  for (std::uint32_t part = 1; part < 1u << n; ++part) {
    std::uint32_t reached = part & (~part + 1);
    for (std::uint32_t before = 0; before != reached;) {
      before = reached;
      for (std::size_t f = 0; f < n; ++f)
        if (before >> f & 1u) reached |= beside[f] & part;
    }
    if (reached != part) continue;
    std::vector<Corners> chosen;
    for (std::size_t f = 0; f < n; ++f)
      if (part >> f & 1u) chosen.push_back(faces[f]);
    visit(chosen);
  }
}

namespace {

// The sides of oriented faces by their two ends: face and place in it.
class SideTable {
 public:
  explicit SideTable(const std::vector<Corners>& faces) {
    for (auto& row : side_) row.fill({-1, -1});
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
      for (int i = 0; i < static_cast<int>(faces[f].size()); ++i)
        side_[faces[f][i]][faces[f][(i + 1) % static_cast<int>(faces[f].size())]] = {f, i};
  }
  std::pair<int, int> at(int a, int b) const { return side_[a][b]; }

 private:
  std::array<std::array<std::pair<int, int>, most_vertices>, most_vertices> side_;
};

// Faces and corners in the order in which a walk from one side on meets them. Given up, and empty, as soon as it is
// larger than `smallest`.
std::string code_from(const std::vector<Corners>& faces, const SideTable& sides, std::pair<int, int> start,
                      const std::string& smallest) {
  std::string code;
  std::array<char, most_vertices> label{};
  char next_label = 'a';
  std::vector<std::pair<int, int>> queue{start};
  std::uint32_t seen = 1u << start.first;
  bool is_smaller = smallest.empty();
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const Corners& face = faces[queue[k].first];
    const int n = static_cast<int>(face.size());
    const std::size_t before = code.size();
    code += static_cast<char>('0' + n);
    for (int i = 0; i < n; ++i) {
      const int a = face[(queue[k].second + i) % n], b = face[(queue[k].second + i + 1) % n];
      if (!label[a]) label[a] = next_label++;
      code += label[a];
      const std::pair<int, int> beyond = sides.at(b, a);
      if (beyond.first < 0 || (seen >> beyond.first & 1u)) continue;
      seen |= 1u << beyond.first;
      queue.push_back(beyond);
    }
    if (is_smaller) continue;
    const int order = code.compare(before, std::string::npos, smallest, before, code.size() - before);
    if (order > 0) return {};
    is_smaller = order < 0;
  }
  return code;
}

}  // namespace

std::string code_of(const std::vector<Corners>& faces) {
  std::string smallest;
  std::vector<Corners> shape = faces;
  for (bool turned : {false, true}) {
    if (turned)
      for (Corners& face : shape) std::reverse(face.begin(), face.end());
    const SideTable sides(shape);
    for (int f = 0; f < static_cast<int>(shape.size()); ++f)
      for (int i = 0; i < static_cast<int>(shape[f].size()); ++i) {
        std::string code = code_from(shape, sides, {f, i}, smallest);
        if (!code.empty()) smallest = std::move(code);
      }
  }
  return smallest;
}

}  // namespace ryosen::test
