#include "app/editor/camera/framing.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "ryosen/base/parallel.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/unit_vector.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/scene/pick/screen_segment.h"

namespace ryosen {

namespace {

constexpr std::uint32_t most_faces = 200;

bool is_closed(const Mesh& mesh) {
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i)
    if (const Edge e(i); mesh.is_alive(e) && (!mesh.face(halfedge(e, 0)) || !mesh.face(halfedge(e, 1)))) return false;
  return true;
}

// The flat sides of a surface, each with its area along its normal.
class FlatSides {
 public:
  explicit FlatSides(const Mesh& mesh) {
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i)
      if (const Face f(i); mesh.is_alive(f)) add(vector_area(FacePolygon(mesh, f).keyhole_walk()));
  }

  // The part of them that a direction sees: its area, and the share of it that the largest one has.
  struct Seen {
    double area = 0, largest_share = 0;
  };
  Seen seen_from(const glm::dvec3& direction) const {
    double largest = 0, all = 0;
    for (const glm::dvec3& side : sides_) {
      const double seen = std::max(glm::dot(side, direction), 0.0);
      largest = std::max(largest, seen);
      all += seen;
    }
    return {all, all > 0 ? largest / all : 0};
  }

 private:
  void add(const glm::dvec3& area) {
    constexpr double alike = 0.999;
    if (!(length_of(area) > 0) || !std::isfinite(length_of(area))) return;
    const auto side = std::find_if(sides_.begin(), sides_.end(), [&](const glm::dvec3& s) {
      return glm::dot(unit_vector(s), unit_vector(area)) > alike;
    });
    if (side == sides_.end())
      sides_.push_back(area);
    else
      *side += area;
  }

  std::vector<glm::dvec3> sides_;
};

// About Y, and up.
glm::dvec3 turned_by(const glm::dvec3& direction, double aside_deg, double up_deg) {
  const double aside = std::atan2(direction.x, direction.z) + glm::radians(aside_deg);
  const double up = std::asin(direction.y) + glm::radians(up_deg);
  return {std::cos(up) * std::sin(aside), std::sin(up), std::cos(up) * std::cos(aside)};
}

}  // namespace

Camera first_camera() {
  Camera camera;
  camera.eye = {0.42, 0.36, 1};
  return camera;
}

Camera first_camera_of(const Mesh& mesh) {
  constexpr double flat = 0.95, solid = 0.75, least_area = 0.6;  // a plate is not looked at from its edge
  Camera camera = first_camera();
  if (mesh.live().faces == 0 || mesh.live().faces > most_faces || !is_closed(mesh)) return camera;
  const FlatSides sides(mesh);
  const glm::dvec3 first = unit_vector(camera.eye);
  const FlatSides::Seen usual = sides.seen_from(first);
  if (usual.largest_share < flat) return camera;
  for (const double aside : {0, 15, -15, 30, -30, 45, -45, 60, -60})
    for (const double up : {0, 15, 30}) {
      const glm::dvec3 turned = turned_by(first, aside, up);
      const FlatSides::Seen seen = sides.seen_from(turned);
      if (seen.largest_share >= solid || seen.area < least_area * usual.area) continue;
      camera.eye = turned;
      return camera;
    }
  return camera;
}

namespace {

struct SortedPlaces {
  std::vector<glm::dvec3> with_edges, isolated;
};

bool all_have_edges(const Mesh& mesh) {
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (!mesh.is_alive(Vertex(i)) || mesh.is_isolated(Vertex(i))) return false;
  return true;
}

SortedPlaces sorted_places(const Mesh& mesh) {
  SortedPlaces places;
  places.with_edges.reserve(mesh.vertex_slots());
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (const Vertex v(i); mesh.is_alive(v))
      (mesh.is_isolated(v) ? places.isolated : places.with_edges).push_back(mesh.position(v));
  return places;
}

// Of places that are not finite none is near.
void add_near(std::vector<glm::dvec3>& places, std::span<const glm::dvec3> others) {
  constexpr double most_diagonals = 4;
  const Box box = bounds_of(places);
  const double most = most_diagonals * length_of(box.highest - box.lowest);
  for (const glm::dvec3& place : others)
    if (length_of(place - box.middle()) <= most) places.push_back(place);
}

constexpr double least_free = 0.25;

bool leaves_width(const Covered& covered, Size view) {
  return covered.left + covered.right <= (1 - least_free) * view.width;
}
bool leaves_height(const Covered& covered, Size view) { return covered.above <= (1 - least_free) * view.height; }

// Of strips that would leave too little there is none.
Covered kept_off(Covered covered, Size view) {
  if (!leaves_width(covered, view)) covered.left = covered.right = 0;
  if (!leaves_height(covered, view)) covered.above = 0;
  return covered;
}

CoveredShares shares_of(const Covered& covered, Size view) {
  return {covered.left / view.width, covered.right / view.width, covered.above / view.height};
}

// Within the circle that touches the sides of a square.
bool is_any_in(const PixelRect& square, const Camera& camera, std::span<const glm::dvec3> places, Size view) {
  const ScreenProjection screen(camera, view);
  const double radius = 0.5 * square.width();
  const glm::dvec2 middle(square.x0 + radius, square.y0 + radius);
  std::atomic<bool> found = false;
  const auto count = static_cast<std::uint32_t>(places.size());
  for_each_part(count, threads_for(count), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end && !found; ++i)
      if (const auto at = screen.project(places[i]); at && glm::length(at->pixel - middle) < radius) found = true;
  });
  return found;
}

