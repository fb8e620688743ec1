#include "app/editor/shown/asked_values.h"

#include <algorithm>
#include <utility>

#include "app/editor/document/findings.h"
#include "app/editor/session/operator_selection.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/shown.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/number_text.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/parameters/op_line.h"

namespace ryosen {

namespace {

class AlgorithmValues final : public AskedValues {
 public:
  AlgorithmValues(const AlgorithmRow& row, const Mesh& mesh, const Selecting& selecting)
      : AskedValues({row.id, row.name_en, row.name_ja, row.help_en, row.help_ja}), row_(row) {
    const auto takes_elements = [](const ParameterRow& p) { return p.kind == ParameterKind::elements; };
    if (std::any_of(row.parameters.begin(), row.parameters.end(), takes_elements))
      selected_ = selecting.selected_names();
    for (const ParameterRow& parameter : row.parameters)
      fields_.push_back({parameter, parameter.is_worked_on && !selected_.empty() ? std::string(selection_word)
                                                                                 : first_text(parameter, mesh)});
  }

  std::optional<std::size_t> lacking() const override {
    for (std::size_t i = 0; i < fields_.size(); ++i)
      if (fields_[i].text.empty() && must_be_given(row_.parameters, fields_[i].row)) return i;
    return std::nullopt;
  }
  std::optional<Text> fault() const override {
    const ReadValues read = values();
    return read.values ? std::nullopt : std::optional(read.sentence);
  }
  Command command() const override { return AlgorithmCall{&row_, *values().values}; }
  ValuesTrial trial() const override {
    ParameterValues named = *values().values;
    for (const ParameterRow& row : row_.parameters)
      if (means_selection(row, named.text(row.id))) named.set_names(row.id, selected_);
    const auto run = [&row = row_, named](const Findings& findings, const Selecting&, Shown& shown,
                                          Progress::Report progress) -> std::optional<Text> {
      const ReadValues found = named.on(findings.mesh());
      if (!found.values) return Text();
      const auto result = shown.try_out(ShownBy::preview, row, *found.values, std::move(progress));
      if (!result) return std::nullopt;
      return result->refused ? *result->refused : result->fault ? *result->fault : result->text;
    };
    return {AlgorithmCall{&row_, named}.line(), row_.selects_added, run};
  }

 private:
  // The word for the selection stays a word, however much is selected.
  ReadValues values() const {
    const std::vector<std::string> word{std::string(selection_word)};
    std::vector<std::string> texts;
    for (const ValueField& field : fields_) texts.push_back(field.text);
    return read_fields(row_.parameters, texts, &word);
  }

  const AlgorithmRow& row_;
  std::vector<std::string> selected_;  // the names of what was selected when it was asked for
};

bool is_number_or_position(const OpValue& value) {
  return !value.called.empty() && (value.kind == OpValueKind::number || value.kind == OpValueKind::position);
}

template <class Is>
bool any_place(const OpInfo& op, Is is) {
  const auto lists = op.line.all_lists();
  return std::any_of(lists.begin(), lists.end(),
                     [&](const OpParameters& list) { return std::any_of(list.begin(), list.end(), is); });
}

Text rule_of(Rule rule) {
  const RuleText& text = text_of(rule);
  return {std::string(text.en), std::string(text.ja)};
}

std::optional<Text> try_on_all(const ParsedOp& parsed, Shown& shown) {
  if (!parsed.op) return parsed.sentence;
  const Outcome outcome = shown.try_out(ShownBy::preview, *parsed.op);
  return outcome.reasons.empty() ? outcome.sentence : rule_of(outcome.reasons[0].rule);
}

std::optional<Text> try_on_each(const OpInfo& op, const Elements& elements, std::span<const std::string_view> words,
                                Shown& shown, Progress::Report progress) {
  const auto result = shown.try_out(ShownBy::preview, op, elements, words, std::move(progress));
  if (!result) return std::nullopt;
  if (result->error != NameError::none || result->refused.empty()) return result->sentence;
  return count_text(result->refusals(), "One is refused: ", "# are refused: ", "# 件は実行できません：") +
         rule_of(result->refused[0].rule);
}

class OperatorValues final : public AskedValues {
 public:
  OperatorValues(const OpInfo& op, const Document& document, const Findings& findings, const Selecting& selecting)
      : AskedValues({op.id, op.name_en, op.name_ja, op.help_en, op.help_ja}), op_(op) {
    look_at_selection(document, findings, selecting);
  }

