#include "app/editor/textbook/exercises.h"

namespace ryosen {

namespace {

// What stands in a remark line, from 0, before the figures.
std::string remark(std::string_view script, int line, std::string_view colon) {
  for (; line > 0; --line) script.remove_prefix(script.find('\n') + 1);
  return std::string(script.substr(2, script.find(colon) - 2));
}

}  // namespace

const ExerciseScript* find_exercise(std::string_view id) {
  for (const ExerciseScript& exercise : exercise_scripts())
    if (exercise.id == id) return &exercise;
  return nullptr;
}

const ExerciseScript* find_built_in_script(std::string_view id) {
  for (const ExerciseScript& figure : figure_scripts())
    if (figure.id == id) return &figure;
  return find_exercise(id);
}

std::string exercise_ids() {
  std::string ids;
  for (const ExerciseScript& exercise : exercise_scripts()) ids.append(ids.empty() ? "" : "|").append(exercise.id);
  return ids;
}

std::string built_in_script_ids() {
  std::string ids = exercise_ids();
  for (const ExerciseScript& figure : figure_scripts()) ids.append("|").append(figure.id);
  return ids;
}

Text name_of_exercise(const ExerciseScript& exercise) {
  return {remark(exercise.script, 0, ":"), remark(exercise.script, 1, "：")};
}

}  // namespace ryosen
