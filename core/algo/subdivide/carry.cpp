#include "core/algo/subdivide/carry.h"

#include <glm/vec4.hpp>

#include "core/mesh/attribute.h"
#include "core/mesh/circulate.h"

namespace ryosen::subdivide {

namespace {

// The values of one corner attribute: those that are there, and new ones appended to the pool.
class CornerBlends {
 public:
  CornerBlends(const Mesh& mesh, const CornerAttribute& attribute, MeshColumns& out)
      : mesh_(mesh),
        index_(mesh.attributes()[attribute.index_column].data),
        pool_(out.attributes[attribute.pool_column]) {}

  std::uint32_t at(Halfedge corner) const { return index_[corner.index]; }

  std::uint32_t blend(std::uint32_t a, std::uint32_t b, double t) {
    if (a == b) return a;
    if (a == no_index || b == no_index) return no_index;
    const auto from = attribute_value<glm::dvec3>(pool_, a), to = attribute_value<glm::dvec3>(pool_, b);
    return append(from + t * (to - from));
  }

  // Beside a halfedge with a face, along its side.
  std::uint32_t on_side(Halfedge h, double t) { return blend(at(h), at(mesh_.next(h)), t); }

  std::uint32_t at_centre(Face f) {
    std::uint32_t first = no_index;
    bool is_first = true, all_equal = true;
    double corners = 0;
    for (const Halfedge h : loop(mesh_, mesh_.halfedge(f))) {
      if (at(h) == no_index) return no_index;
      if (is_first) first = at(h);
      is_first = false;
      all_equal = all_equal && at(h) == first;
      ++corners;
    }
    if (all_equal) return first;
    glm::dvec3 mean(0);
    for (const Halfedge h : loop(mesh_, mesh_.halfedge(f))) mean += attribute_value<glm::dvec3>(pool_, at(h)) / corners;
    return append(mean);
  }

  // Of both sides of all edges in the middle; one value where both sides have the same at both ends.
  std::vector<std::uint32_t> in_middles() {
    std::vector<std::uint32_t> found(mesh_.halfedge_slots(), no_index);
    for (std::uint32_t e = 0; e < mesh_.edge_slots(); ++e) {
      const Halfedge h = halfedge(Edge(e)), t = twin(h);
      const bool has_h = !mesh_.is_outside(h), has_t = !mesh_.is_outside(t);
      if (has_h) found[h.index] = on_side(h, 0.5);
      if (!has_t) continue;
      const bool is_same = has_h && at(h) == at(mesh_.next(t)) && at(t) == at(mesh_.next(h));
      found[t.index] = is_same ? found[h.index] : on_side(t, 0.5);
    }
    return found;
  }

  std::vector<std::uint32_t> in_centres() {
    std::vector<std::uint32_t> found(mesh_.face_slots(), no_index);
    for (std::uint32_t f = 0; f < mesh_.face_slots(); ++f)
      if (mesh_.is_alive(Face(f))) found[f] = at_centre(Face(f));
    return found;
  }

 private:
  std::uint32_t append(const glm::dvec3& value) {
    const std::size_t place = pool_.data.size();
    pool_.data.resize(place + sizeof value / sizeof(std::uint32_t));
    std::memcpy(pool_.data.data() + place, &value, sizeof value);
    return static_cast<std::uint32_t>(place / pool_.words);
  }

  const Mesh& mesh_;
  const std::vector<std::uint32_t>& index_;
  AttributeColumn& pool_;
};

// One column of values per vertex: those of doubles are blended, others are those of the first.
class VertexBlends {
 public:
  VertexBlends(AttributeColumn& column, std::size_t vertices) : column_(column) {
    column.data.resize(vertices * column.words);
  }

  void blend(Vertex a, Vertex b, double t, Vertex to) {
    const std::uint32_t* const from = column_.data.data() + std::size_t{a.index} * column_.words;
    std::copy(from, from + column_.words, cell(to));
    if (!has_doubles()) return;
    const glm::dvec4 first = value(a), second = value(b);
    put(to, first + t * (second - first));
  }
  void mean(const Mesh& mesh, Face f, Vertex to) {
    const Vertex start = mesh.from(mesh.halfedge(f));
    blend(start, start, 0, to);
    if (!has_doubles()) return;
    double corners = 0;
    for ([[maybe_unused]] const Halfedge h : loop(mesh, mesh.halfedge(f))) ++corners;
    glm::dvec4 sum(0);
    for (const Halfedge h : loop(mesh, mesh.halfedge(f))) sum += value(mesh.from(h)) / corners;
    put(to, sum);
  }

 private:
  bool has_doubles() const { return column_.words == sizeof(glm::dvec4) / sizeof(std::uint32_t); }
  std::uint32_t* cell(Vertex v) { return column_.data.data() + std::size_t{v.index} * column_.words; }
  glm::dvec4 value(Vertex v) const { return attribute_value<glm::dvec4>(column_, v.index); }
  void put(Vertex v, const glm::dvec4& value) { std::memcpy(cell(v), &value, sizeof value); }

