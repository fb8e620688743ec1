// Exercises and figures of the source texts on the start page and in the menu Help.
#include <utility>

#include "app/editor/textbook/exercises.h"
#include "app/editor/textbook/figures.h"
#include "app/ui/menu.h"
#include "app/ui/start_page.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

OfferedCalls offered(Text title, std::span<const ExerciseScript> scripts) {
  OfferedCalls offered{std::move(title), {}};
  for (const ExerciseScript& script : scripts)
    offered.calls.emplace_back(name_of_exercise(script), "steps script " + std::string(script.id));
  return offered;
}

}  // namespace

void StartPage::draw_exercises(PanelContext& context) {
  bold_text(context, context.text("An exercise, step by step", "演習（一手ずつ）"));
  for (const ExerciseScript& exercise : exercise_scripts()) {
    entry(context, name_of_exercise(exercise).in(context.language()), "exercise " + std::string(exercise.id), true);
    tip(context.text("Builds it from nothing by Euler operators; undo goes back through the steps.",
                     "オイラー操作で空から組み立てます。「元に戻す」で一手ずつ戻れます。"));
  }
}

// A line for each text, and as many more as it needs.
void StartPage::draw_figures(PanelContext& context) {
  bold_text(context, context.text("A figure of the source texts", "テキストの図"));
  const float end = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  std::string_view text_before;
  for (const Figure& figure : figures()) {
    const std::string_view text = figure.id.substr(0, figure.id.find('-'));
    const std::string name(figure.id.substr(text.size() + 1));
    if (text != text_before) {
      ImGui::AlignTextToFramePadding();
      dim_text(context, std::string(text).c_str());
      text_before = text;
    }
    const float width = ImGui::CalcTextSize(name.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <= end) ImGui::SameLine();
    entry(context, name, "figure " + std::string(figure.id), false);
    tip(std::string(context.text(figure.name_en, figure.name_ja)) + "\n" +
        context.text(figure.found_en, figure.found_ja));
  }
}

std::vector<OfferedCalls> textbook_calls() {
  return {offered({"Exercises", "演習"}, exercise_scripts()),
          offered({"Figures 2 to 7 of text 002", "テキスト 002 の図 2〜7"}, figure_scripts())};
}

}  // namespace ryosen
