#include "ryosen/algo/repair/report.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>

#include "ryosen/algo/algorithm_rows.h"
#include "ryosen/algo/repair/recipe.h"
#include "ryosen/algo/repair/side_effects.h"
#include "ryosen/analysis/problems.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

namespace {

bool solves(const AlgorithmRow& row, ProblemKind kind) {
  return std::find(row.solves.begin(), row.solves.end(), kind) != row.solves.end();
}

// A step has said which of these it left, and why.
bool is_told(const RepairCall& call, std::span<const AlgorithmResult> results, const ProblemRow& kind) {
  for (std::size_t i = 0; i < call.steps.size(); ++i)
    if (solves(*call.steps[i].row, kind.kind))
      for (const LeftForReason& left : results[i].left_for)
        if (left.elements.front().kind == kind.sort()) return true;
  return false;
}

bool is_for(const RepairCall& call, ProblemKind kind) {
  return std::any_of(call.steps.begin(), call.steps.end(),
                     [&](const RecipeStep& step) { return solves(*step.row, kind); });
}

// Of a kind that these repairs have not taken away.
Text reason_of(const RepairCall& call, const ProblemRow& kind) {
  Text others;
  for (const AlgorithmRow& row : repair_rows()) {
    const bool is_run = std::any_of(call.steps.begin(), call.steps.end(),
                                    [&](const RecipeStep& step) { return step.row->id == row.id; });
    if (is_run || !solves(row, kind.kind)) continue;
    others.en += (others.en.empty() ? "" : "\" or \"") + std::string(row.name_en);
    others.ja += (others.ja.empty() ? "" : "」か「") + std::string(row.name_ja);
  }
  const Text name{std::string(kind.name_en), std::string(kind.name_ja)};
  const bool is_among = is_for(call, kind.kind);
  if (others.en.empty())
    return name + (is_among
                       ? Text{": this repair leaves it", "：この修復では残るため"}
                       : Text{": no repair takes it away, \"delete\" does", "：修復では直らず、削除で取り除くため"});
  return name +
         (is_among ? Text{": this repair leaves it", "：この修復では残るため"}
                   : Text{": not among these repairs", "：ここには含まれないため"}) +
         Text{", \"", "（「"} + others + Text{"\" is for it", "」で直せます）"};
}

bool names(const Problem& problem, const Element& element) {
  if (problem.row().quarantined || problem.row().sort() != element.kind) return false;
  const auto at = std::lower_bound(problem.elements.begin(), problem.elements.end(), element,
                                   [](const Element& a, const Element& b) { return a.index < b.index; });
  return at != problem.elements.end() && at->index == element.index;
}

// Of what the steps have left. Several may have left the same.
void count_left(RepairReport& report, std::span<const Problem> problems) {
  for (const Problem& problem : problems) report.problems += problem.count();
  std::vector<Element> others;
  for (const LeftForReason& left : report.left)
    if (!tells_of_loose_pieces(left))
      std::copy_if(left.elements.begin(), left.elements.end(), std::back_inserter(others), [&](const Element& element) {
        return std::none_of(problems.begin(), problems.end(), [&](const Problem& p) { return names(p, element); });
      });
  sort_unique(others);
  report.others = others.size();
}

// What is still found, of all kinds or of those that a single repair is for: counted, and told unless it has been.
void add_found(RepairReport& report, const RepairCall& call, std::span<const AlgorithmResult> results,
               const Mesh& after, const RecipeInput& input, bool drops_quarantined) {
  const ProblemSets sets(after, 0, input.on_lines);
  const FileFaces file{drops_quarantined ? std::span<const QuarantinedFace>() : input.quarantine, {}, nullptr};
  std::vector<Problem> problems = find_problems(after, sets, file);
  std::erase_if(problems, [&](const Problem& problem) {
    const bool has_repair = std::any_of(repair_rows().begin(), repair_rows().end(),
                                        [&](const AlgorithmRow& row) { return solves(row, problem.kind); });
    // Parts that touch keep points at one place for good.
    const bool is_wrong = problem.row().severity == ProblemSeverity::problem;
    const bool is_to_tell = is_wrong || (has_repair && problem.kind != ProblemKind::coincident_points);
    return !(call.in_rounds ? is_to_tell : is_for(call, problem.kind));
  });
  count_left(report, problems);
  for (Problem& problem : problems)
    if (!is_told(call, results, problem.row()))
      add_left(report.left, reason_of(call, problem.row()), std::move(problem.elements), true);
}

void add_text(Text& text, const Text& more) { text += Text{text.en.empty() || more.en.empty() ? "" : " ", ""} + more; }

std::string count_change(const KindCount& kind, std::string_view name) {
  return std::string(name) + " " + std::to_string(kind.before) + " \u2192 " + std::to_string(kind.after);
}

void keep_changed(std::vector<KindCount>& findings) {
  std::erase_if(findings, [](const KindCount& kind) { return kind.before == kind.after; });
}

}  // namespace

