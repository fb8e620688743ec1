// Reads the records of a form link by link, as the texts' algorithms do, and counts which of them it has read. All
// elements are slots of the mesh that the form was made of.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ryosen/mesh/mesh.h"
#include "ryosen/textbook/forms/records.h"

namespace ryosen::forms {

class RecordReader {
 public:
  // The mesh is needed as long as the reader.
  RecordReader(const Mesh& mesh, const FormRow& row);

  const Mesh& mesh() const { return mesh_; }
  const FormRow& row() const { return records_.row(); }
  // Null where the form can hold the mesh.
  const std::optional<Text>& unsuitable() const { return unsuitable_; }
  // Whether the form stores a field of elements of a kind; asked of the first live one, without reading it.
  bool stores(Element::Kind kind, std::string_view key) const;

  // The element, of this kind, that a field of a record leads to; its index is none where the field is none.
  Element link(Element of, std::string_view key);
  std::vector<Element> links(Element of, std::string_view key);
  // The places that a face stores; empty where it stores vertices.
  std::vector<glm::dvec3> places(Face f);

  // In the order in which they were read first, each once.
  const std::vector<Element>& read() const { return order_; }
  // Nothing has been read.
  void begin_anew();

 private:
  const Field* field(Element of, std::string_view key);

  const Mesh& mesh_;
  Records records_;
  std::optional<Text> unsuitable_;
  std::vector<bool> seen_[4];  // by Element::Kind and slot
  std::vector<Element> order_;
  ElementRecord last_;  // of last_element_
  std::optional<Element> last_element_;
};

// The accessors of forms/walk.h over the records of a form whose halfedges are linked, or numbered 3i+j. Numbers are
// slots of halfedges; the vertex walk starts at what the vertex stores.
class RecordLinks {
 public:
  explicit RecordLinks(RecordReader& reader);

  std::uint32_t from(std::uint32_t h) const { return reader_.link(Halfedge(h), "from").index; }
  std::uint32_t next(std::uint32_t h) const;
  std::uint32_t prev(std::uint32_t h) const;
  std::uint32_t pair(std::uint32_t h) const;
  std::uint32_t face(std::uint32_t h) const;
  std::uint32_t at_vertex(std::uint32_t v) const { return reader_.link(Vertex(v), "halfedge").index; }
  std::uint32_t at_face(std::uint32_t f) const;
  std::uint32_t at_edge(std::uint32_t h) const { return h; }
  std::vector<std::uint32_t> inner(std::uint32_t f) const;

 private:
  RecordReader& reader_;
  bool has_next_, has_twin_, has_inner_;
  std::string_view first_of_face_;        // empty: 3i
  std::vector<Halfedge> corners_;         // without links: the slot of each 3i+j
  std::vector<std::uint32_t> corner_of_;  // and back
};

}  // namespace ryosen::forms
