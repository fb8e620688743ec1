#include "ryosen/algo/subdivide/carry.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <glm/common.hpp>
#include <limits>
#include <numeric>
#include <optional>

#include "ryosen/algo/features.h"
#include "ryosen/algo/subdivide/masks.h"
#include "ryosen/algo/subdivide/step_sources.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen::subdivide {

namespace {

// The smallest and largest values in the faces around each vertex: masks stay between them but for rounding, and where
// they are equal to the bit.
class ValueBounds {
 public:
  explicit ValueBounds(const Mesh& mesh) {
    constexpr double all = std::numeric_limits<double>::infinity();
    bounds_.assign(mesh.vertex_slots(), {glm::dvec3(all), glm::dvec3(-all)});
    for (const Face f : live_faces(mesh)) {
      std::pair<glm::dvec3, glm::dvec3> own{glm::dvec3(all), glm::dvec3(-all)};
      for (const Vertex v : vertices_around(mesh, f)) {
        own.first = glm::min(own.first, mesh.position(v));
        own.second = glm::max(own.second, mesh.position(v));
      }
      for (const Vertex v : vertices_around(mesh, f)) {
        auto& [lowest, highest] = bounds_[v.index];
        lowest = glm::min(lowest, own.first);
        highest = glm::max(highest, own.second);
      }
    }
  }
  void keep_within(glm::dvec3& value, Vertex around) const { keep_within(value, around, around); }
  void keep_within(glm::dvec3& value, Vertex a, Vertex b) const {
    const glm::dvec3 lowest = glm::min(bounds_[a.index].first, bounds_[b.index].first),
                     highest = glm::max(bounds_[a.index].second, bounds_[b.index].second);
    if (lowest.x <= highest.x) value = glm::min(glm::max(value, lowest), highest);  // else there are no faces
  }

 private:
  std::vector<std::pair<glm::dvec3, glm::dvec3>> bounds_;
};

// The mesh with the numbers of vertices, three of them from `first` on, as places and without attributes.
Mesh mesh_of_values(const Mesh& mesh, const AttributeColumn& column, std::uint32_t first) {
  MeshColumns columns = mesh.columns();
  columns.attributes.clear();
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    for (std::uint32_t k = 0; k < 3; ++k)
      columns.positions[i][static_cast<int>(k)] = first + k < column.type.count ? number_at(column, i, first + k) : 0;
  return Mesh(std::move(columns));
}

// What a mask does to places it does to values, as places, so that these stay on the surface where they are: of
// vertices (colours) on the mesh itself; of corners (texture coordinates, normals) on a mesh of their charts, which is
// torn where values differ. There a chart has a boundary, and so its outline runs by the mask of boundaries.
class Charts {
 public:
  Charts(const Mesh& mesh, const Creases& creases, const CornerAttribute& attribute)
      : mesh_(mesh), creases_(creases), of_(mesh.halfedge_slots()) {
    build(mesh.attributes()[attribute.index_column], mesh.attributes()[attribute.pool_column]);
    take_creases();
    find_tips();
  }

  // Faces have the numbers they had; those of which a corner has no value are not there. Each vertex has one value.
  const Mesh& mesh() const { return charts_; }
  // The halfedge at the same corner; none where the face is not there.
  Halfedge of(Halfedge h) const { return of_[h.index]; }

  // What masks(mesh, creases) makes of values; vertices come first. A chart that is torn up to a vertex has one value
  // there: it goes by the mask of the whole mesh, with the means of what its neighbours have.
  template <class Masks>
  Places values(const Masks& masks) const {
    Places values = masks(charts_, own_creases_);
    if (!means_) return values;
    const Places means = masks(*means_, creases_);
    for (const auto& [own, v] : tips_) values[own.index] = means[v.index];
    return values;
  }

