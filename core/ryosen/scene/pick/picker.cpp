#include "ryosen/scene/pick/picker.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/interruption.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/scene/pick/screen_segment.h"

namespace ryosen {

namespace {

// Triangles, isolated vertices and wires share the slots of the tree.
constexpr std::uint32_t sharers = 3;
std::uint32_t tree_slot_of_triangle(std::uint32_t slot) { return sharers * slot; }
std::uint32_t tree_slot_of_vertex(Vertex v) { return sharers * v.index + 1; }
std::uint32_t tree_slot_of_wire(Edge e) { return sharers * e.index + 2; }

Primitive primitive_of(const SurfaceTriangle& t) {
  return Primitive::triangle(t.corners[0], t.corners[1], t.corners[2], t.face);
}

Primitive wire(const Mesh& mesh, Edge e) {
  const auto [a, b] = ends(mesh, e);
  return Primitive::segment(a.index, b.index, e.index);
}

struct Candidate {
  double distance_px, depth;
  bool under_pointer;  // belongs to the face that the pointer is on
  std::uint32_t number;
  Vertex a, b;  // b none for a vertex
  Face face;
  glm::dvec3 place;
  double along;

  friend bool operator<(const Candidate& x, const Candidate& y) {
    if (x.distance_px != y.distance_px) return x.distance_px < y.distance_px;
    if (x.depth != y.depth) return x.depth < y.depth;
    if (x.under_pointer != y.under_pointer) return x.under_pointer;
    return std::tie(x.number, x.a, x.b) < std::tie(y.number, y.a, y.b);
  }
};

// One pick: collects the candidates near the pointer, then tests them for occlusion, best first.
class PickQuery {
 public:
  PickQuery(const Mesh& mesh, const SurfaceTriangles& triangles, const Bvh& tree, const Camera& camera, Size view,
            glm::dvec2 pixel, Picker::Depth depth, const std::optional<ClipPlane>& clip, const PassedOver* passed_over)
      : m_(mesh),
        triangles_(triangles),
        tree_(tree),
        camera_(camera),
        view_(view),
        pixel_(pixel),
        depth_(depth),
        clip_(clip),
        passed_over_(passed_over),
        screen_(camera, view) {
    const Ray ray = kept(ray_through(camera, view, pixel), clip);
    if (const auto hit = tree_.cast(m_.positions(), ray, passed_faces())) {
      under_ = Face(tree_.primitive(hit->slot).owner);
      place_ = ray.origin + hit->t * ray.direction;
    }
  }

  std::optional<Picked> face() const {
    if (!under_) return std::nullopt;
    return Picked{under_, Halfedge(), 0.5, under_, place_, 0};
  }

  // Looks further only where there is nothing to be seen near the pointer: of a dense mesh there are thousands of
  // elements within the whole radius.
  std::optional<Picked> nearest(bool vertices, double most_px) {
    double within = 0;
    for (const double radius_px : {0.25, 1.0, most_px}) {
      gather(vertices, within, radius_px);
      if (const auto found = nearest_visible(vertices)) return found;
      within = std::nextafter(radius_px, 2 * radius_px);  // up to there all are hidden
    }
    return std::nullopt;
  }

 private:
  const IndexSet* passed_faces() const { return passed_over_ ? &passed_over_->faces : nullptr; }
  bool passes_over(Vertex v) const { return passed_over_ && passed_over_->vertices.contains(v.index); }

  std::optional<Picked> nearest_visible(bool vertices) {
    // A heap instead of a sort: usually one of the first is visible.
    const auto is_worse = [](const Candidate& x, const Candidate& y) { return y < x; };
    std::make_heap(candidates_.begin(), candidates_.end(), is_worse);
    while (!candidates_.empty()) {
      const Candidate& c = candidates_.front();
      if (!is_hidden(c)) return vertices ? vertex_result(c) : edge_result(c);
      std::pop_heap(candidates_.begin(), candidates_.end(), is_worse);
      candidates_.pop_back();
    }
    return std::nullopt;
  }

  // Those at a distance from `within` to `radius_px`, both included.
  void gather(bool vertices, double within, double radius_px) {
    within_ = within;
    radius_px_ = radius_px;
    const glm::dmat4 clip_from_mesh = screen_.clip_from_mesh();
    const Frustum frustum = frustum_around_pixel(clip_from_mesh, {view_.width, view_.height}, pixel_,
                                                 std::min(1.5 * radius_px, radius_px + 0.5));
    tree_.visit_frustum(m_.positions(), frustum, [&](std::uint32_t slot) {
      const Primitive primitive = tree_.primitive(slot);
      const auto corners = static_cast<unsigned>(primitive.size());
      const Face face = corners == 3 ? Face(primitive.owner) : Face();
      for (unsigned k = 0; k < corners; ++k) {
        const Vertex a(primitive.vertices[k]), b(primitive.vertices[(k + 1) % corners]);
        if (vertices)
          add_vertex(a, face);
        else if (corners == 3 ? (triangles_.at(m_, slot / sharers).edge_bits >> k & 1u) != 0 : corners == 2 && k == 0)
          add_edge(a, b, face);
      }
    });
  }

