// Which properties of a PLY file the mesh has a place for.
#pragma once

#include "ryosen/io/properties.h"

namespace ryosen {

bool has_role(const PropertyTable& table, PropertyRole role);

// Gives the properties of a table their roles by their names and types.
void give_roles(PropertyTable& table);

}  // namespace ryosen
