// Picking all that lies within a region of the picture.
#include <algorithm>
#include <glm/common.hpp>

#include "ryosen/base/parallel.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/scene/pick/picker.h"
#include "ryosen/scene/pick/screen_segment.h"

namespace ryosen {

ScreenRegion::ScreenRegion(std::vector<glm::dvec2> corners) : corners_(std::move(corners)) {
  if (corners_.empty()) return;
  low_ = high_ = corners_[0];
  for (const glm::dvec2& corner : corners_) {
    low_ = glm::min(low_, corner);
    high_ = glm::max(high_, corner);
  }
}

ScreenRegion ScreenRegion::box(glm::dvec2 a, glm::dvec2 b) {
  return ScreenRegion({{a.x, a.y}, {b.x, a.y}, {b.x, b.y}, {a.x, b.y}});
}

bool ScreenRegion::holds(glm::dvec2 pixel) const {
  if (pixel.x < low_.x || pixel.y < low_.y || pixel.x > high_.x || pixel.y > high_.y) return false;
  bool is_inside = false;
  for (std::size_t i = 0, j = corners_.size() - 1; i < corners_.size(); j = i++) {
    const glm::dvec2 &a = corners_[i], &b = corners_[j];
    if ((a.y > pixel.y) == (b.y > pixel.y)) continue;
    if (pixel.x < a.x + (pixel.y - a.y) / (b.y - a.y) * (b.x - a.x)) is_inside = !is_inside;
  }
  return is_inside;
}

namespace {

class RegionQuery {
 public:
  RegionQuery(const Mesh& mesh, const SurfaceTriangles& triangles, const Bvh* tree, const HiddenElements* hidden,
              const Camera& camera, Size view, const ScreenRegion& region, const std::optional<ClipPlane>& clip)
      : m_(mesh),
        triangles_(triangles),
        tree_(tree),
        hidden_(hidden),
        camera_(camera),
        view_(view),
        region_(region),
        clip_(clip),
        screen_(camera, view) {}

  bool has(Vertex v) const {
    return m_.is_alive(v) && point(m_, v) == v && shows(v) && holds(v) && is_seen(m_.position(v), Face());
  }
  bool has(Edge e) const {
    if (!m_.is_alive(e) || !shows(e)) return false;
    const auto [a, b] = ends(m_, e);
    return holds(a) && holds(b) && is_seen(0.5 * m_.position(a) + 0.5 * m_.position(b), Face());
  }
  bool has(Halfedge h) const { return has(edge(h)); }
  // Seen at the middle of one of its triangles.
  bool has(Face f) const {
    if (!m_.is_alive(f) || !shows(f)) return false;
    for (const Vertex v : vertices_around(m_, f))
      if (!holds(v)) return false;
    if (!tree_) return true;
    for (const std::uint32_t slot : triangles_.slots_of(m_, f)) {
      const SurfaceTriangle t = triangles_.at(m_, slot);
      glm::dvec3 middle(0);
      for (const std::uint32_t corner : t.corners) middle += m_.position(Vertex(corner)) / 3.0;
      if (is_seen(middle, f)) return true;
    }
    return false;
  }

 private:
  template <class Handle>
  bool shows(Handle element) const {
    return !hidden_ || !hidden_->hides(m_, element);
  }

  bool holds(Vertex v) const {
    if (clip_ && clip_->cuts(m_.position(v))) return false;
    const auto at = screen_.project(m_.position(v));
    return at && region_.holds(at->pixel);
  }

  // Whether no surface but that of `own` lies clearly in front of the place.
  bool is_seen(const glm::dvec3& place, Face own) const {
    if (!tree_) return true;
    const auto at = screen_.project(place);
    if (!at) return false;
    return ryosen::is_seen(*tree_, m_, kept(ray_through(camera_, view_, at->pixel), clip_), place, own);
  }

  const Mesh& m_;
  const SurfaceTriangles& triangles_;
  const Bvh* tree_;  // null: through the surface
  const HiddenElements* hidden_;
  const Camera& camera_;
  Size view_;
  const ScreenRegion& region_;
  const std::optional<ClipPlane>& clip_;
  ScreenProjection screen_;
};

template <class Handle>
std::vector<Element> gather(const RegionQuery& query, std::uint32_t slots) {
  const unsigned parts = threads_for(slots);
  std::vector<std::vector<Element>> found(parts);
  for_each_part(slots, parts, [&](unsigned part, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i)
      if (query.has(Handle(i))) found[part].emplace_back(Handle(i));
  });
  for (unsigned part = 1; part < parts; ++part) found[0].insert(found[0].end(), found[part].begin(), found[part].end());
  return std::move(found[0]);
}

}  // namespace

std::vector<Element> Picker::pick_region(const Mesh& mesh, const Camera& camera, Size view, const ScreenRegion& region,
                                         PickMode mode, Depth depth) {
  Progress unseen;
  if (depth == Depth::seen) prepare(mesh, unseen);
  const RegionQuery query(mesh, triangles_, depth == Depth::seen ? &tree_ : nullptr, hidden_, camera, view, region,
                          clip_);
  switch (mode) {
    case PickMode::vertex:
      return gather<Vertex>(query, mesh.vertex_slots());
    case PickMode::edge:
      return gather<Edge>(query, mesh.edge_slots());
    case PickMode::face:
      return gather<Face>(query, mesh.face_slots());
    case PickMode::halfedge:
      return gather<Halfedge>(query, mesh.halfedge_slots());
  }
  return {};
}

}  // namespace ryosen