  void add_vertex(Vertex v, Face face) {
    if (passes_over(v)) return;
    const auto at = screen_.project(m_.position(v));
    if (!at || (clip_ && clip_->cuts(m_.position(v)))) return;
    const double distance = glm::length(at->pixel - pixel_);
    if (distance < within_ || distance > radius_px_) return;
    candidates_.push_back({distance, at->depth, face == under_, v.index, v, Vertex(), face, m_.position(v), 0});
  }

  void add_edge(Vertex a, Vertex b, Face face) {
    if (passes_over(a) || passes_over(b)) return;
    // Both faces of an edge must give bitwise the same point: measure from the smaller vertex.
    const bool swapped = b < a;
    const glm::dvec3 &p = m_.position(swapped ? b : a), &q = m_.position(swapped ? a : b);
    const auto part = kept(p, q, clip_);
    if (!part) return;
    const bool is_whole = part->first == 0 && part->last == 1;
    auto near = screen_.nearest_on_segment(is_whole ? p : p + part->first * (q - p),
                                           is_whole ? q : p + part->last * (q - p), pixel_);
    if (near && !is_whole) near->along = part->first + near->along * (part->last - part->first);
    if (!near || near->distance_px < within_ || near->distance_px > radius_px_) return;
    candidates_.push_back({near->distance_px, near->depth, face == under_, face.index, a, b, face,
                           p + near->along * (q - p), swapped ? 1 - near->along : near->along});
  }

  // Whether a surface on the ray through the candidate's point is clearly in front of it.
  bool is_hidden(const Candidate& c) const {
    const auto at = screen_.project(c.place);
    if (!at) return true;
    if (depth_ == Picker::Depth::through) return false;
    return !is_seen(tree_, m_, kept(ray_through(camera_, view_, at->pixel), clip_), c.place, {}, passed_faces());
  }

  Picked edge_result(const Candidate& c) const {
    Picked picked;
    picked.halfedge = find_halfedge(m_, c.a, c.b);
    picked.along = c.along;
    picked.element = edge(picked.halfedge);
    picked.face = under_;
    picked.place = c.place;
    picked.distance_px = c.distance_px;
    return picked;
  }

  Picked vertex_result(const Candidate& c) const { return {c.a, m_.halfedge(c.a), 0, under_, c.place, c.distance_px}; }

  const Mesh& m_;
  const SurfaceTriangles& triangles_;
  const Bvh& tree_;
  const Camera& camera_;
  Size view_;
  glm::dvec2 pixel_;
  Picker::Depth depth_;
  const std::optional<ClipPlane>& clip_;
  const PassedOver* passed_over_;
  ScreenProjection screen_;
  Face under_;
  glm::dvec3 place_{0};
  double within_ = 0, radius_px_ = 0;
  std::vector<Candidate> candidates_;
};

}  // namespace

bool is_seen(const Bvh& tree, const Mesh& mesh, const Ray& ray, const glm::dvec3& place, Face own,
             const IndexSet* passed_over) {
  const auto hit = tree.cast(mesh.positions(), ray, passed_over);
  if (!hit || (own && tree.primitive(hit->slot).owner == own.index)) return true;
  constexpr double tolerance = 1e-7;
  const double t = glm::dot(place - ray.origin, ray.direction);
  return hit->t >= t - tolerance * std::abs(t);
}

void Picker::prepare(const Mesh& mesh, Progress& progress) {
  if (!has_tree_) build(mesh, progress);
}

bool Picker::is_seen(const Mesh& mesh, const Camera& camera, Size view, const ScreenPoint& at, const glm::dvec3& place,
                     Face own) {
  Progress unseen;
  prepare(mesh, unseen);
  if (clip_ && clip_->cuts(place)) return false;
  return ryosen::is_seen(tree_, mesh, kept(ray_through(camera, view, at.pixel), clip_), place, own);
}

bool Picker::shows(const Mesh& mesh, const SurfaceTriangle& triangle) const {
  return triangle.face != no_index && !(hidden_ && hidden_->hides(mesh, Face(triangle.face)));
}
bool Picker::shows(const Mesh& mesh, Vertex v) const {
  return mesh.is_alive(v) && mesh.is_isolated(v) && !(hidden_ && hidden_->isolated().contains(v.index));
}
bool Picker::shows(const Mesh& mesh, Edge e) const {
  return mesh.is_alive(e) && mesh.is_wire(e) && !(hidden_ && hidden_->wires().contains(e.index));
}

void Picker::build(const Mesh& mesh, Progress& progress) {
  has_tree_ = false;
  std::uint32_t wire_slots = mesh.edge_slots();
  while (wire_slots > 0 && !shows(mesh, Edge(wire_slots - 1))) --wire_slots;
  const std::size_t slots = std::max({triangles_.slots(), mesh.vertex_slots(), wire_slots});
  std::vector<Primitive> primitives;
  reserve_large(primitives, sharers * slots);
  resize_in_steps(primitives, sharers * slots);
  for (std::uint32_t slot = 0; slot < triangles_.slots(); ++slot) {
    stop_if_interrupted(slot);
    const SurfaceTriangle t = triangles_.at(mesh, slot);
    if (shows(mesh, t)) primitives[tree_slot_of_triangle(slot)] = primitive_of(t);
  }
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    stop_if_interrupted(i);
    const Vertex v(i);
    if (shows(mesh, v)) primitives[tree_slot_of_vertex(v)] = Primitive::point(i);
  }
  for (std::uint32_t i = 0; i < wire_slots; ++i)
    if (shows(mesh, Edge(i))) primitives[tree_slot_of_wire(Edge(i))] = wire(mesh, Edge(i));
  try {
    has_tree_ = tree_.build(mesh.positions(), std::move(primitives), progress);
  } catch (...) {
    tree_ = Bvh();
    throw;
  }
}