 private:
  // A vertex of the charts for each vertex with each of its values.
  void build(const AttributeColumn& index, const AttributeColumn& pool) {
    IndexedMesh list;
    list.face_offsets.assign(1, 0);
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> known(mesh_.vertex_slots());  // value, number
    const auto number_of = [&](Halfedge corner) {
      const std::uint32_t value = index.data[corner.index];
      auto& own = known[mesh_.from(corner).index];
      for (const auto& [other, number] : own)
        if (other == value) return number;
      const auto number = static_cast<std::uint32_t>(list.positions.size());
      own.emplace_back(value, number);
      list.positions.push_back(attribute_value<glm::dvec3>(pool, value));
      vertex_of_.push_back(mesh_.from(corner));
      return number;
    };
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
      if (const Face f(i); mesh_.is_alive(f)) {
        bool has_all = true;
        for (const Halfedge h : loop(mesh_, mesh_.halfedge(f))) has_all = has_all && index.data[h.index] != no_index;
        for (const Halfedge h : loop(mesh_, mesh_.halfedge(f)))
          if (has_all) list.corners.push_back(number_of(h));
      }
      list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
    }
    charts_ = from_indexed(std::move(list));
    for (const Face f : live_faces(charts_)) {
      Halfedge own = charts_.halfedge(f);
      for (const Halfedge h : loop(mesh_, mesh_.halfedge(f))) {
        of_[h.index] = own;
        own = charts_.next(own);
      }
    }
  }

  void take_creases() {
    for (std::size_t i = vertex_of_.size(); i < charts_.vertex_slots(); ++i)  // copies
      vertex_of_.push_back(vertex_of_[point(charts_, Vertex(static_cast<std::uint32_t>(i))).index]);
    own_creases_.corners.resize(charts_.vertex_slots());
    for (std::uint32_t i = 0; i < charts_.vertex_slots(); ++i) {
      const bool stays = rule_at(mesh_, creases_, vertex_of_[i], 1).rule == VertexRule::corner;
      own_creases_.corners[i] = stays || has_copies(charts_, Vertex(i));
    }
    if (creases_.sharpness.empty()) return;
    own_creases_.sharpness.resize(charts_.edge_slots());
    for (std::uint32_t i = 0; i < mesh_.halfedge_slots(); ++i)
      if (const Halfedge own = of_[i])
        own_creases_.sharpness[edge(own).index] = creases_.sharpness_of(mesh_, Halfedge(i));
  }

  // Where a chart has a boundary at a vertex and the mesh has none, though the vertex has one value.
  void find_tips() {
    std::vector<std::uint32_t> values(mesh_.vertex_slots());
    for (const Vertex v : vertex_of_) ++values[v.index];
    for (std::uint32_t i = 0; i < charts_.vertex_slots(); ++i)
      if (const Vertex v = vertex_of_[i];
          values[v.index] == 1 && charts_.is_boundary(Vertex(i)) && !mesh_.is_boundary(v) && !own_creases_.corners[i])
        tips_.emplace_back(Vertex(i), v);
    if (tips_.empty()) return;
    MeshColumns columns = mesh_.columns();
    columns.attributes.clear();
    std::fill(columns.positions.begin(), columns.positions.end(), glm::dvec3(0));
    for (std::uint32_t i = 0; i < charts_.vertex_slots(); ++i) {
      const Vertex v = vertex_of_[i];
      columns.positions[v.index] += charts_.position(Vertex(i)) / double(values[v.index]);
    }
    means_.emplace(std::move(columns));
  }

  const Mesh& mesh_;
  const Creases& creases_;
  Mesh charts_;
  Creases own_creases_;
  std::vector<Halfedge> of_;
  std::vector<Vertex> vertex_of_;                // by vertex of the charts
  std::vector<std::pair<Vertex, Vertex>> tips_;  // of the charts, of the mesh
  std::optional<Mesh> means_;
};

// A step by masks: what all places are, vertices first, and between the values of which vertices they stay.
struct Step {
  std::function<Places(const Mesh&, const Creases&)> masks;
  std::function<void(const Mesh&, const ValueBounds&, Places&)> keep_within;

