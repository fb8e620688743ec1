#include "core/algo/repair/fill_holes.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include "core/algo/repair/fair_patch.h"
#include "core/algo/repair/hole_triangles.h"
#include "core/base/count_text.h"
#include "core/geometry/is_finite.h"
#include "core/geometry/polygon_normal.h"
#include "core/geometry/predicates.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/mesh/face_polygon.h"
#include "core/ops/rules/corner_values.h"
#include "core/ops/rules/face_lists.h"
#include "core/ops/rules/sheets.h"
#include "core/ops/rules/surgery.h"

namespace ryosen {

namespace {

// One boundary halfedge per hole, ascending by the lowest of its loop.
struct Holes {
  std::vector<Halfedge> to_fill;
  std::size_t left = 0;
};

bool can_be_filled(const Mesh& m, Halfedge start) {
  for (Halfedge h : loop(m, start))
    if (!is_finite(m.position(m.from(h))) || point_edge(m, h).faces() != 1) return false;
  std::vector<std::uint32_t> points = points_along(m, start);
  const std::size_t n = points.size();
  points = point_set(points);
  return n >= 3 && points.size() == n && (n > 3 || !face_on(m, points));
}

Holes find_holes(const Mesh& m, std::optional<double> most_edges) {
  Holes holes;
  std::vector<bool> seen(m.halfedge_slots(), false);
  for (std::uint32_t i = 0; i < m.halfedge_slots(); ++i) {
    const Halfedge start(i);
    if (seen[i] || !m.is_alive(start) || !m.is_outside(start)) continue;
    std::size_t edges = 0;
    bool has_face = false;
    for (Halfedge h : loop(m, start)) {
      seen[h.index] = true;
      ++edges;
      has_face = has_face || !m.is_outside(twin(h));
    }
    if (!has_face || (most_edges && static_cast<double>(edges) > *most_edges)) continue;
    if (can_be_filled(m, start))
      holes.to_fill.push_back(start);
    else
      ++holes.left;
  }
  return holes;
}

// The pairs of corners of a loop that are already joined by edges of the surface.
class JoinedCorners {
 public:
  JoinedCorners(const Mesh& m, const std::vector<Vertex>& corners) {
    std::unordered_map<Vertex, std::uint32_t> number;
    for (std::uint32_t i = 0; i < corners.size(); ++i) number.emplace(point(m, corners[i]), i);
    for (std::uint32_t i = 0; i < corners.size(); ++i)
      for_each_copy(m, corners[i], [&](Vertex copy) {
        if (m.is_isolated(copy)) return;
        for (Vertex end : neighbours(m, copy))
          if (const auto k = number.find(point(m, end)); k != number.end()) joined_.insert(key(i, k->second));
      });
  }
  bool contains(std::uint32_t i, std::uint32_t k) const { return joined_.contains(key(i, k)); }

 private:
  static std::uint64_t key(std::uint32_t i, std::uint32_t k) { return std::uint64_t{i} << 32u | k; }

  std::unordered_set<std::uint64_t> joined_;
};

glm::dvec3 normal_beyond(const Mesh& m, Halfedge outside) {
  const Face f = m.face(twin(outside));
  if (!f) return glm::dvec3(0.0);
  const FacePolygon polygon(m, f);
  return polygon.is_finite() ? polygon_normal(polygon.keyhole_walk()) : glm::dvec3(0.0);
}

// Inserts triangles into the hole; corner numbers index the loop `sides`, then the additional vertices.
class PatchBuilder {
 public:
  PatchBuilder(Edit& edit, std::vector<Halfedge> sides) : edit_(edit), sides_(std::move(sides)) {
    for (std::uint32_t i = 0; i < sides_.size(); ++i) {
      corners_.push_back(edit.mesh().from(sides_[i]));
      halfedges_[{i, static_cast<std::uint32_t>((i + 1) % sides_.size())}] = sides_[i];
    }
    patch_.boundary = corners_;
  }

  void add_centre(const glm::dvec3& place) {
    const Vertex centre = edit_.add_vertex(place);
    mean_vertex_values(edit_, patch_.boundary, centre);
    corners_.push_back(centre);
    patch_.inner.push_back(centre);
  }

