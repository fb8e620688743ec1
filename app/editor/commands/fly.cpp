#include "app/editor/commands/fly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/findings.h"
#include "app/editor/session/session_camera.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/unit_vector.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

// The faces that look along with an element: its own, its two, or those at all copies of its vertex.
std::vector<Face> faces_beside(const Mesh& m, const Element& e) {
  std::vector<Face> found;
  const auto add = [&](Face f) {
    if (f) found.push_back(f);
  };
  if (e.kind == Element::Kind::face) add(e.face());
  if (e.kind == Element::Kind::edge)
    for (int side : {0, 1}) add(m.face(halfedge(e.edge(), side)));
  if (e.kind == Element::Kind::halfedge) {
    add(m.face(e.halfedge()));
    if (found.empty()) add(m.face(twin(e.halfedge())));
  }
  if (e.kind == Element::Kind::vertex) for_each_face_at(m, e.vertex(), add);
  return found;
}

// Where a camera may look from, as unit vectors from what it looks at.
class Directions {
 public:
  Directions(const Mesh& m, const ViewState& view, std::span<const Element> elements) {
    glm::dvec3 normal{0};
    for (const Element& e : elements)
      for (Face f : faces_beside(m, e)) {
        const glm::dvec3 area = vector_area(FacePolygon(m, f).keyhole_walk());
        if (length_of(area) > 0) normal += unit_vector(area);
      }
    now_ = -axes(view.camera).forward;
    all_.push_back(now_);
    if (length_of(normal) > 1e-9) {
      add(unit_vector(normal));
      add(-unit_vector(normal));
    }
    const std::size_t first = all_.size();
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (x != 0 || y != 0 || z != 0) add(glm::normalize(glm::dvec3(x, y, z)));
    std::stable_sort(all_.begin() + static_cast<std::ptrdiff_t>(first), all_.end(),
                     [&](const auto& a, const auto& b) { return glm::dot(a, now_) > glm::dot(b, now_); });
  }

  const std::vector<glm::dvec3>& all() const { return all_; }

 private:
  // Cameras are turned about Y, so they cannot look along it.
  void add(glm::dvec3 direction) {
    constexpr double steepest = 0.97;
    if (std::abs(direction.y) > steepest) {
      const glm::dvec3 level(now_.x, 0, now_.z);
      const glm::dvec3 aside = length_of(level) > 1e-6 ? unit_vector(level) : glm::dvec3(0, 0, 1);
      direction =
          steepest * glm::dvec3(0, std::copysign(1.0, direction.y), 0) + std::sqrt(1 - steepest * steepest) * aside;
    }
    all_.push_back(direction);
  }

  glm::dvec3 now_{0};
  std::vector<glm::dvec3> all_;
};

// How many of a sample of elements are seen with a camera.
class Sight {
 public:
  Sight(Findings& findings, const ViewState& view, const Framing& framing, std::span<const Element> elements)
      : findings_(findings), view_(view), covered_(framing.covered_shares()) {
    constexpr std::size_t most = 16;
    const std::size_t step = (elements.size() + most - 1) / most;
    for (std::size_t i = 0; i < elements.size(); i += step) sample_.push_back(elements[i]);
    if (view.camera.ortho_height) {
      const Box box = bounds_of(findings.mesh().positions());
      size_ = length_of(box.highest - box.lowest) + length_of(view.camera.eye - view.camera.target);
    }
  }

  std::size_t size() const { return sample_.size(); }
  // All, as long as it cannot be asked.
  std::size_t seen(const Camera& camera) const {
    if (findings_.preparing()) return size();
    return static_cast<std::size_t>(
        std::count_if(sample_.begin(), sample_.end(), [&](const Element& e) { return is_seen(camera, e); }));
  }

 private:
  bool is_seen(Camera camera, const Element& e) const {
    const Mesh& m = findings_.mesh();
    // An orthographic picture shows what lies behind the eye too.
    if (camera.ortho_height) camera.eye -= 2 * size_ * axes(camera).forward;
    const glm::dvec3 middle = middle_of(m, e);
    const auto at = project(camera, view_.size, middle);
    const double width = view_.size.width, height = view_.size.height;
    if (!at || at->pixel.x < covered_.left * width || at->pixel.y < covered_.above * height) return false;
    if (at->pixel.x >= (1 - covered_.right) * width || at->pixel.y >= height) return false;
    const auto front = findings_.picker(view_).pick(m, camera, view_.size, at->pixel, PickMode::face);
    if (!front) return true;
    const double depth = depth_of(camera, front->place);
    if (depth >= at->depth * (1 - 1e-6)) return true;
    if (depth < at->depth * (1 - 1e-3)) return false;
    // What meets it there hides nothing of it.
    std::vector<Vertex> points;
    for_each_vertex(m, e, [&](Vertex v) { points.push_back(point(m, v)); });
    sort_unique(points);
    for (Vertex w : vertices_around(m, front->face))
      if (std::binary_search(points.begin(), points.end(), point(m, w))) return true;
    return false;
  }

