#include "ryosen/algo/simplify/ring_values.h"

#include <algorithm>

#include "ryosen/geometry/trees/primitive.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

constexpr std::size_t most_around = 48;  // faces of a vertex, to either side

}  // namespace

RingValues::RingValues(const CollapseSurface& surface, Halfedge h, const glm::dvec3& place) {
  add_around(surface, h, place);
  add_around(surface, twin(h), place);
}

RingValues::RingValues(const CollapseSurface& surface, Vertex v, const glm::dvec3& place) {
  add_around(surface, surface.mesh().halfedge(v), place);
}

void RingValues::add_around(const CollapseSurface& surface, Halfedge first, const glm::dvec3& place) {
  const Mesh& mesh = surface.mesh();
  Halfedge corner = first;
  std::size_t count = 0;
  do add(surface, corner, place);
  while ((corner = mesh.counter_clockwise(corner)) != first && ++count < most_around);
  if (corner == first) return;
  corner = first;
  for (count = 0; count < most_around; ++count) add(surface, corner = mesh.clockwise(corner), place);
}

void RingValues::add(const CollapseSurface& surface, Halfedge corner, const glm::dvec3& place) {
  const Mesh& mesh = surface.mesh();
  if (mesh.is_outside(corner)) return;
  const std::array<Halfedge, 3> corners{corner, mesh.next(corner), mesh.prev(corner)};
  std::array<glm::dvec3, 3> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = surface.place(mesh.from(corners[i]));
  const NearestPlace near = nearest_place(at, Primitive::triangle(0, 1, 2, 0), place);
  places_.push_back({corners, {near.barycentric.x, near.barycentric.y, near.barycentric.z}, near.distance});
}

template <class IsAsked>
const RingPlace* RingValues::nearest(const IsAsked& is_asked) const {
  const RingPlace* best = nullptr;
  for (const RingPlace& place : places_)
    if ((!best || place.distance < best->distance) && is_asked(place.corners[0])) best = &place;
  return best;
}

void RingValues::write_vertex(Edit& edit, Vertex to) const {
  const RingPlace* const place = nearest([](Halfedge) { return true; });
  if (!place) return;
  const Mesh& mesh = edit.mesh();
  const std::array<Vertex, 3> sources{mesh.from(place->corners[0]), mesh.from(place->corners[1]),
                                      mesh.from(place->corners[2])};
  edit.blend(to, sources, place->shares);
}

void RingValues::write_other_corners(Edit& edit, Halfedge h) const {
  const Mesh& mesh = edit.mesh();
  for (const CornerAttribute& attribute : corner_attributes(mesh)) {
    const auto index = [&](Halfedge corner) { return mesh.attributes()[attribute.index_column].data[corner.index]; };
    const auto is_beside_edge = [&](std::uint32_t value) {
      return (!mesh.is_outside(h) && value == index(h)) ||
             (!mesh.is_outside(twin(h)) && value == index(mesh.next(twin(h))));
    };
    // The values of the charts before and behind.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> charts;
    std::size_t count = 0;
    for (const Halfedge corner : outgoing(mesh, mesh.from(h))) {
      if (++count > most_around) break;
      const std::uint32_t value = mesh.is_outside(corner) ? no_index : index(corner);
      const auto is_same = [&](const auto& chart) { return chart.first == value; };
      if (value == no_index || is_beside_edge(value) || std::any_of(charts.begin(), charts.end(), is_same)) continue;
      const RingPlace* const place =
          nearest([&](Halfedge other) { return mesh.from(other) == mesh.from(h) && index(other) == value; });
      if (!place) continue;
      const std::array<std::uint32_t, 3> indices{value, index(place->corners[1]), index(place->corners[2])};
      charts.emplace_back(value, edit.derive_in_pool(attribute.pool_column, indices, place->shares));
    }
    for (const Halfedge corner : outgoing(mesh, mesh.from(h))) {
      if (mesh.is_outside(corner)) continue;
      const auto chart =
          std::find_if(charts.begin(), charts.end(), [&](const auto& each) { return each.first == index(corner); });
      if (chart != charts.end()) edit.set_attribute(attribute.index_column, corner.index, std::span(&chart->second, 1));
    }
  }
}

void RingValues::write_corners(Edit& edit, Halfedge h) const {
  const Mesh& mesh = edit.mesh();
  // What a chart has at both ends, and what it gets.
  struct Chart {
    std::uint32_t gone, kept, made;
  };
  for (const CornerAttribute& attribute : corner_attributes(mesh)) {
    const auto index = [&](Halfedge corner) { return mesh.attributes()[attribute.index_column].data[corner.index]; };
    const Vertex gone = mesh.from(h), kept = mesh.to(h);
    std::vector<Chart> charts;
    for (const Halfedge side : {h, twin(h)}) {
      if (mesh.is_outside(side)) continue;
      const std::uint32_t here = index(side), there = index(mesh.next(side));
      const Chart chart = side == h ? Chart{here, there, no_index} : Chart{there, here, no_index};
      const auto is_same = [&](const Chart& c) { return c.gone == chart.gone && c.kept == chart.kept; };
      if (chart.gone == no_index || chart.kept == no_index || std::any_of(charts.begin(), charts.end(), is_same))
        continue;
      charts.push_back(chart);
    }
    const auto is_in = [&](Halfedge corner, const Chart& chart) {
      return index(corner) == (mesh.from(corner) == gone ? chart.gone : chart.kept);
    };
    for (Chart& chart : charts) {
      const RingPlace* const place = nearest([&](Halfedge corner) { return is_in(corner, chart); });
      if (!place) continue;
      const std::array<std::uint32_t, 3> indices{index(place->corners[0]), index(place->corners[1]),
                                                 index(place->corners[2])};
      chart.made = edit.derive_in_pool(attribute.pool_column, indices, place->shares);
    }
    for (const Vertex end : {gone, kept})
      for (const Halfedge corner : outgoing(mesh, end)) {
        if (mesh.is_outside(corner)) continue;
        const auto chart = std::find_if(charts.begin(), charts.end(), [&](const Chart& c) { return is_in(corner, c); });
        if (chart == charts.end() || chart->made == no_index) continue;
        edit.set_attribute(attribute.index_column, corner.index, std::span(&chart->made, 1));
      }
  }
}

}  // namespace ryosen
