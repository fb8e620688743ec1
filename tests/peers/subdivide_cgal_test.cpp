// Subdivided meshes held against CGAL's where both have the same masks: closed ones, and open ones but for sqrt(3).
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "ryosen/algo/subdivide/subdivide.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/formats.h"

namespace ryosen {
namespace {

using PeerMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using subdivide::Scheme;

PeerMesh peer_mesh(const IndexedMesh& list) {
  PeerMesh peer;
  for (const glm::dvec3& p : list.positions) peer.add_vertex({p.x, p.y, p.z});
  for (std::size_t f = 0; f < list.face_count(); ++f) {
    std::vector<PeerMesh::Vertex_index> corners;
    for (const std::uint32_t corner : list.face(f)) corners.emplace_back(corner);
    peer.add_face(corners);
  }
  return peer;
}

std::vector<glm::dvec3> peer_places(const IndexedMesh& list, Scheme scheme, unsigned steps) {
  PeerMesh peer = peer_mesh(list);
  const auto parameters = CGAL::parameters::number_of_iterations(steps);
  if (scheme == Scheme::loop) CGAL::Subdivision_method_3::Loop_subdivision(peer, parameters);
  if (scheme == Scheme::catmull_clark) CGAL::Subdivision_method_3::CatmullClark_subdivision(peer, parameters);
  if (scheme == Scheme::sqrt3) CGAL::Subdivision_method_3::Sqrt3_subdivision(peer, parameters);
  std::vector<glm::dvec3> places;
  for (const auto v : peer.vertices()) places.emplace_back(peer.point(v).x(), peer.point(v).y(), peer.point(v).z());
  return places;
}

// By place along a direction in which no two are alike.
std::vector<glm::dvec3> in_order(std::vector<glm::dvec3> places) {
  const auto along = [](const glm::dvec3& p) { return p.x + 0.7321 * p.y + 0.4142 * p.z; };
  std::sort(places.begin(), places.end(), [&](const auto& a, const auto& b) { return along(a) < along(b); });
  return places;
}

// A surface of bumps over a torus or a sheet.
IndexedMesh bumps(std::uint32_t rows, std::uint32_t columns, bool is_closed, bool triangles) {
  IndexedMesh list;
  const std::uint32_t r_points = rows + !is_closed, c_points = columns + !is_closed;
  for (std::uint32_t r = 0; r < r_points; ++r)
    for (std::uint32_t c = 0; c < c_points; ++c) {
      const double u = 6.283185307179586 * r / rows, v = 6.283185307179586 * c / columns;
      const double bump = 0.1 * std::sin(3 * u + 5 * v + 0.3) + 0.07 * std::cos(7 * u - 2 * v);
      const glm::dvec3 on_torus((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v));
      list.positions.push_back(is_closed ? on_torus * (1 + bump) : glm::dvec3(r + bump, c - 0.5 * bump, 3 * bump));
    }
  const auto id = [&](std::uint32_t r, std::uint32_t c) { return (r % r_points) * c_points + c % c_points; };
  const auto add = [&](std::initializer_list<std::uint32_t> corners) {
    list.corners.insert(list.corners.end(), corners);
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  };
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t p = id(r, c), q = id(r + 1, c), s = id(r + 1, c + 1), t = id(r, c + 1);
      if (!triangles) add({p, q, s, t});
      // Turned here and there, so that valences differ.
      if (triangles && (r * 7 + c * 3) % 5 < 2) {
        add({p, q, t});
        add({q, s, t});
      } else if (triangles) {
        add({p, q, s});
        add({p, s, t});
      }
    }
  return list;
}

TEST(SubdivideCgal, places_are_the_same_but_for_rounding) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark, Scheme::sqrt3})
    for (const bool is_closed : {true, false})
      for (const bool triangles : {true, false}) {
        if (scheme != Scheme::catmull_clark && !triangles) continue;
        if (scheme == Scheme::sqrt3 && !is_closed) continue;  // its masks for boundaries are others
        const IndexedMesh list = bumps(9, 11, is_closed, triangles);
        Progress unheard;
        const Mesh mesh = from_indexed(list);
        const subdivide::Subdivided made = subdivide::subdivided(mesh, {.scheme = scheme, .steps = 2}, unheard);
        const std::vector<glm::dvec3> ours = in_order(made.columns.positions),
                                      theirs = in_order(peer_places(list, scheme, 2));
        ASSERT_EQ(ours.size(), theirs.size());
        double most = 0;
        for (std::size_t i = 0; i < ours.size(); ++i) most = std::max(most, glm::distance(ours[i], theirs[i]));
        EXPECT_LT(most, 1e-12) << int(scheme) << is_closed << triangles;
      }
}

}  // namespace
}  // namespace ryosen
