// The commands of the program, one file each. Their arguments have been checked against their row of the table.
#pragma once

#include "app/cli/subcommand_table.h"
#include "ryosen/algo/algorithm.h"

namespace ryosen::cli {

ExitCode check_command(const Arguments& arguments, const Console& console);
ExitCode why_command(const Arguments& arguments, const Console& console);
ExitCode edit_command(const Arguments& arguments, const Console& console);
ExitCode convert_command(const Arguments& arguments, const Console& console);
ExitCode view_command(const Arguments& arguments, const Console& console);
ExitCode repair_command(const Arguments& arguments, const Console& console);
ExitCode algorithm_command(const AlgorithmRow& row, const Arguments& arguments, const Console& console);
ExitCode shot_command(const Arguments& arguments, const Console& console);
ExitCode hull_command(const Arguments& arguments, const Console& console);
ExitCode measure_command(const Arguments& arguments, const Console& console);
ExitCode steps_command(const Arguments& arguments, const Console& console);
ExitCode distance_command(const Arguments& arguments, const Console& console);
ExitCode forms_command(const Arguments& arguments, const Console& console);
ExitCode practice_command(const Arguments& arguments, const Console& console);
ExitCode formats_command(const Arguments& arguments, const Console& console);
ExitCode keys_command(const Arguments& arguments, const Console& console);
ExitCode doctor_command(const Arguments& arguments, const Console& console);
ExitCode help_command(const Arguments& arguments, const Console& console);
ExitCode version_command(const Arguments& arguments, const Console& console);

// The help of one command, or of the program.
ExitCode show_help(const std::optional<Subcommand>& command, const Console& console);

}  // namespace ryosen::cli
