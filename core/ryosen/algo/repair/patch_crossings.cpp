#include "ryosen/algo/repair/patch_crossings.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "ryosen/analysis/box_tree.h"
#include "ryosen/analysis/overlap_tree.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/place_keys.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

namespace {

using PatchPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // ascending, the earlier patch first

struct PatchCrossings {
  std::vector<bool> crosses;  // by patch: whether it crosses the surface or itself
  std::vector<Face> crossed;  // by patch: the lowest face of the surface that it crosses, if any
  // Of the others, those that cross each other, each pair once.
  PatchPairs pairs;
};

// For segments whose boxes overlap.
bool do_meet(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& a, const glm::dvec2& b) {
  return orient2d(p, q, a) * orient2d(p, q, b) <= 0 && orient2d(a, b, p) * orient2d(a, b, q) <= 0;
}

bool is_simple(const std::vector<glm::dvec2>& polygon) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  const auto end = [&](std::uint32_t i) -> const glm::dvec2& { return polygon[i + 1 == n ? 0 : i + 1]; };
  std::vector<Box> boxes(n);
  for (std::uint32_t i = 0; i < n; ++i)
    for (const glm::dvec2& p : {polygon[i], end(i)}) boxes[i].add({p, 0});
  const BoxTree sides(boxes);
  for (std::uint32_t i = 0; i < n; ++i) {
    const glm::dvec2 &p = polygon[i], &q = end(i), &r = end(i + 1 == n ? 0 : i + 1);
    if (orient2d(p, q, r) == 0 && glm::dot(p - q, r - q) >= 0) return false;
    const bool is_clear = sides.visit([&](const Box& box) { return box.overlaps(boxes[i]); },
                                      [&](std::uint32_t k) {
                                        const bool is_beside = k == i || k == (i + 1) % n || i == (k + 1) % n;
                                        return is_beside || !do_meet(p, q, polygon[k], end(k));
                                      });
    if (!is_clear) return false;
  }
  return true;
}

// Whether the patch, seen along the axis nearest to its loop's normal, covers each point once: all its triangles are
// seen from the same side, and the loop is a simple polygon. Exact; such a patch nowhere meets itself but at shared
// corners and sides. O(n log n) and the overlaps of boxes of the loop's sides.
bool covers_once_in_projection(const HolePatch& patch) {
  const glm::dvec3 normal = glm::abs(polygon_normal(std::span(patch.places).first(patch.corners)));
  const int axis = normal.z >= normal.x && normal.z >= normal.y ? 2 : normal.y >= normal.x ? 1 : 0;
  const auto seen = [&](std::uint32_t v) { return seen_along(patch.places[v], axis); };
  int side = 0;
  for (const CornerTriangle& t : patch.triangles) {
    const int turn = orient2d(seen(t[0]), seen(t[1]), seen(t[2]));
    if (turn == 0 || turn * side < 0) return false;
    side = turn;
  }
  std::vector<glm::dvec2> polygon;
  for (std::uint32_t i = 0; i < patch.corners; ++i) polygon.push_back(seen(i));
  return is_simple(polygon);
}

// The triangles, with corners at one place numbered alike.
NumberedSurface surface_of(const HolePatch& patch) {
  std::vector<std::uint32_t> order(patch.corners), number(patch.places.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return is_before(patch.places[a], patch.places[b]); });
  std::iota(number.begin(), number.end(), 0u);
  for (std::uint32_t i = 1; i < patch.corners; ++i)
    if (patch.places[order[i]] == patch.places[order[i - 1]]) number[order[i]] = number[order[i - 1]];
  std::vector<std::array<std::uint32_t, 3>> corners;
  for (const CornerTriangle& t : patch.triangles) corners.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return NumberedSurface(patch.places, std::move(corners));
}

// Exact, with corners at one place as one (choose_patches). The patch must have no degenerate triangles.
// O(n log n + pairs of overlapping boxes, of which fans have few); O(n log n) for one that covers its projection once.
bool crosses_itself(const HolePatch& patch) {
  if (covers_once_in_projection(patch)) return false;
  const NumberedSurface surface = surface_of(patch);
  const OverlapTree tree(surface, 1);
  const auto all = [](std::uint32_t, std::uint32_t) { return true; };
  for (std::uint32_t node = 0; node < tree.node_count(); ++node) {
    const bool is_clear = tree.visit_pairs(node, all, [&](std::uint32_t a, std::uint32_t b) {
      return !meet_elsewhere(surface.triangle(a), surface.triangle(b));
    });
    if (!is_clear) return true;
  }
  return false;
}

// Finds the triangles that meet those of the patches. Corners are numbered: those of faces by place, new vertices have
// numbers of their own.
class CrossingSearch {
 public:
  CrossingSearch(const Mesh& mesh, std::span<const PlannedPatch> patches, Progress& progress)
      : mesh_(mesh), patches_(patches), progress_(progress), in_(patches.size()) {
    found_.crosses.assign(patches.size(), false);
    found_.crossed.assign(patches.size(), Face());
  }