  Places operator()(const Mesh& mesh, const Creases& creases) const {
    Places values = masks(mesh, creases);
    keep_within(mesh, ValueBounds(mesh), values);
    return values;
  }
};

void keep_vertices_within(const Mesh& mesh, const ValueBounds& bounds, Places& values) {
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) bounds.keep_within(values[i], Vertex(i));
}

bool has_masks(const AttributeColumn& column) {
  return column.element == ElementKind::vertex && is_floating(column.type.scalar) && column.rule == ValueRule::blend;
}

// Puts what the step makes of the values of vertices; place_of(i) is the place of the i-th vertex in the step.
template <class PlaceOf>
void carry_vertices(const Mesh& mesh, const Creases& creases, const Step& step, std::size_t count,
                    const PlaceOf& place_of, const AttributeColumn& before, AttributeColumn& column) {
  column.data.resize(count * column.words());
  for (std::uint32_t first = 0; first < column.type.count; first += 3) {
    const Places values = step(mesh_of_values(mesh, before, first), creases);
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::uint32_t k = first; k < std::min(first + 3, column.type.count); ++k)
        put_real_number(column, i, k, values[place_of(i)][static_cast<int>(k - first)]);
  }
}

Step step_of_split(Scheme scheme, Split split) {
  return {[=](const Mesh& mesh, const Creases& creases) {
            return split_places(mesh, creases, scheme, SplitNumbers(mesh, split));
          },
          [=](const Mesh& mesh, const ValueBounds& bounds, Places& values) {
            const SplitNumbers n(mesh, split);
            keep_vertices_within(mesh, bounds, values);
            for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
              const auto [a, b] = ends(mesh, Edge(e));
              bounds.keep_within(values[n.on_edge(halfedge(Edge(e))).index], a, b);
            }
            for (std::uint32_t f = 0; split == Split::into_quads && f < mesh.face_slots(); ++f)
              if (mesh.is_alive(Face(f)))
                bounds.keep_within(values[n.centre(Face(f)).index], mesh.from(mesh.halfedge(Face(f))));
          }};
}

// Of the sqrt(3) scheme: behind the vertices the means of all faces, then two on each edge.
std::size_t centre_place(const Mesh& mesh, Face f) { return std::size_t{mesh.vertex_slots()} + f.index; }
std::size_t third_place(const Mesh& mesh, Halfedge h, unsigned i) {
  return std::size_t{mesh.vertex_slots()} + mesh.face_slots() + 2 * edge(h).index + ((h.index & 1u) ^ i);
}

Places all_sqrt3_places(const Mesh& mesh, const Creases& creases, bool cuts_creases) {
  Places places(std::size_t{mesh.vertex_slots()} + mesh.face_slots() + 2 * std::size_t{mesh.edge_slots()});
  sqrt3_places(mesh, creases, cuts_creases, places);
  for (const Face f : live_faces(mesh))
    for (const Vertex v : vertices_around(mesh, f)) places[centre_place(mesh, f)] += mesh.position(v) / 3.0;
  for (std::uint32_t i = 0; cuts_creases && i < mesh.halfedge_slots(); ++i)
    places[third_place(mesh, Halfedge(i), 0)] =
        third_of_crease(mesh, creases, mesh.from(Halfedge(i)), mesh.to(Halfedge(i)));
  return places;
}

Step step_of_sqrt3(bool cuts_creases) {
  return {[=](const Mesh& mesh, const Creases& creases) { return all_sqrt3_places(mesh, creases, cuts_creases); },
          [](const Mesh& mesh, const ValueBounds& bounds, Places& values) {
            keep_vertices_within(mesh, bounds, values);
            for (const Face f : live_faces(mesh))
              bounds.keep_within(values[centre_place(mesh, f)], mesh.from(mesh.halfedge(f)));
            for (Halfedge h(0); h.index < mesh.halfedge_slots(); ++h.index)
              bounds.keep_within(values[third_place(mesh, h, 0)], mesh.from(h), mesh.to(h));
          }};
}

