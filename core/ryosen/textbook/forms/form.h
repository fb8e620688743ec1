// A form: a data structure of the source texts for polygon models. Converts from and to Mesh and answers the nine
// incidence relations between vertices, edges and faces.
//
// Vertices (points) and faces are numbered from 0 without gaps in the order of the mesh, as a saved file numbers them.
// An edge is returned as the pair of its ends, because most forms do not number edges; in queries it is given by a
// form-specific handle. A form answers from its own data, never from the mesh it was made from.
#pragma once

#include <compare>
#include <cstdint>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/base/handle.h"
#include "ryosen/base/message.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::forms {

// "vertex_faces": the faces at a vertex. Two edges are neighbours if they share an end, two faces if they share an
// edge. The valence is the number of edges at a vertex.
enum class Relation : std::uint8_t {
  vertex_vertices,
  vertex_edges,
  vertex_faces,
  edge_vertices,
  edge_edges,
  edge_faces,
  face_vertices,
  face_edges,
  face_faces,
  valence
};
inline constexpr std::size_t relation_count = enum_count<Relation>;

enum class ElementOf : std::uint8_t { vertex, edge, face };
struct RelationRow {
  Relation relation;
  std::string_view id;
  ElementOf asks;  // the kind of element queried
  std::string_view en, ja;
};
// In the order of the enum.
std::span<const RelationRow> relations();

// The two ends of an edge, the smaller number first.
struct EdgeEnds {
  std::uint32_t a = no_index, b = no_index;

  friend auto operator<=>(const EdgeEnds&, const EdgeEnds&) = default;
};
constexpr EdgeEnds edge_ends(std::uint32_t a, std::uint32_t b) { return a < b ? EdgeEnds{a, b} : EdgeEnds{b, a}; }

// Each element once. vertex_vertices, vertex_faces, edge_vertices, edge_faces, face_vertices, face_faces and valence
// (one number) fill `numbers`, the others `edges`. face_vertices and face_edges come in the order of the face, its
// first corner (and the side that starts there) first, then its inner loops; a bridge and its ends occur as often as
// the face visits them. The rest is in any order.
struct Answer {
  std::vector<std::uint32_t> numbers;
  std::vector<EdgeEnds> edges;

  void clear() {
    numbers.clear();
    edges.clear();
  }
};

// A field of the record that a form stores of one element, in the order of the source text's table, with the text's own
// words: a link to an element, several, or places. In what a form returns the links hold the form's own numbers; in
// what Records (records.h) returns they hold slots of the mesh. A link without an index leads nowhere.
struct Field {
  std::string_view key;   // Ryosen's word, the same in every form
  std::string_view word;  // the source text's
  bool is_list = false;   // whether it holds a list of links; places are one of a vertex, or several
  std::vector<Element> links;
  std::vector<glm::dvec3> places;
  // The stored value of each link; nullopt for none. Differs from the link's number where the form codes it.
  std::vector<std::optional<std::int64_t>> stored;
};
using Fields = std::vector<Field>;

inline std::optional<std::int64_t> stored_number(std::uint32_t number) {
  return number == no_index ? std::nullopt : std::optional<std::int64_t>(number);
}

template <class Handle>
Field link(std::string_view key, std::string_view word, Handle to) {
  return {key, word, false, {Element(to)}, {}, {stored_number(to.index)}};
}
template <class Handle>
Field links(std::string_view key, std::string_view word, const std::vector<Handle>& to) {
  Field field{key, word, true, {}, {}, {}};
  for (const Handle one : to) {
    field.links.push_back(Element(one));
    field.stored.push_back(stored_number(one.index));
  }
  return field;
}
inline Field place(std::string_view word, const glm::dvec3& at) { return {"position", word, false, {}, {at}, {}}; }
inline Field places(std::string_view word, std::vector<glm::dvec3> at) {
  return {"positions", word, true, {}, std::move(at), {}};
}

class Form {
 public:
  virtual ~Form() = default;