RepairReport report_of(const RepairCall& call, const AlgorithmResult& result, const Mesh& after,
                       const RecipeInput& input) {
  RepairReport report{result.changed, result.text, {}, result.left_for, result.fault};
  if (!report.fault) add_found(report, call, {&result, 1}, after, input, result.drops_quarantined);
  return report;
}

RepairReport report_of(const RepairCall& call, const RecipeResult& result, const Mesh& after,
                       const RecipeInput& input) {
  RepairReport report;
  for (const AlgorithmResult& step : result.steps) {
    report.changed += result.is_changed ? step.changed : 0;
    if (step.changed > 0 || (step.left > 0 && step.left_for.empty())) add_text(report.text, step.text);
    report.left.insert(report.left.end(), step.left_for.begin(), step.left_for.end());
  }
  if (report.text.en.empty()) report.text = {"Nothing was changed.", "何も変わりません。"};
  report.findings = result.findings;
  keep_changed(report.findings);
  add_found(report, call, result.steps, after, input, result.drops_quarantined);
  return report;
}

std::optional<RepairReport> try_repair(Mesh mesh, const RepairCall& call, const RecipeInput& input,
                                       const Progress::Report& progress) {
  if (call.in_rounds) {
    RecipeEvents events;
    if (progress)
      events.progress = [&](const RecipeStep& step, std::size_t, double share) {
        const auto done = static_cast<double>(&step - call.steps.data());
        return progress((done + share) / static_cast<double>(call.steps.size()));
      };
    const std::optional<RecipeResult> result = run_recipe(mesh, call.steps, input, events);
    if (!result) return std::nullopt;
    return report_of(call, *result, result->mesh, input);
  }
  const RecipeStep& step = call.steps.front();
  ReadValues values = step.values.on(mesh);
  if (!values.values) return RepairReport{0, {}, {}, {}, std::move(values.sentence)};
  std::vector<KindCount> findings;
  count_kinds(mesh, input, true, &KindCount::before, findings);
  Progress at_work(progress);
  Journal journal;  // what changes nothing in the end is taken back
  std::optional<Edit> edit(std::in_place, mesh, &journal);
  FindingCounts counts = count_findings(mesh, input.on_lines);
  const AlgorithmResult result =
      run_guarded(*edit, *step.row, {*values.values, input.used_elsewhere, input.quarantine.size(), input.on_lines},
                  at_work, counts);
  if (at_work.is_cancelled()) return std::nullopt;
  if (result.changed > 0) edit->commit();
  edit.reset();
  RepairReport report = report_of(call, result, mesh, input);
  if (report.changed == 0) return report;
  count_kinds(mesh, input, !result.drops_quarantined, &KindCount::after, findings);
  keep_changed(findings);
  report.findings = std::move(findings);
  return report;
}

