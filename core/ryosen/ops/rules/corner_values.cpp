#include "ryosen/ops/rules/corner_values.h"

#include <algorithm>
#include <glm/vec4.hpp>

namespace ryosen {

std::uint32_t CornerWriter::index(std::size_t attribute, Halfedge corner) const {
  return edit_.mesh().attributes()[attributes_[attribute].index_column].data[corner.index];
}

void CornerWriter::set(std::size_t attribute, Halfedge corner, std::uint32_t index) {
  edit_.set_attribute(attributes_[attribute].index_column, corner.index, std::span(&index, 1));
}

std::uint32_t CornerWriter::blend(std::size_t attribute, std::uint32_t a, std::uint32_t b, double t) {
  if (t == 0 || a == b) return a;
  if (t == 1) return b;
  if (a == no_index || b == no_index) return no_index;
  const std::size_t pool = attributes_[attribute].pool_column;
  const AttributeColumn& column = edit_.mesh().attributes()[pool];
  const auto va = attribute_value<glm::dvec3>(column, a), vb = attribute_value<glm::dvec3>(column, b);
  return edit_.append_value(pool, attribute_words(va + t * (vb - va)));
}

std::uint32_t CornerWriter::mean(std::size_t attribute, std::span<const Halfedge> at) {
  const std::uint32_t first = index(attribute, at[0]);
  bool all_equal = true;
  for (Halfedge h : at) {
    if (index(attribute, h) == no_index) return no_index;
    all_equal = all_equal && index(attribute, h) == first;
  }
  if (all_equal) return first;
  const std::size_t pool = attributes_[attribute].pool_column;
  glm::dvec3 mean{};
  for (Halfedge h : at)
    mean += attribute_value<glm::dvec3>(edit_.mesh().attributes()[pool], index(attribute, h)) /
            static_cast<double>(at.size());
  return edit_.append_value(pool, attribute_words(mean));
}

bool is_seam(const Mesh& mesh, Halfedge h) {
  return !mesh.is_outside(h) && !mesh.is_outside(twin(h)) && corner_values_differ(mesh, h, twin(h), false);
}

// Merges the corner `first`, the ones across the removed edges in sequence, and `last`, whose edge stays.
void merge_corner_values(Edit& edit, std::span<const Edge> edges_that_go, const NumberOfFace& number) {
  const Mesh& m = edit.mesh();
  const auto goes = [&](Halfedge h) { return std::binary_search(edges_that_go.begin(), edges_that_go.end(), edge(h)); };
  CornerWriter corners(edit);
  if (corners.count() == 0) return;
  for (Edge e : edges_that_go)
    for (Halfedge first : {halfedge(e), twin(halfedge(e))}) {
      if (goes(m.prev(first))) continue;
      Halfedge kept = first, last = first;
      while (goes(last)) {
        last = m.next(twin(last));
        if (number(m.face(last)) <= number(m.face(kept))) kept = last;
      }
      for (std::size_t k = 0; k < corners.count() && kept != last; ++k) corners.set(k, last, corners.index(k, kept));
    }
}

void copy_face_values(Edit& edit, Face from, Face to) {
  for (std::size_t k = 0; k < edit.mesh().attributes().size(); ++k) {
    const AttributeColumn& column = edit.mesh().attributes()[k];
    if (column.element != ElementKind::face) continue;
    const auto* begin = column.data.data() + std::size_t{from.index} * column.words;
    const std::vector<std::uint32_t> words(begin, begin + column.words);
    edit.set_attribute(k, to.index, words);
  }
}

void blend_vertex_values(Edit& edit, Vertex a, Vertex b, double t, Vertex to) {
  for (std::size_t k = 0; k < edit.mesh().attributes().size(); ++k) {
    const AttributeColumn& column = edit.mesh().attributes()[k];
    if (column.element != ElementKind::vertex) continue;
    const auto* begin = column.data.data() + std::size_t{a.index} * column.words;
    std::vector<std::uint32_t> words(begin, begin + column.words);
    if (column.words == sizeof(glm::dvec4) / 4) {
      const auto va = attribute_value<glm::dvec4>(column, a.index), vb = attribute_value<glm::dvec4>(column, b.index);
      const auto blended = attribute_words(va + t * (vb - va));
      words.assign(blended.begin(), blended.end());
    }
    edit.set_attribute(k, to.index, words);
  }
}

void mean_vertex_values(Edit& edit, std::span<const Vertex> from, Vertex to) {
  blend_vertex_values(edit, from[0], from[0], 0, to);
  for (std::size_t k = 0; k < edit.mesh().attributes().size(); ++k) {
    const AttributeColumn& column = edit.mesh().attributes()[k];
    if (column.element != ElementKind::vertex || column.words != sizeof(glm::dvec4) / 4) continue;
    glm::dvec4 mean{};
    for (Vertex v : from) mean += attribute_value<glm::dvec4>(column, v.index) / static_cast<double>(from.size());
    edit.set_attribute(k, to.index, attribute_words(mean));
  }
}

}  // namespace ryosen