  AttributeColumn& column_;
};

// Each new face as the one it comes of.
template <class Child>
void carry_faces(const Mesh& mesh, AttributeColumn& column, std::size_t faces, const Child& child) {
  column.data.resize(faces * column.words);
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (mesh.is_outside(h)) continue;
    const Face from = mesh.face(h), to = child(h);
    const std::uint32_t* const words = column.data.data() + std::size_t{from.index} * column.words;
    if (from != to) std::copy(words, words + column.words, column.data.data() + std::size_t{to.index} * column.words);
  }
}

void carry_split_corners(const Mesh& mesh, const SplitNumbers& n, CornerBlends& values,
                         std::vector<std::uint32_t>& to) {
  const bool into_quads = n.split() == Split::into_quads;
  const std::vector<std::uint32_t> middles = values.in_middles();
  std::vector<std::uint32_t> centres;
  if (into_quads) centres = values.in_centres();
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (mesh.is_outside(h)) continue;
    to[first_half(h).index] = values.at(h);
    to[second_half(h).index] = middles[i];
    to[n.inner(h).index] = into_quads ? middles[i] : middles[mesh.prev(h).index];
    to[twin(n.inner(h)).index] = into_quads ? centres[mesh.face(h).index] : middles[i];
  }
}

void carry_sqrt3_corners(const Mesh& mesh, const Sqrt3Numbers& n, CornerBlends& values,
                         std::vector<std::uint32_t>& to) {
  const std::vector<std::uint32_t> centres = values.in_centres();
  std::vector<std::array<std::uint32_t, 2>> thirds(mesh.halfedge_slots(), {no_index, no_index});
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i)
    if (const Halfedge h(i); !mesh.is_outside(h) && n.is_cut(h))
      thirds[i] = {values.on_side(h, 1.0 / 3), values.on_side(h, 2.0 / 3)};
  const auto at_apex = [&](Halfedge h) {
    const Halfedge side = n.cut_side(h);
    return side ? thirds[side.index][h == mesh.next(side) ? 1 : 0] : centres[mesh.face(h).index];
  };
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (mesh.is_outside(h)) continue;
    if (n.is_cut(h)) {
      to[n.part(h, 0).index] = values.at(h);
      to[n.part(h, 1).index] = thirds[i][0];
      to[n.part(h, 2).index] = thirds[i][1];
      to[twin(n.spoke(h)).index] = thirds[i][1];
      to[n.spoke(mesh.prev(h)).index] = values.at(mesh.prev(h));
      continue;
    }
    to[n.before(h).index] = at_apex(h);
    if (n.is_kept(h)) {
      to[i] = values.at(h);
      to[n.after(h).index] = values.at(mesh.next(h));
    } else {
      to[i] = at_apex(twin(h));
      to[n.after(twin(h)).index] = values.at(h);
    }
  }
}

// Calls carry(values, indices) for each corner attribute, and gives the vertex and face columns to the others.
template <class Corners, class Vertices, class Faces>
void carry_columns(const Mesh& mesh, MeshColumns& out, const Corners& corners, const Vertices& vertices,
                   const Faces& faces) {
  out.attributes.assign(mesh.attributes().begin(), mesh.attributes().end());
  for (AttributeColumn& column : out.attributes) {
    if (column.element == ElementKind::vertex) vertices(column);
    if (column.element == ElementKind::face) faces(column);
    if (column.element != ElementKind::corner) continue;
    column.data.clear();
    for (std::size_t i = 0; i < out.halfedges.size(); ++i)
      column.data.insert(column.data.end(), column.fill.begin(), column.fill.end());
  }
  for (const CornerAttribute& attribute : corner_attributes(mesh)) {
    CornerBlends values(mesh, attribute, out);
    corners(values, out.attributes[attribute.index_column].data);
  }
}

}  // namespace

void carry_split(const Mesh& mesh, const SplitNumbers& n, MeshColumns& out) {
  if (mesh.attributes().empty()) return;
  const auto corners = [&](CornerBlends& values, std::vector<std::uint32_t>& to) {
    carry_split_corners(mesh, n, values, to);
  };
  const auto vertices = [&](AttributeColumn& column) {
    VertexBlends values(column, n.vertex_slots());
    for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
      const auto [a, b] = ends(mesh, Edge(e));
      values.blend(a, b, 0.5, n.on_edge(halfedge(Edge(e))));
    }
    for (std::uint32_t f = 0; n.split() == Split::into_quads && f < mesh.face_slots(); ++f)
      if (mesh.is_alive(Face(f))) values.mean(mesh, Face(f), n.centre(Face(f)));
  };
  const auto faces = [&](AttributeColumn& column) {
    carry_faces(mesh, column, n.face_slots(), [&](Halfedge h) { return n.at_corner(h); });
  };
  carry_columns(mesh, out, corners, vertices, faces);
}

void carry_sqrt3(const Mesh& mesh, const Sqrt3Numbers& n, MeshColumns& out) {
  if (mesh.attributes().empty()) return;
  const auto corners = [&](CornerBlends& values, std::vector<std::uint32_t>& to) {
    carry_sqrt3_corners(mesh, n, values, to);
  };
  const auto vertices = [&](AttributeColumn& column) {
    VertexBlends values(column, n.vertex_slots());
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f)
      if (n.has_centre(Face(f))) values.mean(mesh, Face(f), n.centre(Face(f)));
    for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
      const Halfedge h = halfedge(Edge(e));
      for (unsigned i = 0; n.is_cut(h) && i < 2; ++i)
        values.blend(mesh.from(h), mesh.to(h), (1.0 + i) / 3, n.third(h, i));
    }
  };
  const auto faces = [&](AttributeColumn& column) {
    carry_faces(mesh, column, n.face_slots(), [&](Halfedge h) { return n.triangle(h); });
  };
  carry_columns(mesh, out, corners, vertices, faces);
}

}  // namespace ryosen::subdivide
