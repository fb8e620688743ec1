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

namespace {

// The corners at a vertex in fans, between which an attribute has seams. Two fans may have the same value.
class Fans {
 public:
  // Around the vertex where `first` begins.
  Fans(const Mesh& mesh, const AttributeColumn& index, Halfedge first) {
    const auto is_apart = [&](Halfedge h) {
      return mesh.is_outside(h) || mesh.is_outside(twin(h)) ||
             index.data[h.index] != index.data[mesh.next(twin(h)).index] ||
             index.data[mesh.next(h).index] != index.data[twin(h).index];
    };
    Halfedge corner = first;
    do {
      if (count_ == 0 || is_apart(corner)) ++count_;
      if (!mesh.is_outside(corner)) fan_of_.emplace_back(corner, count_ - 1);
    } while ((corner = mesh.counter_clockwise(corner)) != first);
    if (!is_apart(first))
      for (auto& [each, fan] : fan_of_)
        if (fan == count_ - 1) fan = 0;
    std::sort(fan_of_.begin(), fan_of_.end());
  }

  std::uint32_t of(Halfedge corner) const {
    const auto found = std::lower_bound(fan_of_.begin(), fan_of_.end(), std::pair(corner, std::uint32_t{0}));
    return found != fan_of_.end() && found->first == corner ? found->second : no_index;
  }
  template <class Visit>
  void for_each_corner(const Visit& visit) const {
    for (const auto& [corner, fan] : fan_of_) visit(corner, fan);
  }

 private:
  std::vector<std::pair<Halfedge, std::uint32_t>> fan_of_;  // by corner
  std::uint32_t count_ = 0;
};

// Fans that get one value: one at each end beside the edge, or one alone.
struct Chart {
  std::uint32_t gone = no_index, kept = no_index, value = no_index;
};

}  // namespace

void RingValues::write_corners(Edit& edit, Halfedge h, Vertex at) const {
  const Mesh& mesh = edit.mesh();
  const Vertex gone = mesh.from(h), kept = mesh.to(h);
  for (const CornerAttribute& attribute : corner_attributes(mesh)) {
    const AttributeColumn& column = mesh.attributes()[attribute.index_column];
    const auto index = [&](Halfedge corner) { return column.data[corner.index]; };
    const Fans at_gone(mesh, column, h), at_kept(mesh, column, twin(h));
    const auto is_in = [&](Halfedge corner, const Chart& chart) {
      const std::uint32_t fan = mesh.from(corner) == gone ? at_gone.of(corner) : at_kept.of(corner);
      return fan != no_index && fan == (mesh.from(corner) == gone ? chart.gone : chart.kept);
    };
    const auto value_at_place = [&](const Chart& chart) {
      const RingPlace* const place = nearest([&](Halfedge corner) {
        return is_in(corner, chart) && index(mesh.next(corner)) != no_index && index(mesh.prev(corner)) != no_index;
      });
      if (!place) return no_index;
      const std::array<std::uint32_t, 3> indices{index(place->corners[0]), index(place->corners[1]),
                                                 index(place->corners[2])};
      return edit.derive_in_pool(attribute.pool_column, indices, place->shares);
    };
    std::vector<Chart> charts;
    for (const Halfedge side : {h, twin(h)}) {
      if (mesh.is_outside(side)) continue;
      const Halfedge corner_gone = side == h ? side : mesh.next(side), corner_kept = side == h ? mesh.next(side) : side;
      Chart chart{at_gone.of(corner_gone), at_kept.of(corner_kept)};
      const bool has_values = index(corner_gone) != no_index && index(corner_kept) != no_index;
      if (has_values)
        chart.value = at == gone ? index(corner_gone) : at == kept ? index(corner_kept) : value_at_place(chart);
      charts.push_back(chart);
    }
    const auto add_others = [&](const Fans& fans, std::uint32_t Chart::*end) {
      fans.for_each_corner([&](Halfedge corner, std::uint32_t fan) {
        if (index(corner) == no_index ||
            std::any_of(charts.begin(), charts.end(), [&](const Chart& c) { return c.*end == fan; }))
          return;
        Chart chart;
        chart.*end = fan;
        chart.value = value_at_place(chart);
        charts.push_back(chart);
      });
    };
    if (at != gone) add_others(at_gone, &Chart::gone);
    if (at != kept) add_others(at_kept, &Chart::kept);
    const auto write = [&](const Fans& fans, std::uint32_t Chart::*end) {
      fans.for_each_corner([&](Halfedge corner, std::uint32_t fan) {
        const auto chart = std::find_if(charts.begin(), charts.end(), [&](const Chart& c) { return c.*end == fan; });
        if (chart == charts.end() || chart->value == no_index) return;
        edit.set_attribute(attribute.index_column, corner.index, std::span(&chart->value, 1));
      });
    };
    write(at_gone, &Chart::gone);
    write(at_kept, &Chart::kept);
  }
}

}  // namespace ryosen