// The corner attributes with pools: the values of the step become the pool. corners(charts, indices) gives each corner
// the index of its own.
template <class Corners>
void carry_pools(const Mesh& mesh, const Creases& creases, const Step& step, MeshColumns& out, const Corners& corners) {
  for (const CornerAttribute& attribute : corner_attributes(mesh)) {
    const Charts charts(mesh, creases, attribute);
    std::vector<std::uint32_t>& index = out.attributes[attribute.index_column].data;
    index.assign(out.halfedges.size(), no_index);
    corners(charts, index);
    AttributeColumn& pool = out.attributes[attribute.pool_column];
    const Places values = charts.values(step);
    pool.data.resize(values.size() * pool.words());
    if (!values.empty()) std::memcpy(pool.data.data(), values.data(), values.size() * sizeof values.front());
  }
}

bool is_in_pool(const Mesh& mesh, std::size_t attribute) {
  const std::vector<CornerAttribute> all = corner_attributes(mesh);
  return std::any_of(all.begin(), all.end(),
                     [&](const CornerAttribute& each) { return each.index_column == attribute; });
}

// Whether its rule divides a value by the shares of the parts.
bool divides_by_share(const AttributeColumn& column) {
  return column.rule == ValueRule::sum || column.rule == ValueRule::own;
}

// The sheets of an edge have one value; which part gets what no equal division leaves may be another on each.
template <class Numbers>
void share_among_sheets(const Mesh& mesh, const Numbers& numbers, AttributeColumn& column) {
  const std::size_t words = column.words();
  sheet_groups(mesh).for_each([&](std::span<const Edge> sheets) {
    std::vector<Edge> first;
    for (const Edge e : sheets) {
      Halfedge h = halfedge(e);
      if (point(mesh, mesh.from(h)) > point(mesh, mesh.to(h))) h = twin(h);
      const std::vector<Edge> parts = parts_of_edge(numbers, h);
      if (first.empty()) first = parts;
      for (std::size_t i = 0; i < std::min(first.size(), parts.size()); ++i)
        std::copy_n(column.data.data() + std::size_t{first[i].index} * words, words,
                    column.data.data() + std::size_t{parts[i].index} * words);
    }
  });
}

// All attributes: means of vertices and the values of pools by the step, the rest by the rules from the sources.
// place_of(i) is the place of vertex i in the step, places_of(charts) a function that gives that of a corner.
template <class Numbers, class PlaceOf, class PlacesOf>
void carry(const Mesh& mesh, const Creases& creases, const Numbers& numbers, const Step& step, const PlaceOf& place_of,
           const PlacesOf& places_of, MeshColumns& out) {
  SourceList vertices, edges, corners, faces;
  bool has_areas = false;
  out.attributes.assign(mesh.attributes().begin(), mesh.attributes().end());
  for (std::size_t i = 0; i < out.attributes.size(); ++i) {
    const AttributeColumn& before = mesh.attributes()[i];
    AttributeColumn& column = out.attributes[i];
    if (has_masks(before)) {
      carry_vertices(mesh, creases, step, out.vertex_halfedge.size(), place_of, before, column);
    } else if (before.element == ElementKind::vertex) {
      if (vertices.empty()) vertices = vertex_sources(mesh, numbers);
      column = vertices.derived(before);
    } else if (before.element == ElementKind::edge) {
      if (edges.empty()) edges = edge_sources(mesh, numbers);
      column = edges.derived(before);
      if (mesh.has_copies()) share_among_sheets(mesh, numbers, column);
    } else if (before.element == ElementKind::corner && !is_in_pool(mesh, i)) {
      if (corners.empty()) corners = corner_sources(mesh, numbers, out);
      column = corners.derived(before);
    } else if (before.element == ElementKind::face) {
      const bool by_area = divides_by_share(before);
      if (faces.empty() || (by_area && !has_areas)) faces = face_sources(mesh, numbers, out, by_area);
      has_areas = has_areas || by_area;
      column = faces.derived(before);
    }
  }
  carry_pools(mesh, creases, step, out, [&](const Charts& charts, std::vector<std::uint32_t>& to) {
    const auto place_in_charts = places_of(charts);
    place_corners(mesh, numbers, [&](Halfedge corner, CornerPlace place) {
      if (charts.of(place.h)) to[corner.index] = static_cast<std::uint32_t>(place_in_charts(place));
    });
  });
}

}  // namespace

