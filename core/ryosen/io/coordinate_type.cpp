#include "ryosen/io/coordinate_type.h"

#include "ryosen/io/format.h"

namespace ryosen {

std::optional<bool> holds_float_coordinates(const MeshFile& file) {
  const bool is_binary = file.encoding == Encoding::binary_little || file.encoding == Encoding::binary_big;
  if (!file.properties.has_layout()) {
    if (is_binary && file.format && file.format->id == "stl") return true;
    return std::nullopt;
  }
  bool are_floats = true;
  for (const PropertyTable& table : file.properties.tables)
    for (const Property& property : table.properties)
      if (property.role == PropertyRole::position) are_floats = are_floats && property.type == NumberType::f32;
  if (are_floats || is_binary) return are_floats;
  return std::nullopt;
}

}  // namespace ryosen
