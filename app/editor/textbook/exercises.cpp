#include "app/editor/textbook/exercises.h"

#include "app/editor/commands/text/words.h"
#include "ryosen/base/rows.h"

namespace ryosen {

namespace {

// What stands in a remark line, from 0, before the figures.
std::string remark(std::string_view script, int line, std::string_view colon) {
  for (; line > 0; --line) script.remove_prefix(script.find('\n') + 1);
  return std::string(script.substr(2, script.find(colon) - 2));
}

}  // namespace

const ExerciseScript* find_exercise(std::string_view id) { return find_row(exercise_scripts(), id); }

const ExerciseScript* find_built_in_script(std::string_view id) {
  const ExerciseScript* const figure = find_row(figure_scripts(), id);
  return figure ? figure : find_exercise(id);
}

std::string exercise_ids() { return joined_ids(exercise_scripts()); }

std::string built_in_script_ids() { return exercise_ids() + "|" + joined_ids(figure_scripts()); }

Text name_of_exercise(const ExerciseScript& exercise) {
  return {remark(exercise.script, 0, ":"), remark(exercise.script, 1, "：")};
}

}  // namespace ryosen
