// The commands `exercise` and `figure`: the meshes of the source texts; and `steps`, which begins to play and goes
// through what is played.
#include "app/editor/textbook/textbook_commands.h"

#include <charconv>

#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/preferences/panel_list.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/levels.h"
#include "app/editor/textbook/exercises.h"
#include "app/editor/textbook/figures.h"
#include "app/editor/textbook/playing.h"
#include "ryosen/base/rows.h"

namespace ryosen {

std::optional<Text> fault_of_exercise(Words arguments, const std::string&) {
  const bool is_one = arguments.size() == 1 && find_exercise(arguments[0]);
  return fault_unless(is_one, "exercise");
}

// Its steps name their elements by numbers, which begin at 0 in an empty mesh without a history only.
Outcome run_exercise(Session& session, Words arguments, std::string_view) {
  if (fault_of_exercise(arguments, {})) return wrong_arguments("exercise");
  if (session.mesh().vertex_slots() > 0 || !session.document().path().empty())
    return failed(ExitCode::refused, {"an exercise begins with an empty mesh; first say: new",
                                      "演習は空のメッシュから始めます。先に new を実行してください"});
  Outcome outcome;
  for (const ScriptLine& line : split_script(find_exercise(arguments[0])->script))
    if (outcome = session.run(line.text); !outcome.done()) return outcome;
  session.document().mark_generated();
  if (session.frontend.autosave) session.frontend.autosave->note_document(session.document());
  session.framing.frame_all();
  outcome.performed.clear();
  outcome.sentence = {"Undo goes back through its steps.", "「元に戻す」で一手ずつ戻れます。"};
  return outcome;
}

std::optional<Text> fault_of_figure(Words arguments, const std::string&) {
  const bool is_one = arguments.size() == 1 && find_figure(arguments[0]);
  return fault_unless(is_one, "figure");
}

// An entry of the history, so that what is recovered has it too.
Outcome run_figure(Document& document, Framing& framing, Words arguments, std::string_view) {
  if (fault_of_figure(arguments, {})) return wrong_arguments("figure");
  if (document.mesh().vertex_slots() > 0 || !document.path().empty())
    return failed(ExitCode::refused, {"a figure comes into an empty mesh; first say: new",
                                      "図は空のメッシュに置きます。先に new を実行してください"});
  const Figure& figure = *find_figure(arguments[0]);
  Result<MeshFile> file = mesh_of_figure(figure);
  if (!file) return failed(file.failure());
  const std::string line = "figure " + std::string(figure.id);
  document.append(std::move(file).value(), line);
  document.mark_generated();
  framing.frame_all();
  Outcome outcome;
  outcome.performed = line;
  outcome.sentence = {std::string(figure.name_en) + ".", std::string(figure.name_ja) + "。"};
  return outcome;
}

namespace {

std::size_t one_back(const Player& player) { return player.position() > 0 ? player.position() - 1 : 0; }
std::size_t one_forward(const Player& player) { return std::min(player.position() + 1, player.size()); }

// A way through what is played: where it leads, and whether it goes on by itself then.
struct PlayerWay {
  std::string_view id;
  std::size_t (*to)(const Player& player);
  bool (*is_running)(const Player& player);
};
bool stops(const Player&) { return false; }
bool goes_on(const Player& player) { return player.is_running; }

constexpr PlayerWay player_ways[] = {
    {"first", [](const Player&) { return std::size_t{0}; }, stops},
    {"back", one_back, stops},
    {"forward", one_forward, goes_on},
    {"last", [](const Player& player) { return player.size(); }, stops},
    // From the end it begins anew.
    {"play", [](const Player& player) { return player.position() == player.size() ? 0 : player.position(); },
     [](const Player& player) { return !player.is_running; }},
    {"pause", [](const Player& player) { return player.position(); }, stops},
};

const PlayerWay* find_way(std::string_view id) { return find_row(player_ways, id); }

std::optional<std::size_t> step_number(std::string_view word) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size() ? std::optional(number) : std::nullopt;
}

Outcome nothing_played() {
  return failed(ExitCode::refused, {"nothing is played; begin with steps WHAT, as in steps script cube",
                                    "再生中のものがありません。steps script cube のように始めてください"});
}

Outcome refused_step(const Player& player) {
  const std::string n = std::to_string(player.size());
  return failed(ExitCode::usage, {"steps at: there are " + n + " steps here, from 0 for none done",
                                  "steps at：手順は " + n + " まで（0 は最初の状態）"});
}

// Goes there, or tells that the mesh is another one by now.
Outcome go_to_step(Framing& framing, Shown& shown, std::size_t position) {
  Player& player = *shown.player();
  if (!shown.fits()) {
    const std::string call = player.call();
    shown.end_steps();
    return failed(ExitCode::refused, {"the mesh has changed since; play it again: steps " + call,
                                      "再生を始めた後にメッシュが変わりました。もう一度：steps " + call});
  }
  const bool returns = !shown.shows(ShownBy::step) && player.camera_before;
  shown.go_to_step(position);
  if (returns) framing.frame_all();  // the mesh beneath was looked at meanwhile
  if (player.position() == player.size()) player.is_running = false;
  Outcome outcome;
  if (position > 0) outcome.sentence = player.caption();
  return outcome;
}

}  // namespace

