#include "ryosen/textbook/forms/reading/record_reader.h"

#include "ryosen/mesh/live_elements.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

namespace {

std::optional<Element> first_live(const Mesh& mesh, Element::Kind kind) {
  const auto first = [](auto elements) -> std::optional<Element> {
    for (const auto element : elements) return element;
    return {};
  };
  switch (kind) {
    case Element::Kind::vertex:
      return first(live_vertices(mesh));
    case Element::Kind::halfedge:
      // One with a face: forms whose halfedges are corners store nothing of the others.
      for (const Face f : live_faces(mesh)) return mesh.halfedge(f);
      return first(live_halfedges(mesh));
    case Element::Kind::edge:
      return first(live_edges(mesh));
    default:
      return first(live_faces(mesh));
  }
}

const Field* field_of(const Fields& fields, std::string_view key) {
  for (const Field& field : fields)
    if (field.key == key) return &field;
  return nullptr;
}

}  // namespace

RecordReader::RecordReader(const Mesh& mesh, const FormRow& row)
    : mesh_(mesh), records_(mesh, row), unsuitable_(why_unsuitable(mesh, row)) {}

bool RecordReader::stores(Element::Kind kind, std::string_view key) const {
  const std::optional<Element> element = first_live(mesh_, kind);
  return element && field_of(records_.of(*element).fields, key);
}

const Field* RecordReader::field(Element of, std::string_view key) {
  if (of.index == no_index) return nullptr;
  std::vector<bool>& seen = seen_[static_cast<std::size_t>(of.kind)];
  if (of.index >= seen.size()) seen.resize(std::size_t{of.index} + 1);
  if (!seen[of.index]) order_.push_back(of);
  seen[of.index] = true;
  if (last_element_ != of) {
    last_ = records_.of(of);
    last_element_ = of;
  }
  return field_of(last_.fields, key);
}

void RecordReader::begin_anew() {
  for (const Element element : order_) seen_[static_cast<std::size_t>(element.kind)][element.index] = false;
  order_.clear();
}

Element RecordReader::link(Element of, std::string_view key) {
  const Field* const found = field(of, key);
  return found && !found->links.empty() ? found->links.front() : Element();
}

std::vector<Element> RecordReader::links(Element of, std::string_view key) {
  const Field* const found = field(of, key);
  return found ? found->links : std::vector<Element>();
}

std::vector<glm::dvec3> RecordReader::places(Face f) {
  const Field* const found = field(f, "positions");
  return found ? found->places : std::vector<glm::dvec3>();
}

RecordLinks::RecordLinks(RecordReader& reader)
    : reader_(reader),
      has_next_(reader.stores(Element::Kind::halfedge, "next")),
      has_twin_(reader.stores(Element::Kind::halfedge, "twin")),
      has_inner_(reader.stores(Element::Kind::face, "inner")) {
  for (const std::string_view key : {"halfedge", "outer"})
    if (reader.stores(Element::Kind::face, key)) first_of_face_ = key;
  if (has_next_) return;
  corners_ = corner_halfedges(reader.mesh());
  corner_of_.assign(reader.mesh().halfedge_slots(), no_index);
  for (std::uint32_t c = 0; c < corners_.size(); ++c) corner_of_[corners_[c].index] = c;
}

std::uint32_t RecordLinks::next(std::uint32_t h) const {
  if (has_next_) return reader_.link(Halfedge(h), "next").index;
  const std::uint32_t c = corner_of_[h];
  return corners_[c % 3 == 2 ? c - 2 : c + 1].index;
}

std::uint32_t RecordLinks::prev(std::uint32_t h) const {
  if (has_next_) return reader_.link(Halfedge(h), "prev").index;
  const std::uint32_t c = corner_of_[h];
  return corners_[c % 3 == 0 ? c + 2 : c - 1].index;
}

// Without a pair of its own: the other half of the parent edge.
std::uint32_t RecordLinks::pair(std::uint32_t h) const {
  if (has_twin_) return reader_.link(Halfedge(h), "twin").index;
  for (const Element half : reader_.links(reader_.link(Halfedge(h), "edge"), "halfedges"))
    if (half.index != h) return half.index;
  return no_index;
}

std::uint32_t RecordLinks::face(std::uint32_t h) const {
  if (has_next_) return reader_.link(Halfedge(h), "face").index;
  return reader_.mesh().face(corners_[corner_of_[h] / 3 * 3]).index;
}

std::uint32_t RecordLinks::at_face(std::uint32_t f) const {
  return first_of_face_.empty() ? reader_.mesh().halfedge(Face(f)).index : reader_.link(Face(f), first_of_face_).index;
}

std::vector<std::uint32_t> RecordLinks::inner(std::uint32_t f) const {
  std::vector<std::uint32_t> starts;
  if (!has_inner_) return starts;
  for (const Element start : reader_.links(Face(f), "inner")) starts.push_back(start.index);
  return starts;
}

}  // namespace ryosen::forms