  // The field of a number or a position is there where that value is chosen.
  void follow() override {
    for (const Part& part : parts_)
      if (part.choice)
        for (const auto& [value, field] : part.written)
          fields_[field].is_shown = fields_[*part.choice].text == value->called;
  }
  std::optional<std::size_t> lacking() const override {
    for (std::size_t i = 0; i < fields_.size(); ++i)
      if (fields_[i].is_shown && fields_[i].row.is_required && fields_[i].text.empty()) return i;
    return std::nullopt;
  }
  void look_at_selection(const Document& document, const Findings& findings, const Selecting& selecting) override {
    const Looked now{selecting.selection.stamp(), document.revision()};
    if (std::exchange(looked_, now) == now) return;
    fits_ = op_.on_selection == OnSelection::none || fits_selection(findings, selecting, op_);
    make_fields(findings.mesh(), selecting.selection);
  }
  std::optional<Text> fault() const override {
    std::vector<ParameterRow> rows;
    std::vector<std::string> texts;
    for (const ValueField& field : fields_) {
      if (!field.is_shown) continue;
      rows.push_back(field.row);
      texts.push_back(field.text);
    }
    if (const ReadValues read = read_fields(rows, texts); !read.values) return read.sentence;
    if (fits_) return std::nullopt;
    return Text{"Nothing is selected that it works on.", "対象となる要素が選択されていません。"};
  }
  Command command() const override { return line(); }
  ValuesTrial trial() const override {
    const auto run = [&op = op_, texts = arguments()](const Findings& findings, const Selecting& selecting,
                                                      Shown& shown, Progress::Report progress) {
      const std::vector<std::string_view> words(texts.begin(), texts.end());
      return op.on_selection == OnSelection::each || op.on_selection == OnSelection::into_last
                 ? try_on_each(op, worked_on(findings, selecting, op, words), words, shown, std::move(progress))
                 : try_on_all(op_on_selection(findings, selecting, op, words), shown);
    };
    return {std::to_string(looked_.stamp) + " " + line(), false, run};
  }

 private:
  // The fields of a place: what is chosen, where there is a choice, and numbers and positions that are written.
  struct Part {
    const OpParameter* place;
    std::optional<std::size_t> choice;
    std::vector<std::pair<const OpValue*, std::size_t>> written;
  };

  // Other elements may have other fields. What was written stays in those that were there before.
  void make_fields(const Mesh& mesh, const Elements& selection) {
    const std::vector<ValueField> before = std::exchange(fields_, {});
    const std::vector<std::string> first_before = std::exchange(first_texts_, {});
    parts_.clear();
    const OpArgument first = selection.empty() ? OpArgument(std::string_view()) : OpArgument(selection[0].kind);
    const OpParameters list = list_meant(op_.line, first);
    for (const OpParameter& place : list)
      if (place.is_told()) add_fields(place, mesh, selection);
    for (const ValueField& field : fields_) first_texts_.push_back(field.text);
    if (std::exchange(list_, list.data()) == list.data())
      for (std::size_t i = 0; i < fields_.size(); ++i)
        if (before[i].text != first_before[i]) fields_[i].text = before[i].text;
    follow();
  }

