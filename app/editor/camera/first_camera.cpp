#include "app/editor/camera/first_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/unit_vector.h"
#include "ryosen/mesh/face_polygon.h"

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

  // What a direction sees of them: the area in all, and the share of it that the largest one has.
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

}  // namespace ryosen
