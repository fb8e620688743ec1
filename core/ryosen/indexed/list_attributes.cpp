#include "ryosen/indexed/list_attributes.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {
namespace {

template <class T>
void copy_words(AttributeColumn& column, const std::vector<T>& values) {
  column.data.resize(values.size() * column.words());
  if (!values.empty()) std::memcpy(column.data.data(), values.data(), values.size() * sizeof(T));
}

void add_corner_values(const CornerValues& values, std::string_view index_name, std::string_view pool_name,
                       const CornerPairing& pairing, MeshColumns& c) {
  if (values.pool.empty() && values.index.empty()) return;
  auto [index, pool] = make_corner_columns(index_name, pool_name);
  index.data.assign(c.halfedges.size(), no_index);
  for (std::size_t corner = 0; corner < values.index.size(); ++corner)
    index.data[pairing.halfedge[corner].index] = values.index[corner];
  copy_words(pool, values.pool);
  c.attributes.push_back(std::move(index));
  c.attributes.push_back(std::move(pool));
}

void add_face_names(const FaceNames& names, std::string_view name, MeshColumns& c) {
  if (names.index.empty()) return;
  AttributeColumn column = make_column(name, ElementKind::face, ValueRule::first, no_index);
  column.data = names.index;
  c.attributes.push_back(std::move(column));
}

// One value per point; its copies take it too.
template <class T>
void add_point_values(const std::vector<T>& values, std::string_view name, const T& none, MeshColumns& c) {
  if (values.empty()) return;
  AttributeColumn column = make_column(name, ElementKind::vertex, ValueRule::blend, none);
  copy_words(column, values);
  column.data.resize(c.vertex_halfedge.size() * column.words());
  for (std::size_t v = values.size(); v < c.vertex_halfedge.size(); ++v)
    std::memcpy(column.data.data() + v * column.words(), &values[c.copy_point[v].index], sizeof(T));
  c.attributes.push_back(std::move(column));
}

void add_face_colours(const FaceColours& colours, MeshColumns& c) {
  if (colours.values.empty()) return;
  AttributeColumn values =
      make_column(attribute_names::face_colour, ElementKind::face, ValueRule::first, glm::dvec4(0.0));
  copy_words(values, colours.values);
  AttributeColumn components =
      make_column(attribute_names::face_colour_components, ElementKind::face, ValueRule::first, std::uint8_t{0});
  components.data.assign(colours.count.begin(), colours.count.end());
  c.attributes.push_back(std::move(values));
  c.attributes.push_back(std::move(components));
}

// The place of each edge of the mesh in the list of edges, no_index where that lacks it. O(edges log listed).
std::vector<std::uint32_t> listed_places(const IndexedMesh& source, const MeshColumns& c) {
  struct Place {
    std::pair<std::uint32_t, std::uint32_t> ends;
    std::uint32_t place;
  };
  const auto is_before = [](const Place& a, const Place& b) { return a.ends < b.ends; };
  std::vector<Place> listed;
  listed.reserve(source.edges.size());
  for (const ListedEdge& e : source.edges)
    listed.push_back({std::minmax({e.from, e.to}), static_cast<std::uint32_t>(listed.size())});
  std::stable_sort(listed.begin(), listed.end(), is_before);
  const auto point_of = [&](Vertex v) { return c.copy_point.empty() ? v.index : c.copy_point[v.index].index; };
  std::vector<std::uint32_t> places(c.halfedges.size() / 2, no_index);
  for (std::size_t e = 0; e < places.size(); ++e) {
    const Place sought{std::minmax({point_of(c.halfedges[2 * e].from), point_of(c.halfedges[2 * e + 1].from)}), 0};
    const auto found = std::lower_bound(listed.begin(), listed.end(), sought, is_before);
    if (found != listed.end() && found->ends == sought.ends) places[e] = found->place;
  }
  return places;
}

// An edge that is made of several has the first of their rows.
void least_row(const ValueSources& sources, std::uint32_t* value) {
  *value = no_index;
  for (std::size_t i = 0; i < sources.values.size(); ++i) *value = std::min(*value, sources.value<std::uint32_t>(i));
}

// The rows of edges, where a file lists some.
void add_edge_rows(const IndexedMesh& source, const std::vector<std::uint32_t>& places, MeshColumns& c) {
  if (std::none_of(source.edges.begin(), source.edges.end(), [](const ListedEdge& e) { return e.row != no_index; }))
    return;
  AttributeColumn column = make_column(attribute_names::edge_row, ElementKind::edge, ValueRule::own, no_index);
  column.own_rule = least_row;
  for (const std::uint32_t place : places) {
    const ListedEdge listed = place == no_index ? ListedEdge() : source.edges[place];
    column.data.push_back(listed.row == no_index ? no_index : 2 * listed.row + (listed.from > listed.to ? 1 : 0));
  }
  c.attributes.push_back(std::move(column));
}

// The place in the list of the value of each element of the mesh.
std::vector<std::uint32_t> places_of_values(ElementKind element, const CornerPairing& pairing,
                                            const std::vector<std::uint32_t>& edges, const MeshColumns& c) {
  std::vector<std::uint32_t> places;
  switch (element) {
    case ElementKind::vertex:
      places.resize(c.vertex_halfedge.size());
      for (std::uint32_t v = 0; v < places.size(); ++v) places[v] = c.copy_point.empty() ? v : c.copy_point[v].index;
      break;
    case ElementKind::edge:
      return edges;
    case ElementKind::corner:
      places.assign(c.halfedges.size(), no_index);
      for (std::uint32_t corner = 0; corner < pairing.halfedge.size(); ++corner)
        places[pairing.halfedge[corner].index] = corner;
      break;
    default:
      places.resize(c.face_halfedge.size());
      std::iota(places.begin(), places.end(), 0u);
  }
  return places;
}

void add_further_attributes(const IndexedMesh& source, const CornerPairing& pairing, MeshColumns& c) {
  std::vector<std::uint32_t> edges;
  if (!source.edges.empty())
    edges = listed_places(source, c);
  else
    edges.assign(c.halfedges.size() / 2, no_index);
  add_edge_rows(source, edges, c);
  for (const AttributeColumn& column : source.attributes)
    c.attributes.push_back(with_rows(column, places_of_values(column.element, pairing, edges, c)));
}

// The slot of each number in the list; of the copies of a point the smallest.
std::vector<std::uint32_t> slots_of(const std::vector<std::uint32_t>& numbers, std::size_t count) {
  std::vector<std::uint32_t> slots(count, no_index);
  for (std::size_t slot = numbers.size(); slot-- > 0;)
    if (numbers[slot] != no_index) slots[numbers[slot]] = static_cast<std::uint32_t>(slot);
  return slots;
}

bool is_default(const AttributeColumn& column, std::uint32_t index) {
  const std::size_t words = column.words();
  return std::equal(column.fill.begin(), column.fill.end(),
                    column.data.begin() + static_cast<std::ptrdiff_t>(index * words));
}

// Lists edges and returns their slots.
std::vector<std::uint32_t> list_edges(const Mesh& mesh, const std::vector<const AttributeColumn*>& columns,
                                      CompactMesh& out) {
  const AttributeColumn* const rows = find_column(mesh, attribute_names::edge_row);
  struct Listed {
    std::uint32_t row;
    std::pair<std::uint32_t, std::uint32_t> ends;
    std::uint32_t slot;
  };
  std::vector<Listed> listed;
  for (const Edge e : live_edges(mesh)) {
    const std::uint32_t row = rows ? rows->data[e.index] : no_index;
    if (row == no_index && std::all_of(columns.begin(), columns.end(),
                                       [&](const AttributeColumn* column) { return is_default(*column, e.index); }))
      continue;
    const std::pair ends =
        std::minmax({out.vertex_number[mesh.from(halfedge(e)).index], out.vertex_number[mesh.to(halfedge(e)).index]});
    listed.push_back({row, ends, e.index});
  }
  // The halves of an edge that are cut apart have the same values.
  std::sort(listed.begin(), listed.end(), [](const Listed& a, const Listed& b) {
    return std::tie(a.ends, a.row, a.slot) < std::tie(b.ends, b.row, b.slot);
  });
  const auto last =
      std::unique(listed.begin(), listed.end(), [](const Listed& a, const Listed& b) { return a.ends == b.ends; });
  listed.erase(last, listed.end());
  std::stable_sort(listed.begin(), listed.end(), [](const Listed& a, const Listed& b) { return a.row < b.row; });
  std::vector<std::uint32_t> slots;
  for (const Listed& e : listed) {
    const bool is_turned = e.row != no_index && e.row % 2 == 1;
    const auto [from, to] = is_turned ? std::pair(e.ends.second, e.ends.first) : e.ends;
    out.mesh.edges.push_back({from, to, e.row == no_index ? no_index : e.row / 2});
    slots.push_back(e.slot);
  }
  return slots;
}

}  // namespace