namespace {

// The first few that live.
Text names_of(std::span<const Element> elements, const Mesh& mesh) {
  constexpr std::size_t most_names = 3;
  Text names;
  std::size_t named = 0;
  for (const Element& element : elements) {
    if (named == most_names) break;
    if (!is_alive(mesh, element)) continue;
    const std::string name = name_of(mesh, element);
    names += (named++ == 0 ? Text() : Text{", ", "、"}) + Text{name, name};
  }
  if (named > 0 && named < elements.size()) names += Text{", ...", "…"};
  return names;
}

Text counted_elements(std::span<const Element> elements) {
  switch (elements.front().kind) {
    case Element::Kind::vertex:
      return count_text(elements.size(), "one vertex", "# vertices", "頂点 # 個");
    case Element::Kind::face:
      return count_text(elements.size(), "one face", "# faces", "面 # 枚");
    default:
      return count_text(elements.size(), "one edge", "# edges", "稜線 # 本");
  }
}

// What is left, and why: "2 vertices (v3, v7): joining them would ...".
Text told_with_subject(const LeftForReason& left, const Mesh& mesh) {
  if (left.names_them) return told(left, mesh);
  const Text names = names_of(left.elements, mesh);
  const Text named = names.en.empty() ? Text() : Text{" (", "（"} + names + Text{")", "）"};
  return counted_elements(left.elements) + named + Text{": ", "："} + left.reason;
}

// The first so many, and the number of the others.
Text first_of(const std::vector<Text>& parts, std::size_t most, const Text& between) {
  Text text;
  for (std::size_t i = 0; i < std::min(most, parts.size()); ++i) text += (i == 0 ? Text() : between) + parts[i];
  if (most >= parts.size()) return text;
  return text + between + count_text(parts.size() - most, "and one more", "and # more", "ほか # 件");
}

}  // namespace

Text told(const LeftForReason& left, const Mesh& mesh) {
  const Text names = names_of(left.elements, mesh);
  const std::string n = std::to_string(left.elements.size());
  const Text between = names.en.empty() ? Text() : Text{": ", "："};
  return left.reason + Text{" (" + n, "（" + n} + between + names + Text{")", "）"};
}

Text in_short(const RepairReport& report) {
  Text text = report.text;
  if (report.problems > 0)
    add_text(text,
             count_text(report.problems, "One problem is left.", "# problems are left.", "問題が # 件残ります。"));
  if (report.others > 0)
    add_text(text, count_text(report.others, "One element stays as it is.", "# elements stay as they are.",
                              "# 要素はそのまま残ります。"));
  return text;
}

namespace {

// Up to the first of these signs.
std::string_view before_any(std::string_view text, std::initializer_list<std::string_view> signs) {
  std::size_t end = text.size();
  for (const std::string_view sign : signs) end = std::min(end, text.find(sign));
  return text.substr(0, end);
}

}  // namespace

Text in_numbers(const RepairReport& report) {
  RepairReport only_numbers;
  only_numbers.text = report.changed == 0 ? Text{"No change.", "変更なし。"}
                                          : count_text(report.changed, "One change.", "# changes.", "変更 # 件。");
  only_numbers.problems = report.problems;
  only_numbers.others = report.others;
  return in_short(only_numbers);
}

Text in_one_clause(const RepairReport& report) {
  RepairReport brief = report;
  if (report.changed == 0 && report.left.size() == 1) {
    const Text& reason = report.left.front().reason;  // what would help stands in brackets
    brief.text = {"No change: " + std::string(before_any(reason.en, {" ("})) + ".",
                  "変更なし：" + std::string(before_any(reason.ja, {"（"})) + "。"};
    brief.others = 0;
  } else if (report.text.en.find(". ") != std::string::npos) {
    return in_numbers(report);
  } else {
    brief.text = {std::string(before_any(report.text.en, {":", ";", "."})) + ".",
                  std::string(before_any(report.text.ja, {"：", "（", "。"})) + "。"};
  }
  return in_short(brief);
}

Text told(const RepairReport& report, const Mesh& mesh, std::size_t most) {
  if (report.fault) return *report.fault + Text{".", "。"};
  Text text = report.text;
  std::vector<Text> changes, left;
  for (const KindCount& kind : report.findings) {
    const ProblemRow& row = row_of(kind.kind);
    changes.push_back({count_change(kind, row.name_en), count_change(kind, row.name_ja)});
  }
  for (const LeftForReason& one : report.left)
    if (text.en.find(one.reason.en) == text.en.npos)  // an algorithm may have said it itself
      left.push_back(told_with_subject(one, mesh));
  const std::size_t told_changes = std::min(changes.size(), std::max<std::size_t>(most, 2) - 1);
  if (!changes.empty()) add_text(text, first_of(changes, told_changes, {", ", "、"}) + Text{".", "。"});
  if (!left.empty())
    add_text(text, Text{"Left: ", "残り："} +
                       first_of(left, std::max<std::size_t>(most, told_changes + 1) - told_changes, {"; ", "、"}) +
                       Text{".", "。"});
  return text;
}

}  // namespace ryosen