  // Size of the stored data, positions included, without spare capacity.
  virtual std::size_t bytes() const = 0;
  // Built from the stored data; without attributes.
  virtual Mesh to_mesh() const = 0;
  // The form's handle of the edge between two vertices, or no_index if there is none or the form has no edges, as one
  // that stores places alone.
  virtual std::uint32_t find_edge(std::uint32_t, std::uint32_t) const { return no_index; }
  // Answers a query about an existing vertex, edge (by handle) or face. False: the form cannot answer it, as one that
  // stores places alone.
  virtual bool answer(Relation, std::uint32_t, Answer& out) const {
    out.clear();
    return false;
  }
  // What is stored of an element, given and linked by the form's own numbers: vertices, edges and faces in the order of
  // the mesh, halfedges as the row says. Empty where nothing is stored of its kind.
  virtual Fields record(Element own) const = 0;
};

// answer() of a form that answers about each kind of element by a function of its own.
template <class AboutVertex, class AboutEdge, class AboutFace>
bool answer_by_element(Relation relation, Answer& out, const AboutVertex& about_vertex, const AboutEdge& about_edge,
                       const AboutFace& about_face) {
  out.clear();
  switch (relations()[static_cast<std::size_t>(relation)].asks) {
    case ElementOf::vertex:
      about_vertex();
      break;
    case ElementOf::edge:
      about_edge();
      break;
    case ElementOf::face:
      about_face();
      break;
  }
  return true;
}

// Answers about a vertex of a form that stores no link from it, by a search through the sides of all faces. Fills
// `out`, which is empty, for a relation that asks about a vertex. for_each_side(visit) calls visit(face, ends) for
// every side of every face. O(sides).
template <class ForEachSide>
void answer_by_all_sides(Relation relation, std::uint32_t v, ForEachSide for_each_side, Answer& out) {
  for_each_side([&](std::uint32_t f, EdgeEnds ends) {
    if (ends.a != v && ends.b != v) return;
    if (relation == Relation::vertex_faces)
      out.numbers.push_back(f);
    else if (relation == Relation::vertex_edges)
      out.edges.push_back(ends);
    else
      out.numbers.push_back(ends.a == v ? ends.b : ends.a);
  });
  sort_unique(out.numbers);
  sort_unique(out.edges);
  if (relation == Relation::valence) out.numbers = {static_cast<std::uint32_t>(out.numbers.size())};
}

// What a form requires of a mesh; a combination of bits.
enum Needs : std::uint32_t {
  any_mesh = 0,
  triangles = 1,             // every face has three corners
  one_vertex_per_point = 2,  // no point has copies: no non-manifold or misoriented edge, no bow-tie
  one_fan_per_vertex = 4,    // the faces at a vertex form one fan
  no_wires = 8,              // every edge has a face
  no_isolated_vertices = 16,
  different_places = 32,  // no two points with equal coordinates, and none that is not finite
  no_rings = 64,          // faces without inner loops
  no_bridges = 128,       // no edge with one face on both sides
};

// Which halfedges a form numbers: none; those of faces, as the corners run; or all, in the order of the mesh.
enum class HalfedgesOf : std::uint8_t { none, faces, all };

struct FormRow {
  std::string_view id;
  std::string_view en, ja;
  std::string_view source_en, source_ja;  // where the source texts show it
  std::uint32_t needs;
  // False for one that stores places alone: it answers no relation, and the conversion back numbers the vertices by
  // their first corner.
  bool stores_vertices;
  HalfedgesOf halfedges;
  bool holds_copies;  // its vertices are those of the mesh; else points
  // The mesh must be suitable.
  std::unique_ptr<Form> (*make)(const Mesh& mesh);
};

// Why the mesh does not meet the needs, naming the first offending element; none if it is suitable. O(n).
std::optional<Text> why_unsuitable(const Mesh& mesh, std::uint32_t needs);
inline std::optional<Text> why_unsuitable(const Mesh& mesh, const FormRow& row) {
  return why_unsuitable(mesh, row.needs);
}

}  // namespace ryosen::forms
