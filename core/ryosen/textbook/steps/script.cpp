#include <charconv>
#include <utility>

#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/ops/op.h"
#include "ryosen/textbook/steps/players.h"
#include "ryosen/textbook/steps/sources.h"

namespace ryosen::steps {

namespace {

Failure fault_of_line(std::string_view line, const Text& why) {
  return make_failure(ExitCode::usage, "bad_arguments",
                      {"'" + std::string(line) + "': " + why.en, "「" + std::string(line) + "」：" + why.ja});
}

// Plays lines on a mesh of its own.
class ScriptPlay : public EditPlay {
 public:
  explicit ScriptPlay(const Mesh& mesh) : EditPlay(mesh) {}

  // False where the steps end here.
  Result<bool> take(const std::string& line) {
    const std::vector<std::string_view> words = split_words(line);
    if (words.empty()) return true;
    if (words[0] == "expect") return expect(line, words);
    const OpInfo* const info = find_op(words[0]);
    if (!info)
      return fault_of_line(line, {"a script that is played holds operators and 'expect'.",
                                  "再生できるスクリプトの行は操作と expect だけです。"});
    const ParsedOp parsed = parse_line(mesh_, line);
    if (!parsed.op && !was_there(line, parsed.error)) return fault_of_line(line, parsed.sentence);
    Step step{{line + ": " + std::string(info->name_en), line + "：" + std::string(info->name_ja)},
              {},
              {},
              source_of_operator(info->id),
              {}};
    if (!parsed.op) {
      const RuleText& rule = ryosen::text_of(Rule::deleted);
      stop_ = Stop{ExitCode::refused,
                   {line + " is refused: " + std::string(rule.en) + " (" + parsed.sentence.en + "; " +
                        std::string(rule.remedy_en) + ") [" + std::string(rule.id) + "]",
                    line + " は実行できません：" + std::string(rule.ja) + "（" + parsed.sentence.ja + "。" +
                        std::string(rule.remedy_ja) + "） [" + std::string(rule.id) + "]"},
                   {}};
      return refuse(std::move(step), parsed.sentence, {});
    }
    const Verdict verdict = check(mesh_, *parsed.op);
    if (!verdict.legal()) {
      const std::string command = command_of(mesh_, *parsed.op);
      stop_ = Stop{ExitCode::refused, {command + " is refused", command + " は実行できません"}, verdict.reasons};
      const RuleText& rule = ryosen::text_of(verdict.reasons[0].rule);
      return refuse(std::move(step), {std::string(rule.en), std::string(rule.ja)}, verdict.reasons[0].witnesses);
    }
    apply(*parsed.op);
    add(std::move(step));
    return true;
  }

  std::unique_ptr<Sequence> done() && {
    std::unique_ptr<Sequence> sequence = std::move(*this).EditPlay::done();
    sequence->stop_for(std::move(stop_));
    return sequence;
  }

 private:
  // Whether what a line names has been deleted by an earlier one.
  bool was_there(const std::string& line, NameError error) {
    if (error == NameError::deleted) return true;
    if (error != NameError::never_existed) return false;
    bool is_found = false;
    const std::size_t now = journal_.position();
    while (!is_found && journal_.can_undo()) {
      journal_.undo(mesh_);
      is_found = parse_line(mesh_, line).op.has_value();
    }
    while (journal_.position() < now) journal_.redo(mesh_);
    return is_found;
  }

  bool refuse(Step step, const Text& why, const std::vector<Element>& witnesses) {
    step.caption += Text{": refused, " + why.en, "：できません。" + why.ja};
    for (const Element element : witnesses) step.marks.push_back({Role::missing, element});
    add(std::move(step));
    return false;
  }

  Result<bool> expect(const std::string& line, const std::vector<std::string_view>& words) {
    const Text usage{"'expect' takes a term of the sum and a number here, as in expect V 8.",
                     "ここでの expect は項と数です（例：expect V 8）。"};
    if (words.size() != 3 || words[1].size() != 1) return fault_of_line(line, usage);
    std::int64_t wanted = 0;
    const auto [end, error] = std::from_chars(words[2].data(), words[2].data() + words[2].size(), wanted);
    if (error != std::errc() || end != words[2].data() + words[2].size()) return fault_of_line(line, usage);
    const EulerPoincare terms = euler_poincare(mesh_);
    for (const EulerTerm& term : euler_letters()) {
      if (term.letter != words[1][0]) continue;
      const auto found = term.value(terms);
      const std::string is = found ? std::to_string(*found) : "-";
      const bool holds = found == wanted;
      Step step{{line + (holds ? ": it is so" : ": it is " + is), line + (holds ? "：そのとおり" : "：実際は " + is)},
                {},
                {{"terms", std::string(words[1]), "value", is, is}},
                euler_text,
                {}};
      add(std::move(step));
      const std::string claim = std::string(words[1]) + " " + std::string(words[2]);
      if (!holds)
        stop_ = Stop{ExitCode::found_problems,
                     {"expected " + claim + ", found: " + is, claim + " のはずですが、実際は：" + is},
                     {}};
      return holds;
    }
    return fault_of_line(line, usage);
  }

  std::optional<Stop> stop_;
};

}  // namespace

Made play_script(const Mesh& mesh, Arguments lines) {
  ScriptPlay play(mesh);
  for (const std::string& line : lines) {
    const Result<bool> goes_on = play.take(line);
    if (!goes_on) return goes_on.failure();
    if (!*goes_on) break;
  }
  return std::move(play).done();
}

Choices choices_of_script(const Mesh&, Selected) { return {}; }

std::unique_ptr<Sequence> play_history(const Mesh& mesh, const Journal& journal, Arguments lines) {
  std::vector<Step> steps;
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<std::string_view> words = split_words(lines[i]);
    const OpInfo* const info = words.empty() ? nullptr : find_op(words[0]);
    Step step{{lines[i], lines[i]}, {}, {}, {}, {}};
    if (info) step.source = source_of_operator(info->id);
    steps.push_back(std::move(step));
    positions.push_back(i + 1);
  }
  return std::make_unique<RecordedSteps>(mesh, journal, std::move(steps), std::move(positions));
}

}  // namespace ryosen::steps