  PatchCrossings run() {
    number_places();
    for (std::uint32_t k = 0; k < patches_.size(); ++k) add_patch(k);
    std::vector<Box> boxes;
    for (const Triangles& patch : parts_) boxes.push_back(patch.box);
    tree_ = BoxTree(std::move(boxes));
    for (std::uint32_t i = 0; i < mesh_.face_slots() && goes_on(); ++i)
      if (mesh_.is_alive(Face(i))) compare_face(Face(i));
    for (std::uint32_t p = 0; p < parts_.size() && goes_on(); ++p)
      if (!is_out(p) && crosses_itself(patches_[p].patch)) note(p, p);
    for (std::uint32_t p = 0; p < parts_.size(); ++p)
      for (std::uint32_t k = parts_[p].first; k < parts_[p].last && goes_on(); ++k) compare(triangles_[k], p);
    std::erase_if(found_.pairs, [&](const auto& p) { return found_.crosses[p.first] || found_.crosses[p.second]; });
    sort_unique(found_.pairs);
    return std::move(found_);
  }

 private:
  // The triangles of a patch, numbered from `first`.
  struct Triangles {
    Box box;
    std::uint32_t first, last;
    BoxTree tree;
  };

  std::uint32_t size() const { return static_cast<std::uint32_t>(triangles_.size()); }

  // Not only when cancelled: also when there is nothing left to be found.
  bool goes_on() { return in_ > 0 && progress_.go_on(); }

  // The places of the loops' corners have the numbers from 0; other corners of faces are no patch's.
  void number_places() {
    for (const PlannedPatch& planned : patches_)
      for (const glm::dvec3& p : planned.hole.places) places_.push_back(p);
    std::sort(places_.begin(), places_.end(), is_before);
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    next_number_ = static_cast<std::uint32_t>(places_.size());
  }
  // no_index where no loop has a corner.
  std::uint32_t number_of(const glm::dvec3& place) const {
    const auto at = std::lower_bound(places_.begin(), places_.end(), place, is_before);
    return at != places_.end() && *at == place ? static_cast<std::uint32_t>(at - places_.begin()) : no_index;
  }

  void add_patch(std::uint32_t k) {
    const HolePatch& patch = patches_[k].patch;
    std::vector<std::uint32_t> number;
    for (std::uint32_t v = 0; v < patch.places.size(); ++v)
      number.push_back(v < patch.corners ? number_of(patch.places[v]) : next_number_++);
    Triangles part{{}, size(), size(), {}};
    std::vector<Box> boxes;
    for (const CornerTriangle& t : patch.triangles) {
      triangles_.push_back(
          {{patch.places[t[0]], patch.places[t[1]], patch.places[t[2]]}, {number[t[0]], number[t[1]], number[t[2]]}});
      boxes.push_back(box_of(triangles_.back().places));
      part.box.add(boxes.back());
    }
    part.last = size();
    part.tree = BoxTree(std::move(boxes));
    parts_.push_back(std::move(part));
  }

  void compare_face(Face f) {
    polygon_.read(mesh_, f);
    if (!polygon_.is_finite()) return;
    const Box box = box_of(polygon_.places());
    const auto overlaps = [&](const Box& other) { return box.overlaps(other); };
    const bool is_far = tree_.visit(
        overlaps, [&](std::uint32_t p) { return parts_[p].tree.visit(overlaps, [](std::uint32_t) { return false; }); });
    if (is_far) return;
    polygon_.triangulate(corners_);
    for (const CornerTriangle& t : corners_) {
      NumberedTriangle triangle{};
      unsigned sides = 0;
      for (unsigned k = 0; k < 3; ++k) {
        triangle.places[k] = polygon_.places()[t[k]];
        triangle.numbers[k] = number_of(triangle.places[k]);
        if (triangle.numbers[k] == no_index) triangle.numbers[k] = no_index - k;
        sides |= unsigned{polygon_.is_side(t[k], t[(k + 1) % 3])} << k;
      }
      triangle.sides = static_cast<std::uint8_t>(sides);
      if (!are_collinear(triangle.places[0], triangle.places[1], triangle.places[2])) compare(triangle, no_index, f);
    }
  }

  // Compares a triangle of the mesh (p is no_index) with all patches; one of a patch with later patches.
  void compare(const NumberedTriangle& triangle, std::uint32_t p, Face f = {}) {
    const auto may = [&](const Box& box) { return !are_surely_apart(triangle.places, box); };
    tree_.visit(may, [&](std::uint32_t q) {
      if (is_out(p)) return false;
      if ((p != no_index && q <= p) || is_out(q)) return true;
      const bool is_clear = parts_[q].tree.visit(may, [&](std::uint32_t i) {
        const NumberedTriangle& other = triangles_[parts_[q].first + i];
        return are_surely_apart(triangle.places, other.places) || !meet_elsewhere(triangle, other);
      });
      if (is_clear) return true;
      if (f) found_.crossed[q] = f;
      note(p, q);
      return true;
    });
  }

  bool is_out(std::uint32_t patch) const { return patch != no_index && found_.crosses[patch]; }

  void note(std::uint32_t p, std::uint32_t q) {
    if (p == no_index || p == q) {
      found_.crosses[q] = true;
      --in_;
    } else {
      found_.pairs.emplace_back(std::min(p, q), std::max(p, q));
    }
  }

