#include <algorithm>
#include <array>
#include <optional>

#include "app/editor/session/session.h"
#include "app/editor/textbook/practice.h"
#include "app/ui/panels.h"
#include "app/ui/textbook/records_of_mesh.h"
#include "app/ui/whole_rows.h"
#include "app/ui/widgets.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

namespace {

// Asks about the mesh that is open; takes a click on the answer or a word, and shows why with the elements that prove
// it.
class PracticePanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    if (context.mesh().live().faces == 0 || context.mesh().live().edges == 0)
      return dim_text(context, context.text("Open a mesh first: the start page has the figures of the source texts.",
                                            "先にメッシュを開いてください。開始画面にテキストの図があります。"));
    top_ = ImGui::GetCursorPosY();
    choose_kind(context);
    is_left_ |= asked_ && !context.session.asked_question;
    if (is_left_) asked_.reset();
    const bool is_stale =
        asked_ && (asked_->serial != context.document().serial() || asked_->revision != context.document().revision());
    if (is_stale) asked_.reset();
    context.state.wants_records |= asked_ && asked_->question.kind == QuestionKind::record;
    const bool was_judged = judged_.has_value();
    if (!is_left_ && (asked_ || ask(context))) draw_question(context);
    context.state.asks_to_be_seen = judged_ && !was_judged;
    if (ImGui::Button(context.text("Next question", "次の問題"), {ImGui::GetContentRegionAvail().x, 0})) {
      ++seed_;
      go_on(context.session.asked_question);
      context.state.asks_to_be_seen = true;  // what there is to choose from is higher than the judgement
    }
  }

 private:
  struct Asked {
    Question question;
    Solution solution;
    std::vector<AnswerChoice> choices;
    Elements selected;  // when it was asked
    std::uint64_t serial, revision;
  };

  // False while what it takes is not there.
  bool ask(PanelContext& context) {
    const QuestionKind kind = kind_.value_or(kind_of_seed(seed_));
    const RecordBook* const book = kind == QuestionKind::record ? records_of_mesh(context) : nullptr;
    if (kind == QuestionKind::record && !book) return false;
    const AllRecords records = book ? book->records() : AllRecords();
    const Question question = make_question(context.mesh(), kind, seed_, records);
    asked_ = {question,
              solve(context.mesh(), question, records),
              {},
              context.selecting.selection,
              context.document().serial(),
              context.document().revision()};
    asked_->choices = answer_choices(question, asked_->solution);
    context.session.asked_question = {question.about, asked_->serial, asked_->revision};
    rows_.go_to_top();
    word_.fill(0);
    doubt_ = {};
    judged_.reset();
    return true;
  }

  // The next one is asked in the next frame.
  void go_on(std::optional<AskedQuestion>& asked_question) {
    asked_.reset();
    asked_question.reset();
    is_left_ = false;
  }

  void choose_kind(PanelContext& context) {
    const auto name = [&](std::optional<QuestionKind> kind) {
      if (!kind) return context.text("Any question", "すべての問題");
      const QuestionKindRow& row = question_kinds()[static_cast<std::size_t>(*kind)];
      return context.text(row.en, row.ja);
    };
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (!ImGui::BeginCombo("##kind", name(kind_))) return;
    const auto choice = [&](std::optional<QuestionKind> kind) {
      if (!ImGui::Selectable(name(kind), kind == kind_)) return;
      kind_ = kind;
      go_on(context.session.asked_question);
    };
    choice({});
    for (const QuestionKindRow& row : question_kinds()) choice(row.kind);
    ImGui::EndCombo();
  }

  void draw_question(PanelContext& context) {
    wrapped_text(asked_->question.asks.in(context.language()).c_str());
    ImGui::PushID("about");
    element_links(context, {asked_->question.about});
    ImGui::PopID();
    take_click(context.mesh(), context.selecting);
    if (judged_) return draw_judgement(context);
    draw_choices(context);
    draw_answer_field(context);
  }

  void judge(const Mesh& mesh, std::string_view word) {
    judged_ = {says(word), is_right(mesh, asked_->solution, word)};
  }

  // An answer as it is chosen from, where it is one of those; else as it was given.
  Text says(std::string_view word) const {
    const std::vector<AnswerChoice>& choices = asked_->choices;
    const auto choice =
        std::find_if(choices.begin(), choices.end(), [&](const auto& some) { return some.word == word; });
    return choice == choices.end() ? Text{std::string(word), std::string(word)} : choice->says;
  }

  // So that all of the panel is seen at once, with its header above and what goes on from it below.
  float room_for_choices(const ViewState& view) const {
    const float above = ImGui::GetFrameHeightWithSpacing() + ImGui::GetCursorPosY() - top_;
    const float below = 2 * ImGui::GetFrameHeightWithSpacing();
    return static_cast<float>(view.size.height) - above - below - 2 * ImGui::GetStyle().WindowPadding.y;
  }

  // A click on a row answers: numbers side by side, rules with their sentences.
  void draw_choices(PanelContext& context) {
    const std::vector<AnswerChoice>& choices = asked_->choices;
    if (choices.empty()) return;
    if (asked_->question.kind == QuestionKind::valence) {
      const float gap = 3 * context.scale, width = (ImGui::GetContentRegionAvail().x - 6 * gap) / 7;
      for (std::size_t i = 0; i < choices.size(); ++i) {
        if (i % 7 != 0) ImGui::SameLine(0, gap);
        if (ImGui::Button(choices[i].word.c_str(), {width, 0})) judge(context.mesh(), choices[i].word);
      }
      return;
    }
    // With room for a scroll bar, so that the lines stay as they are where there is one.
    constexpr float most_lines = 16, least_lines = 5;
    const float width = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    float lines = 0;
    for (const AnswerChoice& choice : choices)
      lines += lines_of_wrapped_row(context, choice.says.in(context.language()), width);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float room = std::max(room_for_choices(context.view) / line, least_lines);
    rows_.begin("choices", std::min({lines, most_lines, room}) * line);
    for (const AnswerChoice& choice : choices) {
      ImGui::PushID(choice.word.c_str());
      rows_.row_of_text();
      if (wrapped_row(context, choice.says.in(context.language()), false, width)) judge(context.mesh(), choice.word);
      tip(choice.word);
      ImGui::PopID();
    }
    rows_.end();
  }

  void draw_answer_field(PanelContext& context) {
    const float button = 5 * ImGui::GetFontSize();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x);
    if (std::exchange(takes_keys_, false)) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputText("##answer", word_.data(), word_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    tip(context.text(
        "h3, 1-2, v4, a number, none, yes, or the rule that forbids it; or click the element in the view.",
        "h3、1-2、v4、数、「なし」、「はい」、または禁じる規則。画面で要素をクリックしても答えられます。"));
    ImGui::SameLine();
    if (ImGui::Button(context.text("Answer", "答える"), {button, 0}) || entered) {
      doubt_ = doubt_about(context.mesh(), asked_->solution, word_.data());
      if (doubt_.en.empty()) doubt_ = why_no_answer(context.mesh(), asked_->question, asked_->solution, word_.data());
      if (doubt_.en.empty()) judge(context.mesh(), word_.data());
      takes_keys_ = !doubt_.en.empty();  // for another word
    }
    if (!doubt_.en.empty()) wrapped_text(doubt_.in(context.language()).c_str());
  }

  // What is selected since the question was asked is an answer, if it is of the kind that is asked for.
  void take_click(const Mesh& mesh, const Selecting& selecting) {
    if (judged_ || !asked_->solution.element || selecting.selection == asked_->selected ||
        selecting.selection.size() != 1)
      return;
    const Element given = selecting.selection[0];
    if (given == asked_->question.about || given.kind != asked_->solution.element->kind) return;
    const std::string name = name_of(mesh, given);
    judged_ = {{name, name}, given == *asked_->solution.element};
  }

  // In place of what there was to choose from, so that it is seen with what goes on from it.
  void draw_judgement(PanelContext& context) {
    Text right = says(asked_->solution.answers.front());
    const Text no{"No, the right answer is: ", "違います。正解："};
    const Text& why = asked_->solution.why;
    const bool tells = why.en.starts_with(right.en);       // as a rule does, with its elements
    if (const auto& element = asked_->solution.element) {  // as a click in the view is told, too
      const std::string name = name_of(context.mesh(), *element);
      if (name != right.en) right += Text{" (" + name + ")", "（" + name + "）"};
    }
    const auto show = [&](const ImVec4& colour, const Text& text) {
      coloured_text(colour, text.in(context.language()).c_str());
    };
    const ImVec4 plain = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    show(plain, Text{"Your answer: ", "あなたの答え："} + judged_->given);
    if (judged_->is_right)
      show(context.colours().legal, {"Right.", "正解です。"});
    else
      show(context.colours().warning, no + (tells ? why : right));
    if (judged_->is_right || !tells) show(plain, why);
    ImGui::PushID("why");
    element_links(context, asked_->solution.witnesses);
    ImGui::PopID();
  }

  std::uint64_t seed_ = 1;
  std::optional<QuestionKind> kind_;  // none: any
  std::optional<Asked> asked_;
  bool is_left_ = false;  // by Escape: nothing is asked until somebody goes on
  std::array<char, 64> word_{};
  bool takes_keys_ = false;  // its field is to have the keyboard
  float top_ = 0;            // where the panel begins below its header
  WholeRows rows_;
  Text doubt_;  // about what was answered last
  struct Judged {
    Text given;
    bool is_right;
  };
  std::optional<Judged> judged_;
};

}  // namespace

std::unique_ptr<Panel> make_practice_panel() { return std::make_unique<PracticePanel>(); }

}  // namespace ryosen
