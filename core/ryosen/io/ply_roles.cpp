#include "ryosen/io/ply_roles.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace ryosen {
namespace {

// A set of properties that the mesh has a place for. All of the first `needed` must be there.
struct RoleRow {
  TableKind kind;
  PropertyRole role;
  std::size_t needed;
  std::vector<std::string_view> names;
};

const std::vector<RoleRow>& scalar_roles() {
  using enum PropertyRole;
  static const std::vector<RoleRow> rows = {
      {TableKind::vertices, position, 2, {"x", "y", "z"}},
      {TableKind::vertices, normal, 3, {"nx", "ny", "nz"}},
      {TableKind::vertices, texcoord, 2, {"s", "t"}},
      {TableKind::vertices, texcoord, 2, {"u", "v"}},
      {TableKind::vertices, texcoord, 2, {"texture_u", "texture_v"}},
      {TableKind::vertices, vertex_colour, 3, {"red", "green", "blue", "alpha"}},
      {TableKind::vertices, vertex_colour, 3, {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}},
      {TableKind::vertices, vertex_colour, 3, {"r", "g", "b", "a"}},
      {TableKind::faces, face_colour, 3, {"red", "green", "blue", "alpha"}},
      {TableKind::other, vertex_number, 2, {"vertex1", "vertex2"}},
  };
  return rows;
}

struct ListRoleRow {
  TableKind kind;
  PropertyRole role;
  std::string_view name;
};

constexpr ListRoleRow list_roles[] = {
    {TableKind::faces, PropertyRole::corners, "vertex_indices"},
    {TableKind::faces, PropertyRole::corners, "vertex_index"},
    {TableKind::faces, PropertyRole::corner_texcoord, "texcoord"},
    {TableKind::other, PropertyRole::vertex_number, "vertex_indices"},
    {TableKind::other, PropertyRole::vertex_number, "vertex_index"},
};

Property* find_property(PropertyTable& table, std::string_view name, bool is_list) {
  for (Property& property : table.properties) {
    if (property.name == name && property.is_list == is_list) return &property;
  }
  return nullptr;
}

void give_scalar_role(PropertyTable& table, const RoleRow& row) {
  if (has_role(table, row.role)) return;
  std::vector<Property*> found;
  for (const std::string_view name : row.names) {
    Property* const property = find_property(table, name, false);
    if (!property) break;
    if (row.role == PropertyRole::vertex_number && is_real(property->type)) break;
    found.push_back(property);
  }
  if (found.size() < row.needed) return;
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i]->role = row.role;
    found[i]->component = static_cast<std::uint8_t>(i);
  }
}

}  // namespace

bool has_role(const PropertyTable& table, PropertyRole role) {
  return std::any_of(table.properties.begin(), table.properties.end(),
                     [&](const Property& property) { return property.role == role; });
}

void give_roles(PropertyTable& table) {
  for (const RoleRow& row : scalar_roles()) {
    if (row.kind == table.kind) give_scalar_role(table, row);
  }
  for (const ListRoleRow& row : list_roles) {
    if (row.kind != table.kind || has_role(table, row.role)) continue;
    Property* const property = find_property(table, row.name, true);
    if (property && is_real(property->type) == (row.role == PropertyRole::corner_texcoord)) property->role = row.role;
  }
}

}  // namespace ryosen
