#include "app/editor/exercises.h"

#include <algorithm>
#include <cctype>

namespace ryosen {

namespace {

struct NameRow {
  std::string_view id, ja;
};
constexpr NameRow japanese_names[] = {
    {"triangle", "三角形"},           {"square", "正方形"},
    {"triangular_pyramid", "三角錐"}, {"cube", "立方体"},
    {"cube_with_hole", "穴のある立方体"}, {"cube_with_two_holes", "穴が二つある立方体"},
};

}  // namespace

const ExerciseScript* find_exercise(std::string_view id) {
  for (const ExerciseScript& exercise : exercise_scripts())
    if (exercise.id == id) return &exercise;
  return nullptr;
}

std::string exercise_ids() {
  std::string ids;
  for (const ExerciseScript& exercise : exercise_scripts()) ids.append(ids.empty() ? "" : "|").append(exercise.id);
  return ids;
}

Text name_of_exercise(const ExerciseScript& exercise) {
  std::string en(exercise.id);
  std::replace(en.begin(), en.end(), '_', ' ');
  en[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(en[0])));
  const auto row = std::find_if(std::begin(japanese_names), std::end(japanese_names),
                                [&](const NameRow& name) { return name.id == exercise.id; });
  return {en, row == std::end(japanese_names) ? en : std::string(row->ja)};
}

}  // namespace ryosen
