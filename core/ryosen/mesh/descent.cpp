#include "ryosen/mesh/descent.h"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

#include "ryosen/mesh/attribute.h"

namespace ryosen {

namespace {

constexpr std::string_view origin_column = "face.origin";

// Where elements of a kind stand in a list, by slot; no_index where they do not.
class Standing {
 public:
  Standing(std::span<const Element> elements, Element::Kind kind) {
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
      if (elements[i].kind != kind) continue;
      if (at_.size() <= elements[i].index) at_.resize(std::size_t{elements[i].index} + 1, no_index);
      at_[elements[i].index] = i;
    }
  }
  std::uint32_t of(std::uint32_t slot) const { return slot < at_.size() ? at_[slot] : no_index; }

 private:
  std::vector<std::uint32_t> at_;
};

}  // namespace

void add_origins(MeshColumns& columns) {
  AttributeColumn column = make_column(origin_column, ElementKind::face, ValueRule::first, no_index);
  column.data.resize(columns.face_halfedge.size());
  std::iota(column.data.begin(), column.data.end(), 0u);
  columns.attributes.push_back(std::move(column));
}

Mesh with_origins(const Mesh& mesh) {
  MeshColumns columns = mesh.columns();
  add_origins(columns);
  return Mesh(std::move(columns));
}

std::vector<Face> take_origins(MeshColumns& columns) {
  const auto column = std::find_if(columns.attributes.begin(), columns.attributes.end(),
                                   [](const AttributeColumn& each) { return each.name == origin_column; });
  std::vector<Face> origins(column->data.begin(), column->data.end());
  columns.attributes.erase(column);
  return origins;
}

std::vector<Edge> own_edges(std::uint32_t count) {
  std::vector<Edge> edges;
  edges.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) edges.emplace_back(i);
  return edges;
}

std::vector<Element> descended(const Mesh& mesh, const Descent& descent, std::span<const Element> elements) {
  std::vector<std::pair<std::uint32_t, Element>> found;  // with where that stands of which they come
  const auto add = [&](std::uint32_t standing, const Element& e) {
    if (standing != no_index) found.emplace_back(standing, e);
  };
  for (std::uint32_t i = 0; i < elements.size(); ++i)
    if (const Vertex v = elements[i].vertex(); elements[i].kind == Element::Kind::vertex)
      if (mesh.exists(v) && mesh.is_alive(v)) add(i, v);
  const Standing faces(elements, Element::Kind::face), edges(elements, Element::Kind::edge),
      halves(elements, Element::Kind::halfedge);
  for (Face f(0); f.index < descent.faces.size(); ++f.index)
    if (mesh.is_alive(f)) add(faces.of(descent.faces[f.index].index), f);
  for (Edge e(0); e.index < descent.edges.size(); ++e.index) {
    const Edge origin = descent.edges[e.index];
    if (!origin || !mesh.is_alive(e)) continue;
    add(edges.of(origin.index), e);
    for (const unsigned side : {0u, 1u}) add(halves.of(halfedge(origin, side).index), halfedge(e, side));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Element> all;
  all.reserve(found.size());
  for (const auto& [standing, e] : found) all.push_back(e);
  return all;
}

}  // namespace ryosen
