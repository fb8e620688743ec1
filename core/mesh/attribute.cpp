#include "core/mesh/attribute.h"

namespace ryosen {

std::vector<CornerAttribute> corner_attributes(const Mesh& mesh) {
  std::vector<CornerAttribute> found;
  const auto add = [&](std::string_view index_name, std::string_view pool_name) {
    const int index = mesh.find_attribute(index_name), pool = mesh.find_attribute(pool_name);
    if (index >= 0 && pool >= 0) found.push_back({static_cast<std::size_t>(index), static_cast<std::size_t>(pool)});
  };
  add(attribute_names::texcoord, attribute_names::texcoord_pool);
  add(attribute_names::normal, attribute_names::normal_pool);
  return found;
}

}  // namespace ryosen