  Findings& findings_;
  const ViewState& view_;
  CoveredShares covered_;  // nothing is seen there
  std::vector<Element> sample_;
  double size_ = 0;  // of what an orthographic picture shows
};

// The elements' vertices and all that are joined to them.
std::vector<glm::dvec3> places_around(const Mesh& m, std::span<const Element> elements) {
  std::vector<Vertex> points;
  for (const Element& e : elements) for_each_vertex(m, e, [&](Vertex v) { points.push_back(point(m, v)); });
  sort_unique(points);
  std::vector<glm::dvec3> places;
  for (Vertex p : points)
    for_each_copy(m, p, [&](Vertex copy) {
      places.push_back(m.position(copy));
      if (m.is_isolated(copy)) return;
      for (Vertex w : neighbours(m, copy)) places.push_back(m.position(w));
    });
  return places;
}

glm::dvec3 middle_of_all(const Mesh& m, std::span<const Element> elements) {
  std::vector<glm::dvec3> places;
  for (const Element& e : elements) for_each_vertex(m, e, [&](Vertex v) { places.push_back(m.position(v)); });
  const Box box = bounds_of(places);
  return box.lowest + (box.highest - box.lowest) / 2.0;
}

// About a point, so that this comes into the middle when all are fitted.
void mirror(std::vector<glm::dvec3>& places, const glm::dvec3& about) {
  const std::size_t count = places.size();
  for (std::size_t i = 0; i < count; ++i) places.push_back(about + (about - places[i]));
}

// From another direction than now it stands upright, as orbiting leaves it.
Camera looking_from(Camera camera, const glm::dvec3& direction, const glm::dvec3& at) {
  const double distance = length_of(camera.eye - camera.target);
  if (glm::dot(direction, -axes(camera).forward) < 1 - 1e-12) camera.up = {0, 1, 0};
  camera.target = at;
  camera.eye = at + distance * direction;
  return camera;
}

// The first camera with which all is seen, else one with which most is.
template <class Make>
Camera best_camera(const Sight& sight, const Directions& directions, Make make) {
  std::optional<Camera> best;
  std::size_t most = 0;
  for (const glm::dvec3& direction : directions.all()) {
    const Camera camera = make(direction);
    const std::size_t seen = sight.seen(camera);
    if (seen == sight.size()) return camera;
    if (!best || seen > most) best = camera;
    most = std::max(most, seen);
  }
  return *best;
}

}  // namespace

void fly_to(Findings& findings, ViewState& view, Framing& framing, std::span<const Element> elements) {
  if (elements.empty()) return framing.frame_all();
  constexpr double margin = 0.12;
  std::vector<glm::dvec3> places = places_around(findings.mesh(), elements);
  mirror(places, middle_of_all(findings.mesh(), elements));
  const double aspect = static_cast<double>(view.size.width) / view.size.height;
  const CoveredShares covered = framing.covered_shares();
  view.camera =
      best_camera(Sight(findings, view, framing, elements), Directions(findings.mesh(), view, elements),
                  [&](const glm::dvec3& from) {
                    return fitted(looking_from(view.camera, from, view.camera.target), places, aspect, margin, covered);
                  });
}

void keep_in_sight(Findings& findings, ViewState& view, Framing& framing, const Element& element) {
  const std::array<Element, 1> one{element};
  if (!is_finite(middle_of(findings.mesh(), element))) return;
  const Sight sight(findings, view, framing, one);
  if (sight.seen(view.camera) == 1) return;
  const glm::dvec3 middle = middle_of(findings.mesh(), element);
  const CoveredShares covered = framing.covered_shares();
  const glm::dvec2 to_free_middle(0.5 * (covered.left - covered.right) * view.size.width,
                                  0.5 * covered.above * view.size.height);
  view.camera = best_camera(sight, Directions(findings.mesh(), view, one), [&](const glm::dvec3& from) {
    return panned(looking_from(view.camera, from, middle), to_free_middle, view.size, middle);
  });
}

}  // namespace ryosen
