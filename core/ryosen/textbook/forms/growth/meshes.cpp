#include "ryosen/textbook/forms/growth/meshes.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen::forms {

namespace {

// As the figure lists it: circle after circle about the Y axis.
Mesh torus(std::uint32_t circles, std::uint32_t around) {
  constexpr double large = 70, small = 30;
  IndexedMesh list;
  for (std::uint32_t i = 0; i < circles; ++i)
    for (std::uint32_t j = 0; j < around; ++j) {
      const double turn = 2 * std::numbers::pi * i / circles, angle = 2 * std::numbers::pi * j / around;
      const double out = -large + small * std::cos(angle);
      list.positions.emplace_back(out * std::cos(turn), small * std::sin(angle), -out * std::sin(turn));
    }
  const auto point = [&](std::uint32_t i, std::uint32_t j) { return i % circles * around + j % around; };
  for (std::uint32_t i = 0; i < circles; ++i)
    for (std::uint32_t j = 0; j < around; ++j)
      for (const std::uint32_t corner : {point(i, j + 1), point(i + 1, j + 1), point(i + 1, j),  //
                                         point(i, j + 1), point(i + 1, j), point(i, j)})
        list.corners.push_back(corner);
  for (std::uint32_t c = 3; c <= list.corners.size(); c += 3) list.face_offsets.push_back(c);
  return from_indexed(std::move(list));
}

// The first faces across edges from the first one, and so on from the first one that is left.
std::vector<Face> faces_around_first(const Mesh& mesh, std::size_t count) {
  std::vector<bool> is_met(mesh.face_slots(), false);
  std::vector<Face> found;
  for (std::uint32_t start = 0; start < mesh.face_slots() && found.size() < count; ++start) {
    std::deque<Face> next;
    const auto meet = [&](Face f) {
      if (!f || is_met[f.index] || !mesh.is_alive(f) || mesh.has_rings(f)) return;
      is_met[f.index] = true;
      next.push_back(f);
    };
    for (meet(Face(start)); !next.empty() && found.size() < count; next.pop_front()) {
      found.push_back(next.front());
      for (const Halfedge h : loop(mesh, mesh.halfedge(next.front()))) meet(mesh.face(twin(h)));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// A list of these faces, each copy of a point a point of its own.
Mesh mesh_of_faces(const Mesh& mesh, const std::vector<Face>& faces) {
  IndexedMesh list;
  std::vector<std::uint32_t> number(mesh.vertex_slots(), no_index);
  for (const Face f : faces) {
    for (const Halfedge h : loop(mesh, mesh.halfedge(f))) {
      std::uint32_t& point = number[mesh.from(h).index];
      if (point == no_index) {
        point = static_cast<std::uint32_t>(list.positions.size());
        list.positions.push_back(mesh.position(mesh.from(h)));
      }
      list.corners.push_back(point);
    }
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return from_indexed(std::move(list));
}

}  // namespace

std::vector<Mesh> growing_tori(std::size_t most_faces) {
  std::vector<Mesh> tori;
  for (std::uint32_t circles = 7, around = 4; std::size_t{2} * circles * around <= most_faces;) {
    tori.push_back(torus(circles, around));
    // In turn, and so that 28 by 16 is among them.
    (2 * circles > 4 * around ? around : circles) *= 2;
  }
  return tori;
}

Mesh part_of(const Mesh& mesh, std::size_t faces) {
  // The part may have points where only corners meet: there it gets copies, which are then points.
  const Mesh part = mesh_of_faces(mesh, faces_around_first(mesh, faces));
  if (!part.has_copies()) return part;
  std::vector<Face> all(part.face_slots());
  for (std::uint32_t f = 0; f < all.size(); ++f) all[f] = Face(f);
  return mesh_of_faces(part, all);
}

std::vector<Mesh> growing_parts(const Mesh& mesh, std::size_t most_faces) {
  constexpr std::size_t least_faces = 32, most_parts = 10;
  std::vector<Mesh> parts;
  for (std::size_t faces = std::min<std::size_t>(mesh.live().faces, most_faces);
       parts.size() < most_parts && (parts.empty() || faces >= least_faces) && faces > 0; faces /= 2)
    parts.push_back(part_of(mesh, faces));
  std::reverse(parts.begin(), parts.end());
  return parts;
}

}  // namespace ryosen::forms
