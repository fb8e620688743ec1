// A vertex, edge, halfedge or face by its name.
#pragma once

#include <string_view>

#include "core/base/element.h"
#include "core/mesh/names.h"

namespace ryosen {

struct NamedElement {
  std::optional<Element> element;
  NameError error = NameError::none;
  Text sentence;
};
// fN is a face, vN a vertex, hN a halfedge, all else an edge.
NamedElement find_element(const Mesh& mesh, std::string_view name);

}  // namespace ryosen
