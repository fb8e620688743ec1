// `forms --element`: what each form stores of an element.
#pragma once

#include "app/cli/subcommand_table.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::cli {

// Prints the records of the element that --element names, or of all, in every form or that of --form.
ExitCode print_form_records(const Mesh& mesh, const Arguments& arguments, const Console& console);

}  // namespace ryosen::cli