  void add_fields(const OpParameter& place, const Mesh& mesh, const Elements& selection) {
    Part part{.place = &place, .choice = {}, .written = {}};
    const std::span<const OpValue> values = std::span(place.values).first(place.count());
    const RowWords words{place.id, place.name_en, place.name_ja, place.help_en, place.help_ja};
    const bool is_word = values.size() == 1 && values[0].kind == OpValueKind::word;
    if (is_word) {
      part.choice = fields_.size();
      fields_.push_back({parameter_row(words, {.kind = ParameterKind::flag}), "off"});
    } else if (values.size() > 1) {
      std::vector<Choice> choices;
      if (place.is_optional()) choices.push_back({"", "Default", "既定"});
      for (const OpValue& value : values) choices.push_back({value.called, value.name_en, value.name_ja});
      part.choice = fields_.size();
      const std::string first(choices[0].id);
      fields_.push_back({parameter_row(words, {.kind = ParameterKind::choice, .choices = std::move(choices)}), first});
    }
    for (const OpValue& value : values) {
      if (!is_number_or_position(value)) continue;
      part.written.emplace_back(&value, fields_.size());
      fields_.push_back({field_of(value, words, part.choice.has_value() || !place.is_optional()),
                         first_text_of(place, value, mesh, selection)});
    }
    parts_.push_back(std::move(part));
  }

  // A value that is chosen has its own name and must be written.
  static ParameterRow field_of(const OpValue& value, RowWords words, bool is_required) {
    if (!value.name_en.empty()) words = {value.called, value.name_en, value.name_ja, words.help_en, words.help_ja};
    return parameter_row(words,
                         {.kind = value.kind == OpValueKind::number ? ParameterKind::number : ParameterKind::place,
                          .is_required = is_required});
  }

  // A position begins in the middle of what alone is selected, unless it is a way.
  static std::string first_text_of(const OpParameter& place, const OpValue& value, const Mesh& mesh,
                                   const Elements& selection) {
    const bool is_way = place.drag && !place.drag->from;
    if (value.kind != OpValueKind::position || is_way || selection.size() != 1) return {};
    return format_place(middle_of(mesh, selection[0]));
  }

  std::vector<std::string> arguments() const {
    std::vector<std::string> words;
    for (const Part& part : parts_) {
      const std::string chosen = part.choice ? fields_[*part.choice].text : std::string();
      bool is_written = false;
      for (const auto& [value, field] : part.written) {
        if (!fields_[field].is_shown || fields_[field].text.empty()) continue;
        words.push_back(fields_[field].text);
        is_written = true;
      }
      if (is_written || chosen.empty() || chosen == "off") continue;
      words.emplace_back(chosen == "on" ? part.place->values[0].called : std::string_view(chosen));
    }
    return words;
  }

  std::string line() const {
    std::string line(op_.id);
    if (op_.on_selection != OnSelection::none) line.append(" ").append(selection_word);
    for (const std::string& word : arguments()) line += " " + word;
    return line;
  }

  const OpInfo& op_;
  const OpParameter* list_ = nullptr;  // of its line, that the fields are of
  std::vector<Part> parts_;
  std::vector<std::string> first_texts_;  // of the fields
  struct Looked {
    std::uint64_t stamp = 0;  // of the selection
    std::uint64_t revision = 0;
    bool operator==(const Looked&) const = default;
  };
  Looked looked_;
  bool fits_ = false;
};

}  // namespace

std::unique_ptr<AskedValues> ask_values(const AlgorithmRow& row, const Mesh& mesh, const Selecting& selecting) {
  return std::make_unique<AlgorithmValues>(row, mesh, selecting);
}

std::unique_ptr<AskedValues> ask_values(const OpInfo& op, const Document& document, const Findings& findings,
                                        const Selecting& selecting) {
  return std::make_unique<OperatorValues>(op, document, findings, selecting);
}

bool has_values(const OpInfo& op) {
  return any_place(op, [](const OpParameter& place) { return place.is_told(); });
}

bool takes_numbers(const OpInfo& op) {
  return any_place(op, [](const OpParameter& place) {
    return place.is_told() && std::any_of(place.values.begin(), place.values.end(), is_number_or_position);
  });
}

}  // namespace ryosen