std::string steps_syntax() {
  std::string syntax;
  for (const steps::StepsRow& row : steps::all_steps()) syntax += steps::call_of(row) + "|";
  for (const PlayerWay& way : player_ways) syntax.append(way.id).append("|");
  return syntax + "at N|close";
}

std::optional<Text> fault_of_steps(Words arguments, const std::string&) {
  if (arguments.empty()) return wrong_arguments("steps").sentence;
  if (find_way(arguments[0]) || arguments[0] == "close") return fault_unless(arguments.size() == 1, "steps");
  if (arguments[0] == "at") return fault_unless(arguments.size() == 2 && step_number(arguments[1]), "steps");
  const auto row = find_played(arguments[0]);
  return row ? std::nullopt : std::optional(row.failure().message.text);
}

// The words that call what is played; the name of a script may have blanks.
std::vector<std::string> called_words(RunFiles& files, Words arguments, std::string_view whole) {
  const auto row = find_played(arguments[0]);
  if (arguments.size() < 2 || !row || !(*row)->plays_script) return {arguments.begin(), arguments.end()};
  std::string name = file_name(behind_word(without_blanks(whole)));
  if (is_script_file(name)) files.reads(name, FileRole::script);
  return {std::string(arguments[0]), std::move(name)};
}

Outcome run_steps(Session& session, Words arguments, std::string_view whole) {
  if (const auto fault = fault_of_steps(arguments, {})) return usage_error(*fault);
  if (arguments[0] == "close") {
    end_playing(session.view, session.framing, session.shown);
    return {};
  }
  const PlayerWay* const way = find_way(arguments[0]);
  if (!way && arguments[0] != "at") {
    Outcome outcome = begin_playing(session.document(), session.view, session.framing, session.shown,
                                    called_words(session.files, arguments, whole));
    if (!outcome.done()) return outcome;
    session.layout.show(panel_opened_by(PanelOpener::played), true);
    outcome.sentence = steps_player(session.shown)->remark();
    if (session.shown.levels()) outcome.say(leave_level(session.shown).sentence);
    return outcome;
  }
  if (!session.shown.player()) return nothing_played();
  Player& player = *session.shown.player();
  if (!way) {
    const std::size_t number = *step_number(arguments[1]);
    return number > player.size() ? refused_step(player) : go_to_step(session.framing, session.shown, number);
  }
  const std::size_t to = way->to(player);
  player.is_running = way->is_running(player);
  return go_to_step(session.framing, session.shown, to);
}

}  // namespace ryosen
