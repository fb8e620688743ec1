// What the kernel stores of an element, as cells of the tables of steps.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/textbook/steps/step.h"

namespace ryosen::steps {

// The fields of vertices (position, halfedge), halfedges (from, next, prev, face) and faces (outer, inner), in that
// order; edges have none. A link is a slot name; none is no value.
struct StoredRecord {
  bool is_there = false;
  std::vector<std::optional<std::string>> values;  // empty where it is not there
};
StoredRecord stored_record(const Mesh& mesh, Element element);

// The cells in which two records of an element differ; all of one that is not there in the other.
void add_differences(Element element, const StoredRecord& was, const StoredRecord& is, std::vector<RowChange>& rows);

// The table of the elements of a kind: vertices, halfedges, edges, faces.
std::string_view table_of(Element::Kind kind);
std::string place_text(const glm::dvec3& place);
// A slot name, or no value for none.
template <class Handle>
std::optional<std::string> link_value(Handle to);

}  // namespace ryosen::steps
