#include "tests/support/core/element_values.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/live_elements.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {

namespace {

std::int64_t whole_number(std::uint64_t a, std::uint64_t b) {
  Dice dice(a << 32u | b);
  return static_cast<std::int64_t>(dice.below(2000)) - 1000;
}

std::vector<std::uint32_t> words_at(const AttributeColumn& column, std::uint32_t index) {
  const auto begin = column.data.begin() + std::ptrdiff_t{index} * column.words();
  return {begin, begin + column.words()};
}

}  // namespace

void add_values(Mesh& mesh, Journal* journal) {
  Edit edit(mesh, journal);
  const auto add = [&](std::string_view name, ElementKind kind, ValueRule rule, auto fill) {
    using T = decltype(fill);
    const std::size_t k = edit.add_attribute(name, kind, rule, fill);
    const auto put = [&](std::uint32_t index, std::uint64_t x, std::uint64_t y) {
      edit.set_attribute(k, index, attribute_words(static_cast<T>(whole_number(x, y))));
    };
    if (kind == ElementKind::face)
      for (const Face f : live_faces(mesh)) put(f.index, f.index, k);
    if (kind == ElementKind::vertex)
      for (const Vertex v : live_vertices(mesh)) put(v.index, point(mesh, v).index, k);
    if (kind == ElementKind::corner)
      for (const Edge e : live_edges(mesh))
        for (const Halfedge h : {halfedge(e), twin(halfedge(e))})
          if (!mesh.is_outside(h)) put(h.index, h.index, k);
    if (kind == ElementKind::edge)
      for (const Edge e : live_edges(mesh)) {
        const auto [a, b] = std::minmax({point(mesh, ends(mesh, e).first), point(mesh, ends(mesh, e).second)});
        put(e.index, a.index, b.index);
      }
  };
  add("face.count", ElementKind::face, ValueRule::sum, std::int64_t{0});
  add("face.area", ElementKind::face, ValueRule::sum, 0.0);
  add("face.mean", ElementKind::face, ValueRule::blend, 0.5);
  add("face.mark", ElementKind::face, ValueRule::first, std::int64_t{0});
  add("edge.count", ElementKind::edge, ValueRule::sum, std::int64_t{0});
  add("edge.length", ElementKind::edge, ValueRule::sum, 0.0);
  add("edge.crease", ElementKind::edge, ValueRule::blend, -1.0);
  add("corner.mark", ElementKind::corner, ValueRule::first, std::int32_t{-7});
  add("corner.mean", ElementKind::corner, ValueRule::blend, 0.25);
  add("vertex.mass", ElementKind::vertex, ValueRule::sum, 0.0);
  add("vertex.top", ElementKind::vertex, ValueRule::greatest, std::int16_t{0});
  add("vertex.mean", ElementKind::vertex, ValueRule::blend, 0.0f);
  add("vertex.mark", ElementKind::vertex, ValueRule::first, std::uint32_t{0});
  edit.commit();
}

void expect_copies_agree(const Mesh& mesh) {
  for (const AttributeColumn& column : mesh.attributes()) {
    std::map<std::pair<Vertex, Vertex>, Edge> edges;
    if (column.is_of(ElementKind::vertex)) {
      for (const Vertex v : live_vertices(mesh))
        ASSERT_EQ(words_at(column, v.index), words_at(column, point(mesh, v).index)) << column.name << " v" << v.index;
    }
    if (!column.is_of(ElementKind::edge)) continue;
    for (const Edge e : live_edges(mesh)) {
      const auto [a, b] = ends(mesh, e);
      const auto [first, is_new] = edges.emplace(std::minmax({point(mesh, a), point(mesh, b)}), e);
      ASSERT_EQ(words_at(column, e.index), words_at(column, first->second.index)) << column.name << " e" << e.index;
    }
  }
}

ElementValues values_of(const Mesh& mesh) {
  std::vector<bool> has_pool(mesh.attributes().size());
  for (const CornerAttribute& each : corner_attributes(mesh)) has_pool[each.index_column] = true;
  ElementValues values;
  for (std::size_t k = 0; k < mesh.attributes().size(); ++k) {
    const AttributeColumn& column = mesh.attributes()[k];
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t index) {
      values[{column.name, a, b}] = words_at(column, index);
    };
    if (column.is_of(ElementKind::vertex))
      for (const Vertex v : live_vertices(mesh)) add(v.index, 0, v.index);
    if (column.is_of(ElementKind::edge))
      for (const Edge e : live_edges(mesh)) {
        const auto [a, b] = std::minmax({ends(mesh, e).first.index, ends(mesh, e).second.index});
        add(a, b, e.index);
      }
    for (const Face f : live_faces(mesh)) {
      if (column.is_of(ElementKind::face)) add(f.index, 0, f.index);
      if (column.is_of(ElementKind::corner) && !has_pool[k])
        for (const Halfedge h : halfedges_around(mesh, f)) add(f.index, mesh.from(h).index, h.index);
    }
  }
  return values;
}

}  // namespace ryosen::test