void add_attributes(const IndexedMesh& source, const CornerPairing& pairing, MeshColumns& c) {
  add_corner_values(source.texcoords, attribute_names::texcoord, attribute_names::texcoord_pool, pairing, c);
  add_corner_values(source.normals, attribute_names::normal, attribute_names::normal_pool, pairing, c);
  add_point_values(source.vertex_colours, attribute_names::colour, glm::dvec4(no_colour), c);
  add_point_values(source.vertex_weights, attribute_names::weight, std::numeric_limits<double>::quiet_NaN(), c);
  add_face_colours(source.face_colours, c);
  add_face_names(source.materials, attribute_names::material, c);
  add_face_names(source.groups, attribute_names::group, c);
  add_face_names(source.objects, attribute_names::object, c);
  add_face_names(source.smoothing, attribute_names::smoothing, c);
  if (!source.attributes.empty() || !source.edges.empty()) add_further_attributes(source, pairing, c);
}

bool has_free_attributes(const Mesh& mesh, ElementKind element) {
  const std::vector<const AttributeColumn*> all = free_attributes(mesh);
  return std::any_of(all.begin(), all.end(), [&](const AttributeColumn* column) { return column->element == element; });
}

void list_attributes(const Mesh& mesh, const std::vector<std::uint32_t>& corners, CompactMesh& out) {
  const std::vector<const AttributeColumn*> all = free_attributes(mesh);
  std::vector<const AttributeColumn*> of_edges;
  for (const AttributeColumn* const column : all)
    if (column->element == ElementKind::edge) of_edges.push_back(column);
  std::vector<std::uint32_t> edges, vertices, faces;
  if (!of_edges.empty() || find_column(mesh, attribute_names::edge_row)) edges = list_edges(mesh, of_edges, out);
  if (all.empty()) return;
  vertices = slots_of(out.vertex_number, out.mesh.positions.size());
  faces = slots_of(out.face_number, out.mesh.face_count());
  for (const AttributeColumn* const column : all) {
    const std::vector<std::uint32_t>* const rows[] = {&vertices, &edges, &corners, &faces};
    out.mesh.attributes.push_back(with_rows(*column, *rows[static_cast<std::size_t>(column->element)]));
  }
}

