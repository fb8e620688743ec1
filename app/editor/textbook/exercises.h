// The exercises of the source texts: solids that are built from nothing by the scripts in assets/exercises, which are
// part of the program.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ryosen/base/message.h"

namespace ryosen {

struct ExerciseScript {
  std::string_view id, script;
};

// By id. The first two lines of each are remarks that name what comes out, with a colon behind the name: in English,
// then in Japanese.
std::span<const ExerciseScript> exercise_scripts();
const ExerciseScript* find_exercise(std::string_view id);
// Of the figures of text 002: an operator and its inverse each. The same otherwise.
std::span<const ExerciseScript> figure_scripts();
// Of both.
const ExerciseScript* find_built_in_script(std::string_view id);
// "cube|square|...".
std::string exercise_ids();
// The same of both kinds.
std::string built_in_script_ids();
// "A cube with two through-holes".
Text name_of_exercise(const ExerciseScript& exercise);

}  // namespace ryosen
