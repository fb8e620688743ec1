// Sheets whose values are their places, so that a value that does not follow its point is seen.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen::test {

constexpr double no_seam = std::numeric_limits<double>::infinity(), across_seam = 100;

// The unit square in side times side squares, cut in two unless they are to stay, turned by a matrix. Texture and
// colours are the places; right of the seam the texture lies 100 further.
inline Mesh valued_sheet(std::uint32_t side, double seam = no_seam, const glm::dmat3& turn = glm::dmat3(1),
                         bool of_triangles = true) {
  IndexedMesh source;
  source.texcoords.components = 3;
  for (std::uint32_t y = 0; y <= side; ++y)
    for (std::uint32_t x = 0; x <= side; ++x) {
      source.positions.push_back(turn * glm::dvec3(double(x) / side, double(y) / side, 0));
      source.vertex_colours.emplace_back(source.positions.back(), 1);
    }
  const auto add = [&](double right, std::initializer_list<std::uint32_t> corners) {
    for (const std::uint32_t corner : corners) {
      source.corners.push_back(corner);
      source.texcoords.index.push_back(static_cast<std::uint32_t>(source.texcoords.pool.size()));
      source.texcoords.pool.push_back(source.positions[corner] + glm::dvec3(right > seam ? across_seam : 0, 0, 0));
    }
    source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
  };
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t a = y * (side + 1) + x, b = a + 1, d = a + side + 1, c = d + 1;
      const double right = double(x + 1) / side;
      if (!of_triangles) {
        add(right, {a, b, c, d});
        continue;
      }
      add(right, {a, b, c});
      add(right, {a, c, d});
    }
  return from_indexed(source);
}

// How far values lie at most from the places of their points.
inline double worst_value(const Mesh& mesh, double seam = no_seam, const glm::dmat3& turn = glm::dmat3(1)) {
  const CornerAttribute texture = corner_attributes(mesh).front();
  const AttributeColumn* colours = nullptr;
  for (const AttributeColumn& column : mesh.attributes())
    if (column.name == attribute_names::colour) colours = &column;
  double worst = 0;
  for (Halfedge h(0); h.index < mesh.halfedge_slots(); ++h.index) {
    if (!mesh.is_alive(h) || mesh.is_outside(h)) continue;
    double middle = 0, corners = 0;
    for (const Halfedge corner : loop(mesh, h))
      middle += (glm::transpose(turn) * mesh.position(mesh.from(corner))).x, ++corners;
    if (std::abs(middle / corners - seam) < 1e-9) continue;  // a needle along the seam may be of either side
    const glm::dvec3 p = mesh.position(mesh.from(h)), chart(middle / corners > seam ? across_seam : 0, 0, 0);
    const auto value = attribute_value<glm::dvec3>(mesh.attributes()[texture.pool_column],
                                                   mesh.attributes()[texture.index_column].data[h.index]);
    const auto colour = attribute_value<glm::dvec4>(*colours, mesh.from(h).index);
    worst = std::max({worst, glm::distance(value, p + chart), glm::distance(glm::dvec3(colour), p)});
  }
  return worst;
}

// None of whose axes stays an axis.
inline glm::dmat3 some_turn() {
  const glm::dvec3 a = glm::normalize(glm::dvec3(1, 2, 3)), b = glm::normalize(glm::cross(a, glm::dvec3(0, 0.3, 1)));
  return {a, b, glm::cross(a, b)};
}

}  // namespace ryosen::test
