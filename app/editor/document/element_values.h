// The attribute values of an element in words, as the inspector shows them.
#pragma once

#include <string>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

struct ElementValue {
  std::string name;   // as in files and commands, without the kind of the element
  std::string value;  // numbers with blanks between them, or a name
  bool is_number = true;
};
// All values of a living element: of a halfedge those of the corner at its origin. Names of materials and groups are
// those of the tables; an element without a value has no row.
std::vector<ElementValue> values_of(const Mesh& mesh, const FileTables& tables, const Element& element);

}  // namespace ryosen