  const Mesh& mesh_;
  std::span<const PlannedPatch> patches_;
  Progress& progress_;
  std::size_t in_;  // patches that are not known to cross
  PatchCrossings found_;
  std::vector<glm::dvec3> places_;  // of the loops' corners, ascending
  std::uint32_t next_number_ = 0;
  std::vector<NumberedTriangle> triangles_;  // of the patches
  std::vector<Triangles> parts_;             // by patch
  BoxTree tree_;                             // of the patches
  FacePolygon polygon_;
  std::vector<CornerTriangle> corners_;
};

// The pairs of patches that would make the same edge between points of loops.
PatchPairs pairs_with_an_edge(std::span<const PlannedPatch> planned) {
  using Made = std::pair<std::pair<Vertex, Vertex>, std::uint32_t>;  // points, patch
  std::vector<Made> made;
  for (std::uint32_t k = 0; k < planned.size(); ++k)
    for (const CornerTriangle& t : planned[k].patch.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3];
        if (is_chord(a, b, planned[k].patch.corners))
          made.emplace_back(std::minmax(planned[k].hole.points[a], planned[k].hole.points[b]), k);
      }
  sort_unique(made);
  PatchPairs pairs;
  for (std::size_t i = 0; i < made.size(); ++i)
    for (std::size_t j = i + 1; j < made.size() && made[j].first == made[i].first; ++j)
      pairs.emplace_back(made[i].second, made[j].second);
  sort_unique(pairs);
  return pairs;
}

// Finds what keeps patches out: themselves or the surface, or others.
PatchCrossings obstacles(const Mesh& mesh, std::span<const PlannedPatch> planned, Takes takes, Progress& progress) {
  if (takes < Takes::crossing) return CrossingSearch(mesh, planned, progress).run();
  PatchCrossings found{std::vector<bool>(planned.size(), false), std::vector<Face>(planned.size()), {}};
  for (std::uint32_t k = 0; k < planned.size() && takes == Takes::crossing; ++k)
    found.crosses[k] = crosses_itself(planned[k].patch);
  return found;
}

// Excludes both patches of a pair, or the later one only.
void exclude(bool both, const PatchPairs& pairs, WhyOpen why, PatchChoice& choice) {
  const std::vector<WhyOpen> before = choice.cause;
  const std::vector<WhyOpen>& is_in = both ? before : choice.cause;
  for (const auto& [a, b] : pairs) {
    if (is_in[a] != WhyOpen::filled || is_in[b] != WhyOpen::filled) continue;
    if (both) choice.cause[a] = why;
    choice.cause[b] = why;
    choice.conflicts[a] = choice.conflicts[b] = true;
  }
}

}  // namespace

std::optional<std::uint32_t> side_on_surroundings(const HoleLoop& hole, const HolePatch& patch) {
  const std::uint32_t n = patch.corners;
  const auto beside_place = [&](std::uint32_t v) { return v < n ? hole.places[v] : hole.around.places[v - n]; };
  // Numbers beside the loop go from no_index down, those of the patch up.
  const auto beside_number = [&](std::uint32_t v) { return v < n ? v : no_index - (v - n); };
  std::vector<std::uint32_t> beside(n, no_index);  // by side of the loop
  for (std::uint32_t t = 0; t < hole.around.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t end = hole.around.triangles[t][k], start = hole.around.triangles[t][(k + 1) % 3];
      if (start < n && end == (start + 1) % n) beside[start] = t;
    }
  for (const CornerTriangle& t : patch.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t start = t[k];
      if (start >= n || t[(k + 1) % 3] != (start + 1) % n || beside[start] == no_index) continue;
      const CornerTriangle& b = hole.around.triangles[beside[start]];
      const NumberedTriangle of_patch{{patch.places[t[0]], patch.places[t[1]], patch.places[t[2]]}, t};
      const NumberedTriangle of_mesh{{beside_place(b[0]), beside_place(b[1]), beside_place(b[2])},
                                     {beside_number(b[0]), beside_number(b[1]), beside_number(b[2])}};
      const bool is_flat = are_collinear(of_mesh.places[0], of_mesh.places[1], of_mesh.places[2]);
      if (!is_flat && meet_elsewhere(of_patch, of_mesh)) return start;
    }
  return std::nullopt;
}

PatchChoice choose_patches(const Mesh& mesh, std::span<const PlannedPatch> planned, Takes takes, Progress& progress) {
  PatchCrossings found = obstacles(mesh, planned, takes, progress);
  PatchChoice choice{std::vector<WhyOpen>(planned.size(), WhyOpen::filled), std::move(found.crossed),
                     std::vector<bool>(planned.size(), false)};
  for (std::uint32_t k = 0; k < planned.size(); ++k)
    if (found.crosses[k]) choice.cause[k] = WhyOpen::crosses;
  exclude(takes == Takes::clear, pairs_with_an_edge(planned), WhyOpen::edge_exists, choice);
  exclude(takes == Takes::clear, found.pairs, WhyOpen::crosses, choice);
  return choice;
}

}  // namespace ryosen
