#include "ryosen/textbook/steps/mesh_rows.h"

#include <span>

#include "ryosen/base/number_text.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/op.h"

namespace ryosen::steps {

namespace {

using Cells = std::vector<std::optional<std::string>>;

constexpr std::array<std::string_view, 2> vertex_fields{"position", "halfedge"};
constexpr std::array<std::string_view, 4> halfedge_fields{"from", "next", "prev", "face"};
constexpr std::array<std::string_view, 2> face_fields{"outer", "inner"};

std::span<const std::string_view> fields_of(Element::Kind kind) {
  switch (kind) {
    case Element::Kind::vertex:
      return vertex_fields;
    case Element::Kind::halfedge:
      return halfedge_fields;
    case Element::Kind::face:
      return face_fields;
    case Element::Kind::edge:
      break;
  }
  return {};
}

Cells face_cells(const Mesh& mesh, Face f) {
  std::string inner;
  for (std::uint32_t r = mesh.first_ring(f); r != no_index; r = mesh.ring(r).next)
    inner += (inner.empty() ? "" : " ") + slot_name(mesh.ring(r).halfedge);
  return {link_value(mesh.halfedge(f)), inner.empty() ? std::nullopt : std::optional(inner)};
}

}  // namespace

template <class Handle>
std::optional<std::string> link_value(Handle to) {
  return to ? std::optional(slot_name(to)) : std::nullopt;
}
template std::optional<std::string> link_value(Vertex to);
template std::optional<std::string> link_value(Halfedge to);
template std::optional<std::string> link_value(Edge to);
template std::optional<std::string> link_value(Face to);

std::string_view table_of(Element::Kind kind) {
  constexpr std::array<std::string_view, 4> names{"vertices", "halfedges", "edges", "faces"};
  return names[static_cast<std::size_t>(kind)];
}

std::string place_text(const glm::dvec3& place) {
  return format_double(place.x) + "," + format_double(place.y) + "," + format_double(place.z);
}

StoredRecord stored_record(const Mesh& mesh, Element element) {
  if (!has_slot(mesh.lengths(), element) || !is_alive(mesh, element)) return {};
  switch (element.kind) {
    case Element::Kind::vertex:
      return {true, {place_text(mesh.position(element.vertex())), link_value(mesh.halfedge(element.vertex()))}};
    case Element::Kind::halfedge: {
      const HalfedgeLinks& links = mesh.links(element.halfedge());
      return {true, {link_value(links.from), link_value(links.next), link_value(links.prev), link_value(links.face)}};
    }
    case Element::Kind::face:
      return {true, face_cells(mesh, element.face())};
    case Element::Kind::edge:
      break;
  }
  return {true, {}};
}

void add_differences(Element element, const StoredRecord& was, const StoredRecord& is, std::vector<RowChange>& rows) {
  const std::span<const std::string_view> fields = fields_of(element.kind);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    RowChange row{std::string(table_of(element.kind)), slot_name(element), std::string(fields[i]), {}, {}};
    if (was.is_there) row.old_value = was.values[i];
    if (is.is_there) row.new_value = is.values[i];
    if (row.old_value != row.new_value) rows.push_back(std::move(row));
  }
}

}  // namespace ryosen::steps
