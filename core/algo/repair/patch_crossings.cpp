#include "core/algo/repair/patch_crossings.h"

#include "core/analysis/box_tree.h"
#include "core/analysis/overlap_tree.h"
#include "core/geometry/triangles_meet.h"
#include "core/mesh/face_polygon.h"

namespace ryosen {

namespace {

// The triangles of the patches and of the faces near them, with corners numbered by place; new vertices have numbers of
// their own.
class PatchesAndFaces {
 public:
  PatchesAndFaces(const Mesh& mesh, std::span<const PlannedPatch> patches, Progress& progress)
      : mesh_(mesh), patches_(patches) {
    std::vector<Box> boxes;
    for (const PlannedPatch& planned : patches_)
      for (const CornerTriangle& t : planned.patch.triangles) boxes.push_back(box_of(planned.patch, t));
    const BoxTree near(std::move(boxes));
    for (std::uint32_t i = 0; i < mesh.face_slots() && progress.go_on(); ++i)
      if (mesh.is_alive(Face(i))) add_if_near(Face(i), near);
    number_by_place();
    for (std::uint32_t k = 0; k < patches_.size(); ++k) add_patch(k);
  }

  NumberedSurface surface() { return {std::move(places_), std::move(corners_), std::move(sides_)}; }
  // The patch that a triangle belongs to; no_index for one of the mesh.
  std::uint32_t patch(std::uint32_t slot) const { return slot < faces_end_ ? no_index : patch_of_[slot - faces_end_]; }

 private:
  static Box box_of(const HolePatch& patch, const CornerTriangle& t) {
    Box box;
    for (std::uint32_t v : t) box.add(patch.places[v]);
    return box;
  }

  void add_if_near(Face f, const BoxTree& near) {
    polygon_.read(mesh_, f);
    if (!polygon_.is_finite()) return;
    const Box box = ryosen::box_of(polygon_.places());
    const bool is_far =
        near.visit([&](const Box& other) { return box.overlaps(other); }, [](std::uint32_t) { return false; });
    if (is_far) return;
    polygon_.triangulate(triangles_);
    for (const CornerTriangle& t : triangles_) {
      const auto vertex = [&](std::size_t k) { return mesh_.from(polygon_.corners()[t[k]]).index; };
      corners_.push_back({vertex(0), vertex(1), vertex(2)});
      unsigned sides = 0;
      for (unsigned k = 0; k < 3; ++k) sides |= unsigned{polygon_.is_side(t[k], t[(k + 1) % 3])} << k;
      sides_.push_back(static_cast<std::uint8_t>(sides));
    }
  }

  // Replaces the vertices of the faces by the numbers of their places.
  void number_by_place() {
    std::vector<std::uint32_t> vertices;
    for (const auto& corners : corners_) vertices.insert(vertices.end(), corners.begin(), corners.end());
    for (const PlannedPatch& planned : patches_)
      for (Halfedge h : planned.hole.sides) vertices.push_back(mesh_.from(h).index);
    sort_unique(vertices);
    const auto place = [&](std::uint32_t v) -> const glm::dvec3& { return mesh_.position(Vertex(v)); };
    std::sort(vertices.begin(), vertices.end(), [&](std::uint32_t a, std::uint32_t b) {
      const glm::dvec3 &p = place(a), &q = place(b);
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
    });
    for (std::uint32_t v : vertices) {
      if (places_.empty() || places_.back() != place(v)) places_.push_back(place(v));
      number_.emplace(v, static_cast<std::uint32_t>(places_.size()) - 1);
    }
    for (auto& corners : corners_)
      for (std::uint32_t& corner : corners) corner = number_.at(corner);
    faces_end_ = static_cast<std::uint32_t>(corners_.size());
  }

  void add_patch(std::uint32_t k) {
    const auto& [hole, patch] = patches_[k];
    const auto first_new = static_cast<std::uint32_t>(places_.size());
    places_.insert(places_.end(), patch.places.begin() + patch.corners, patch.places.end());
    const auto number = [&](std::uint32_t v) {
      return v < patch.corners ? number_.at(mesh_.from(hole.sides[v]).index) : first_new + v - patch.corners;
    };
    for (const CornerTriangle& t : patch.triangles) {
      corners_.push_back({number(t[0]), number(t[1]), number(t[2])});
      sides_.push_back(7);
      patch_of_.push_back(k);
    }
  }

  const Mesh& mesh_;
  std::span<const PlannedPatch> patches_;
  std::vector<glm::dvec3> places_;
  std::vector<std::array<std::uint32_t, 3>> corners_;
  std::vector<std::uint8_t> sides_;
  std::uint32_t faces_end_ = 0;
  std::vector<std::uint32_t> patch_of_;
  std::unordered_map<std::uint32_t, std::uint32_t> number_;  // by vertex
  FacePolygon polygon_;
  std::vector<CornerTriangle> triangles_;
};

}  // namespace

PatchCrossings find_patch_crossings(const Mesh& mesh, std::span<const PlannedPatch> patches, Progress& progress) {
  PatchesAndFaces triangles(mesh, patches, progress);
  const NumberedSurface surface = triangles.surface();
  PatchCrossings found{std::vector<bool>(patches.size(), false), {}};
  if (progress.is_cancelled()) return found;
  const OverlapTree tree(surface, 1);
  const auto is_out = [&](std::uint32_t patch) { return patch != no_index && found.crosses[patch]; };
  for (std::uint32_t node = 0; node < tree.node_count(); ++node)
    tree.visit_pairs(node, [&](std::uint32_t a, std::uint32_t b) {
      std::uint32_t p = triangles.patch(a), q = triangles.patch(b);
      if ((p == no_index && q == no_index) || is_out(p) || is_out(q)) return progress.go_on();
      if (!meet_elsewhere(surface.triangle(a), surface.triangle(b))) return progress.go_on();
      if (p != q && p != no_index && q != no_index)
        found.pairs.push_back(std::minmax(p, q));
      else
        found.crosses[p == no_index ? q : p] = true;
      return progress.go_on();
    });
  std::erase_if(found.pairs, [&](const auto& pair) { return is_out(pair.first) || is_out(pair.second); });
  sort_unique(found.pairs);
  return found;
}

}  // namespace ryosen
