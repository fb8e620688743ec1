// Values that fields of the window begin with, as a mesh has it (ParameterRow::proposed). Empty where it has none.
#pragma once

#include <string>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// To three digits.
std::string mean_edge_length_text(const Mesh& mesh);
std::string hundredth_of_mean_edge_length_text(const Mesh& mesh);

}  // namespace ryosen