// How large a camera shows what it is fitted to, beside another one in the same direction.
double unit_of(const Camera& camera) {
  return camera.ortho_height ? *camera.ortho_height : length_of(camera.target - camera.eye);
}

}  // namespace

CoveredShares shares_beside(const Covered& covered, Size view) { return shares_of(kept_off(covered, view), view); }

// Off the corner to the left of it or below it, by as little as it takes, where it shows more.
Camera fitted_beside(const Covered& all_covered, const Camera& from, std::span<const glm::dvec3> places, Size view) {
  const Covered covered = kept_off(all_covered, view);
  const double aspect = static_cast<double>(view.width) / view.height;
  const auto fitted_to = [&](const Covered& c) {
    return fitted(from, places, aspect, default_margin, shares_of(c, view));
  };
  const Camera camera = fitted_to(covered);
  const auto is_free = [&](const Camera& c) { return !is_any_in(*covered.corner, c, places, view); };
  if (!covered.corner || is_free(camera)) return camera;
  std::optional<Camera> found;
  for (const double share : {0.25, 0.5, 1.0}) {
    Covered to_the_left = covered, below = covered;
    to_the_left.right = std::max(covered.right, share * covered.corner->width());
    below.above = std::max(covered.above, share * covered.corner->height());
    const auto try_beside = [&](const Covered& more) {
      const Camera one = fitted_to(more);
      if (is_free(one) && (!found || unit_of(one) < unit_of(*found))) found = one;
    };
    if (leaves_width(to_the_left, view)) try_beside(to_the_left);
    if (leaves_height(below, view)) try_beside(below);
    if (found) break;
  }
  return found.value_or(camera);
}

bool shows_all(const Camera& camera, Size view, const Covered& all_covered, std::span<const glm::dvec3> places) {
  const Covered covered = kept_off(all_covered, view);
  const ScreenProjection screen(camera, view);
  return std::all_of(places.begin(), places.end(), [&](const glm::dvec3& place) {
    if (!is_finite(place)) return true;
    const auto at = screen.project(place);
    return at && at->pixel.x >= covered.left && at->pixel.x <= view.width - covered.right &&
           at->pixel.y >= covered.above && at->pixel.y <= view.height;
  });
}

void with_places_of_edges(const Mesh& mesh, const PlacesVisit& visit) {
  if (all_have_edges(mesh)) return visit(mesh.positions());
  const SortedPlaces places = sorted_places(mesh);
  visit(places.with_edges.empty() ? places.isolated : places.with_edges);
}

void with_places_to_frame(const Mesh& mesh, const PlacesVisit& visit) {
  if (all_have_edges(mesh)) return visit(mesh.positions());
  SortedPlaces places = sorted_places(mesh);
  if (places.with_edges.empty()) return visit(places.isolated);
  add_near(places.with_edges, places.isolated);
  visit(places.with_edges);
}

Camera framing(std::initializer_list<const Mesh*> meshes, const Camera& from, Size view, const Covered& covered) {
  Camera found = from;
  if (meshes.size() == 1) {
    with_places_to_frame(**meshes.begin(), [&](auto places) { found = fitted_beside(covered, from, places, view); });
    return found;
  }
  std::vector<glm::dvec3> all;
  for (const Mesh* const mesh : meshes)
    with_places_to_frame(*mesh, [&](auto places) { all.insert(all.end(), places.begin(), places.end()); });
  return fitted_beside(covered, from, all, view);
}

}  // namespace ryosen