void carry_split(const Mesh& mesh, const Creases& creases, Scheme scheme, const SplitNumbers& n, MeshColumns& out) {
  if (mesh.attributes().empty()) return;
  const auto places_of = [&](const Charts& charts) {
    return [&mesh, &charts, own = SplitNumbers(charts.mesh(), n.split())](CornerPlace place) {
      const Halfedge h = charts.of(place.h);
      return place.kind == CornerPlace::Kind::at       ? charts.mesh().from(h).index
             : place.kind == CornerPlace::Kind::centre ? own.centre(mesh.face(place.h)).index
                                                       : own.on_edge(h).index;
    };
  };
  carry(
      mesh, creases, n, step_of_split(scheme, n.split()), [](std::size_t vertex) { return vertex; }, places_of, out);
}

void carry_sqrt3(const Mesh& mesh, const Creases& creases, bool cuts_creases, const Sqrt3Numbers& n, MeshColumns& out) {
  if (mesh.attributes().empty()) return;
  std::vector<std::size_t> places(n.vertex_slots());
  std::iota(places.begin(), places.begin() + mesh.vertex_slots(), std::size_t{0});
  for (const Face f : live_faces(mesh))
    if (n.has_centre(f)) places[n.centre(f).index] = centre_place(mesh, f);
  for (Halfedge h(0); h.index < mesh.halfedge_slots(); ++h.index)
    if (n.is_cut(h)) places[n.third(h, 0).index] = third_place(mesh, h, 0);
  const auto places_of = [&](const Charts& charts) {
    return [&mesh, &charts](CornerPlace place) -> std::size_t {
      const Halfedge h = charts.of(place.h);
      if (place.kind == CornerPlace::Kind::at) return charts.mesh().from(h).index;
      if (place.kind == CornerPlace::Kind::centre) return centre_place(charts.mesh(), mesh.face(place.h));
      return third_place(charts.mesh(), h, place.kind == CornerPlace::Kind::second_third ? 1 : 0);
    };
  };
  carry(
      mesh, creases, n, step_of_sqrt3(cuts_creases), [&](std::size_t vertex) { return places[vertex]; }, places_of,
      out);
}

void carry_to_limit(const Mesh& mesh, const Creases& creases, Scheme scheme, MeshColumns& out) {
  if (mesh.attributes().empty()) return;
  const Step step{[=](const Mesh& own, const Creases& sharp) { return limit_places(own, sharp, scheme); },
                  keep_vertices_within};
  out.attributes.assign(mesh.attributes().begin(), mesh.attributes().end());
  for (std::size_t i = 0; i < out.attributes.size(); ++i)
    if (has_masks(mesh.attributes()[i]))
      carry_vertices(
          mesh, creases, step, mesh.vertex_slots(), [](std::size_t vertex) { return vertex; }, mesh.attributes()[i],
          out.attributes[i]);
  carry_pools(mesh, creases, step, out, [&](const Charts& charts, std::vector<std::uint32_t>& to) {
    for (Halfedge h(0); h.index < mesh.halfedge_slots(); ++h.index)
      if (!mesh.is_outside(h) && charts.of(h)) to[h.index] = charts.mesh().from(charts.of(h)).index;
  });
}

}  // namespace ryosen::subdivide
