// The functions of the table of steps, one file each.
#pragma once

#include "ryosen/textbook/steps/all.h"

namespace ryosen::steps {

using Arguments = std::span<const std::string>;
using Selected = std::span<const Element>;

// script.cpp: operators, and `expect` with a term of the sum. The steps end behind a line that is refused, or an
// `expect` that is not so.
Made play_script(const Mesh& mesh, Arguments lines);
Choices choices_of_script(const Mesh& mesh, Selected selection);
// The history of a mesh as a script: the journal with the line of each transaction. Both may have been undone in part.
std::unique_ptr<Sequence> play_history(const Mesh& mesh, const Journal& journal, Arguments lines);
// build.cpp
Made play_build(const Mesh& mesh, Arguments arguments);
Choices choices_of_build(const Mesh& mesh, Selected selection);
// pair.cpp
Made play_pair(const Mesh& mesh, Arguments arguments);
Choices choices_of_pair(const Mesh& mesh, Selected selection);
// listing.cpp
Made play_collapse(const Mesh& mesh, Arguments arguments);
Choices choices_of_collapse(const Mesh& mesh, Selected selection);
Made play_swap(const Mesh& mesh, Arguments arguments);
Choices choices_of_swap(const Mesh& mesh, Selected selection);
// split3.cpp
Made play_split3(const Mesh& mesh, Arguments arguments);
Choices choices_of_split3(const Mesh& mesh, Selected selection);
// walk.cpp
Made play_walk(const Mesh& mesh, Arguments arguments);
Choices choices_of_walk(const Mesh& mesh, Selected selection);
Made play_loop(const Mesh& mesh, Arguments arguments);
Choices choices_of_loop(const Mesh& mesh, Selected selection);
// relation.cpp
Made play_relation(const Mesh& mesh, Arguments arguments);
Choices choices_of_relation(const Mesh& mesh, Selected selection);
// hull.cpp: of all points; refused where these lie on a line.
Made play_hull(const Mesh& mesh, Arguments arguments);
Choices choices_of_hull(const Mesh& mesh, Selected selection);

}  // namespace ryosen::steps