void restore_repeated(std::span<const RepeatedCorner> corners, CompactMesh& out) {
  for (const RepeatedCorner& corner : corners)
    for (const AttributeColumn& before : corner.face->values) {
      const auto column = std::find_if(
          out.mesh.attributes.begin(), out.mesh.attributes.end(),
          [&](const AttributeColumn& each) { return each.name == before.name && each.type == before.type; });
      if (column == out.mesh.attributes.end()) continue;
      const std::size_t words = before.words();
      std::uint32_t* const value = column->data.data() + corner.place * words;
      if (std::equal(value, value + words, before.data.data() + corner.first * words))
        std::copy_n(before.data.data() + corner.visit * words, words, value);
    }
}

std::vector<AttributeColumn> quarantined_attributes(const IndexedMesh& source) {
  std::vector<AttributeColumn> heads;
  for (const AttributeColumn& column : source.attributes)
    if (column.element == ElementKind::corner) heads.push_back(with_rows(column, {}));
  return heads;
}

void renew_quarantined_values(std::span<QuarantinedFace> faces, std::span<const AttributeColumn> before,
                              std::span<const AttributeColumn> now) {
  const auto is_of_corners = [](const AttributeColumn& column) { return column.element == ElementKind::corner; };
  if (before.empty() && std::none_of(now.begin(), now.end(), is_of_corners)) return;
  struct Place {
    std::size_t words_before;
    const AttributeColumn* column;
  };
  std::map<std::string_view, Place> places;
  std::size_t words_before = 0;
  for (const AttributeColumn& column : before) {
    places.try_emplace(column.name, Place{words_before, &column});
    words_before += column.words();
  }
  for (QuarantinedFace& face : faces) {
    std::vector<std::uint32_t> values;
    const std::size_t corners = face.corners.size();
    for (const AttributeColumn& column : now) {
      if (column.element != ElementKind::corner) continue;
      const auto same = places.find(column.name);
      const std::size_t words = corners * column.words();
      const bool is_there = same != places.end() && same->second.column->type == column.type &&
                            corners * words_before <= face.values.size();
      if (is_there) {
        const std::uint32_t* const first = face.values.begin() + corners * same->second.words_before;
        values.insert(values.end(), first, first + words);
      } else {
        for (std::size_t i = 0; i < corners; ++i) values.insert(values.end(), column.fill.begin(), column.fill.end());
      }
    }
    face.values = values;
  }
}

}  // namespace ryosen
