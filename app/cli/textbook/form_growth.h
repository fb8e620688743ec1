// `forms --growth`: how the work of the forms grows with the number of faces.
#pragma once

#include "app/cli/subcommand_table.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::cli {

// On parts of the mesh, or on tori where there is none. One line per curve; with --plot also a picture.
ExitCode print_form_growth(const Mesh* mesh, const Arguments& arguments, const Console& console);

}  // namespace ryosen::cli