  void add(const CornerTriangle& t) {
    const std::array<Halfedge, 3> h{side(t[0], t[1]), side(t[1], t[2]), side(t[2], t[0])};
    const Face f = edit_.add_face(h[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      edit_.connect(h[k], h[(k + 1) % 3]);
      edit_.set_face(h[k], f);
    }
    copy_face_values(edit_, edit_.mesh().face(twin(sides_[0])), f);
    patch_.faces.push_back(f);
  }

  Patch finish() {
    for (Vertex v : patch_.inner) edit_.set_halfedge(v, out_of_inner_);
    for (Vertex v : patch_.boundary) hold_outside(edit_, v);
    Sheets(edit_).settle(patch_.boundary);
    patch_.boundary.clear();
    for (Halfedge h : sides_) patch_.boundary.push_back(edit_.mesh().from(h));
    return std::move(patch_);
  }

 private:
  Halfedge side(std::uint32_t a, std::uint32_t b) {
    const auto known = halfedges_.find({a, b});
    if (known != halfedges_.end()) return known->second;
    const Halfedge h = edit_.add_edge(corners_[a], corners_[b]);
    halfedges_[{a, b}] = h;
    halfedges_[{b, a}] = twin(h);
    if (a >= sides_.size()) out_of_inner_ = h;
    if (b >= sides_.size()) out_of_inner_ = twin(h);
    return h;
  }

  Edit& edit_;
  std::vector<Halfedge> sides_;
  std::vector<Vertex> corners_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Halfedge> halfedges_;
  Halfedge out_of_inner_;
  Patch patch_;
};

glm::dvec3 middle_of(const std::vector<glm::dvec3>& places) {
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& p : places) mean += p / static_cast<double>(places.size());
  return mean;
}

// None if every triangulation of the hole has zero-area triangles, as with two coincident boundaries.
std::optional<Patch> fill_hole(Edit& edit, Halfedge start) {
  const Mesh& m = edit.mesh();
  HoleLoop hole;
  std::vector<Halfedge> sides;
  std::vector<Vertex> corners;
  for (Halfedge h : loop(m, start)) {
    sides.push_back(h);
    corners.push_back(m.from(h));
    hole.places.push_back(m.position(m.from(h)));
    hole.normals.push_back(normal_beyond(m, h));
  }
  const JoinedCorners joined(m, corners);
  hole.may_join = [&](std::uint32_t i, std::uint32_t k) { return !joined.contains(i, k); };
  PatchBuilder builder(edit, sides);
  if (const auto triangles = triangulate_hole(hole)) {
    for (const CornerTriangle& t : *triangles) builder.add(t);
  } else {
    const glm::dvec3 middle = middle_of(hole.places);
    const auto n = static_cast<std::uint32_t>(sides.size());
    for (std::uint32_t i = 0; i < n; ++i)
      if (are_collinear(hole.places[i], hole.places[(i + 1) % n], middle)) return std::nullopt;
    builder.add_centre(middle);
    for (std::uint32_t i = 0; i < n; ++i) builder.add({i, (i + 1) % n, n});
  }
  return builder.finish();
}

}  // namespace

AlgorithmResult fill_holes(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const Mesh& m = edit.mesh();
  std::optional<double> most_edges;
  if (input.values.has("most_edges")) most_edges = static_cast<double>(input.values.count("most_edges"));
  const Holes holes = find_holes(m, most_edges);
  std::size_t filled = 0, left = holes.left, faces = 0, vertices = 0;
  std::size_t done = 0;
  for (Halfedge start : holes.to_fill) {
    progress.begin_part(done++, holes.to_fill.size());
    if (!progress.go_on()) return {};
    // An earlier patch may have blocked this hole.
    if (!m.is_alive(start) || !m.is_outside(start) || !can_be_filled(m, start)) {
      ++left;
      continue;
    }
    std::optional<Patch> patch = fill_hole(edit, start);
    if (!patch) {
      ++left;
      continue;
    }
    refine(edit, *patch, progress);
    fair(edit, *patch, progress);
    ++filled;
    faces += patch->faces.size();
    vertices += patch->inner.size();
  }
  AlgorithmResult result{filled, left, {}};
  result.text = count_text(filled, "One hole was filled", "# holes were filled", "穴を # 個ふさぎました");
  if (filled > 0)
    result.text = result.text + count_text(faces, " by # triangle", " by # triangles", "（三角形 #") +
                  count_text(vertices, " and # new vertex", " and # new vertices", "、新しい頂点 #）");
  if (left > 0) {
    result.text.en += "; " + std::to_string(left) + " could not be";
    result.text.ja += "。ふさげない穴 " + std::to_string(left);
  }
  result.text.en += ".";
  result.text.ja += "。";
  return result;
}

}  // namespace ryosen