void Picker::put_triangle(const Mesh& mesh, std::uint32_t slot) {
  const SurfaceTriangle t = triangles_.at(mesh, slot);
  if (shows(mesh, t))
    tree_.insert(mesh.positions(), tree_slot_of_triangle(slot), primitive_of(t));
  else
    tree_.erase(tree_slot_of_triangle(slot));
}

void Picker::put_vertex(const Mesh& mesh, Vertex v) {
  tree_.erase(tree_slot_of_vertex(v));
  if (mesh.exists(v) && shows(mesh, v))
    tree_.insert(mesh.positions(), tree_slot_of_vertex(v), Primitive::point(v.index));
}

void Picker::put_wire(const Mesh& mesh, Edge e) {
  tree_.erase(tree_slot_of_wire(e));
  if (mesh.exists(e) && shows(mesh, e)) tree_.insert(mesh.positions(), tree_slot_of_wire(e), wire(mesh, e));
}

std::vector<std::uint32_t> Picker::update(const Mesh& mesh, const TouchedElements& touched) {
  std::vector<std::uint32_t> changed = triangles_.update(mesh, touched);
  if (!has_tree_) return changed;
  if (touched.everything) {
    Progress unseen;
    build(mesh, unseen);
    return changed;
  }
  for (std::uint32_t slot : changed) put_triangle(mesh, slot);
  for (Vertex v : touched.vertices) put_vertex(mesh, v);
  for (Halfedge h : touched.halfedges) put_wire(mesh, edge(h));
  for (Vertex v : touched.moved)
    if (mesh.exists(v) && mesh.is_alive(v))
      for (Halfedge h : outgoing(mesh, v)) put_wire(mesh, edge(h));
  if (tree_.is_worn()) tree_.rebuild(mesh.positions());
  return changed;
}

void Picker::update_hidden(const Mesh& mesh, const HiddenElements::Parts& changed) {
  if (!has_tree_) return;
  const std::size_t changes = changed.faces.size() + changed.wires.size() + changed.isolated.size();
  if (changes > 64 && changes > tree_.size() / 3) {
    has_tree_ = false;
    tree_ = Bvh();
    return;
  }
  for (const Face f : changed.faces)
    for (const std::uint32_t slot : triangles_.slots_of(mesh, f)) put_triangle(mesh, slot);
  for (const Edge e : changed.wires) put_wire(mesh, e);
  for (const Vertex v : changed.isolated) put_vertex(mesh, v);
  if (tree_.is_worn()) tree_.rebuild(mesh.positions());
}

std::optional<Picked> Picker::pick(const Mesh& mesh, const Camera& camera, Size view, glm::dvec2 pixel, PickMode mode,
                                   Depth depth, double radius_px, const PassedOver* passed_over) {
  Progress unseen;
  prepare(mesh, unseen);
  PickQuery query(mesh, triangles_, tree_, camera, view, pixel, depth, clip_, passed_over);
  if (mode == PickMode::face) return query.face();
  std::optional<Picked> picked = query.nearest(mode == PickMode::vertex, radius_px);
  if (picked && mode == PickMode::halfedge) picked->element = picked->halfedge;
  return picked;
}

}  // namespace ryosen
