// The levels of detail of a mesh, and the edges that the last simplification left.
#include <charconv>
#include <utility>

#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/levels.h"
#include "app/editor/shown/player.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/edge_rules.h"
#include "ryosen/algo/simplify/simplify.h"
#include "ryosen/base/rows.h"
#include "ryosen/io/edited_file.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

std::optional<std::size_t> face_count(std::string_view word) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size() ? std::optional(number) : std::nullopt;
}

Outcome no_levels() {
  return failed(ExitCode::refused, {"there are no levels of detail yet; begin with levels",
                                    "詳細度がまだありません。まず levels で作ってください"});
}

Text told(const ShownLevels& levels) {
  const std::string n = std::to_string(levels.faces()), all = std::to_string(levels.faces(0));
  return {n + " of " + all + " faces.", "面 " + all + " 枚中 " + n + " 枚。"};
}

// The values on this mesh, as those of a simplification.
ParameterValues as_of_simplify(const ParameterValues& given) {
  ParameterValues values(find_algorithm("simplify")->parameters);
  for (const ParameterRow& row : given.rows())
    if (const std::string text = given.text(row.id); !text.empty()) values.set(row.id, text, row.id);
  return values;
}

Outcome begin_levels(Session& session, Words words) {
  const ReadValues given = read_values(level_parameters(), words);
  if (!given.values) return usage_error(behind("levels", given.sentence));
  const Text left =
      session.shown.player() ? leave_playing(session.view, session.framing, session.shown).sentence : Text();
  session.shown.end_levels();
  session.shown.end();
  const ParameterValues values = as_of_simplify(*given.values);
  const ReadValues found = values.on(session.mesh());
  const auto telling = [&](Outcome outcome) {
    if (!left.en.empty()) outcome.say(left);
    return outcome;
  };
  if (!found.values) return telling(failed(found.lacks_extent ? ExitCode::refused : ExitCode::usage, found.sentence));
  Progress progress(session.frontend.on_progress);
  const std::vector<Vertex> on_lines = vertices_on_lines(session.document().file(), session.mesh().file_vertices());
  BuiltLevels built = build_levels(session.mesh(), {.values = *found.values, .on_lines = on_lines}, progress);
  if (built.refused) return telling(failed(ExitCode::refused, behind("levels", *built.refused)));
  if (!built.levels) return telling(cancelled());
  session.shown.begin(std::make_shared<ShownLevels>(std::move(built.levels), values, session.document()));
  session.shown.go_to_level(0);
  session.layout.show(panel_opened_by(PanelOpener::levelled), true);
  Outcome outcome;
  const std::string least = std::to_string(session.shown.levels()->faces(session.shown.levels()->levels().last()));
  outcome.sentence =
      told(*session.shown.levels()) + Text{" The last level has " + least + ".", "最も粗い段階は " + least + " 枚。"};
  return telling(std::move(outcome));
}

Outcome go_to_level(Shown& shown, std::size_t faces) {
  if (!shown.fits()) {
    shown.end_levels();
    return failed(ExitCode::refused, {"the mesh has changed since; begin again with levels",
                                      "その後メッシュが変わりました。もう一度 levels で始めてください"});
  }
  shown.go_to_level(shown.levels()->level_of(faces));
  return done_with(told(*shown.levels()));
}

const EdgeRuleRow* find_rule(std::string_view id) { return find_row(edge_rule_table(), id); }

void select_under(Selecting& selecting, const LeftEdges& left_edges, EdgeRule rule) {
  Elements found;
  for (std::uint32_t i = 0; i < left_edges.rules.size(); ++i)
    if (left_edges.rules[i] == static_cast<std::uint8_t>(rule)) found.emplace_back(Edge(i));
  selecting.selection = std::move(found);
}

}  // namespace

std::string levels_syntax() { return "[NAME=VALUE ...]|at FACES|keep|close"; }

bool levels_take_long(Words arguments) {
  return arguments.empty() || arguments[0].find('=') != std::string_view::npos || arguments[0] == "keep";
}

std::optional<Text> fault_of_levels(Words arguments, const std::string&) {
  if (arguments.empty()) return std::nullopt;
  if (arguments[0] == "at") return fault_unless(arguments.size() == 2 && face_count(arguments[1]), "levels");
  if (arguments[0] == "keep" || arguments[0] == "close") return fault_unless(arguments.size() == 1, "levels");
  ReadValues read = read_values(level_parameters(), arguments);
  return read.values ? std::nullopt : std::optional(behind("levels", read.sentence));
}

Outcome run_levels(Session& session, Words arguments, std::string_view) {
  if (const auto fault = fault_of_levels(arguments, {})) return usage_error(*fault);
  const std::string_view word = arguments.empty() ? std::string_view() : arguments[0];
  if (word == "close") {
    session.shown.end_levels();
    return {};
  }
  if (word != "at" && word != "keep") return begin_levels(session, arguments);
  if (!session.shown.levels()) return no_levels();
  if (word == "at") return go_to_level(session.shown, *face_count(arguments[1]));
  const std::string line = session.shown.levels()->line();
  return session.run(line);  // which ends them
}

std::string account_syntax() { return "[" + joined_ids(edge_rule_table()) + "]"; }

std::optional<Text> fault_of_account(Words arguments, const std::string&) {
  const bool is_known = arguments.empty() || (arguments.size() == 1 && find_rule(arguments[0]));
  return fault_unless(is_known, "account");
}

Outcome run_account(Session& session, Words arguments, std::string_view) {
  if (const auto fault = fault_of_account(arguments, {})) return usage_error(*fault);
  if (line_to_account_for(session.document(), session.shown).empty())
    return failed(ExitCode::refused, {"there is no account; simplify makes one, until the next change",
                                      "内訳がありません。simplify の直後、次の変更までの間だけ示せます"});
  const LeftEdges* const left_edges =
      find_left_edges(session.document(), session.findings(), session.shown, session.frontend);
  if (!left_edges) return cancelled();
  session.layout.show(panel_opened_by(PanelOpener::levelled), true);
  Outcome outcome;
  if (!arguments.empty()) {
    select_under(session.selecting, *left_edges, find_rule(arguments[0])->rule);
    return outcome;
  }
  for (const EdgeRuleRow& row : edge_rule_table()) {
    const std::size_t count = left_edges->counts[static_cast<std::size_t>(row.rule)];
    if (count == 0) continue;
    const std::string number = std::to_string(count);
    const Text one{std::string(row.id) + " " + number, std::string(row.name_ja) + " " + number};
    outcome.sentence = outcome.sentence.en.empty() ? one : outcome.sentence + Text{", ", "、"} + one;
  }
  return outcome;
}

}  // namespace ryosen
