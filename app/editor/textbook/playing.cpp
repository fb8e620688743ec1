#include "app/editor/textbook/playing.h"

#include <atomic>
#include <utility>

#include "app/editor/camera/framing.h"
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/commands.h"
#include "app/editor/commands/script.h"
#include "app/editor/commands/words.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/levels.h"
#include "app/editor/textbook/exercises.h"
#include "ryosen/io/input_file.h"
#include "ryosen/steps/players.h"

namespace ryosen {

namespace {

Failure usage(Text sentence) { return make_failure(ExitCode::usage, "bad_arguments", std::move(sentence)); }

std::vector<std::string> lines_of(std::string_view script) {
  std::vector<std::string> lines;
  for (ScriptLine& line : split_script(script)) lines.push_back(std::move(line.text));
  return lines;
}

Result<std::unique_ptr<steps::Sequence>> make_script(const Mesh& mesh, const steps::StepsRow& row,
                                                     std::span<const std::string> words) {
  if (words.size() != 2)
    return usage({"'" + steps::call_of(row) + "': S is an exercise or figure (" + built_in_script_ids() +
                      ") or the name of a script file.",
                  "「" + steps::call_of(row) + "」の S は演習・図（" + built_in_script_ids() +
                      "）かスクリプトのファイル名です。"});
  if (const ExerciseScript* const exercise = find_built_in_script(words[1]))
    return row.make(Mesh(), lines_of(exercise->script));
  const Result<FileBytes> bytes = read_whole_file(words[1]);
  if (!bytes) return bytes.failure();
  return row.make(mesh, lines_of(bytes->view()));
}

std::string line_of_call(std::span<const std::string> words) {
  std::string line;
  for (const std::string& word : words) line += line.empty() ? word : " " + file_argument(word);
  return line;
}

void look_as_before(Session& session, const Player& player) {
  if (!player.camera_before) return;
  session.camera = *player.camera_before;
  if (player.was_framed) session.frame_all();
}

Text end_of(const Player& player) {
  const Text name = player.name();
  return {"The steps of '" + name.en + "' are left.", "「" + name.ja + "」の再生を終えました。"};
}

std::uint64_t next_player_serial() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

}  // namespace

Result<const steps::StepsRow*> find_played(std::string_view word) {
  if (const steps::StepsRow* const row = steps::find_steps(word)) return row;
  std::vector<std::string> ids;
  std::string known;
  for (const steps::StepsRow& row : steps::all_steps()) {
    ids.emplace_back(row.id);
    known += (known.empty() ? "" : ", ") + steps::call_of(row);
  }
  const Text hint = did_you_mean(word, ids, HintForm::sentence);
  return usage({"There is nothing to play by the name '" + std::string(word) + "'; there are " + known + "." + hint.en,
                "「" + std::string(word) + "」という再生はありません（" + known + "）。" + hint.ja});
}

bool is_script_file(std::string_view name) { return name != history_word && !find_built_in_script(name); }

Result<std::unique_ptr<steps::Sequence>> make_played(const Mesh& mesh, std::span<const std::string> words) {
  const Result<const steps::StepsRow*> row = find_played(words.empty() ? std::string_view() : words[0]);
  if (!row) return row.failure();
  if ((*row)->plays_script) return make_script(mesh, **row, words);
  return (*row)->make(mesh, words.subspan(1));
}

Result<std::unique_ptr<steps::Sequence>> make_played(const Document& document, std::span<const std::string> words) {
  if (words.size() != 2 || words[1] != history_word) return make_played(document.mesh(), words);
  const Result<const steps::StepsRow*> row = find_played(words[0]);
  if (!row) return row.failure();
  if (!(*row)->plays_script) return make_played(document.mesh(), words);
  std::vector<std::string> lines;
  for (const HistoryEntry& entry : document.history()) lines.push_back(entry.command);
  if (lines.empty())
    return make_failure(
        ExitCode::refused, "refused",
        {"The history is empty: edit the mesh first.", "履歴がありません。先にメッシュを編集してください。"});
  return steps::play_history(document.mesh(), document.journal(), lines);
}

Text name_of_played(std::span<const std::string> words) {
  const steps::StepsRow* const row = words.empty() ? nullptr : steps::find_steps(words[0]);
  if (!row) return {};
  if (row->plays_script && words.size() == 2) {
    if (const ExerciseScript* const exercise = find_built_in_script(words[1])) return name_of_exercise(*exercise);
    if (words[1] == history_word) return {"The history of this mesh", "このメッシュの履歴"};
  }
  Text name{std::string(row->en), std::string(row->ja)};
  for (const std::string& word : words.subspan(1)) name = name + Text{" " + word, " " + word};
  return name;
}

std::string shown_name(const Session& session, bool with_beneath) {
  const Document& document = session.document();
  const std::string file = (document.is_modified() ? "* " : "") + session.document_name();
  const Player* const player = session.player.get();
  const bool plays = player && player->edits() && player->is_shown(document);
  if (!plays && !shows_level(session)) return file;
  Text name = plays ? Text{"Playing: ", "再生中："} + player->name() : Text{"Level of detail", "詳細度の一段階"};
  const bool has_file = document.is_modified() || !document.path().empty();
  if (has_file && with_beneath) name = name + Text{" (beneath: " + file + ")", "（下に " + file + "）"};
  return name.in(session.language);
}

Player::Player(std::vector<std::string> words, std::unique_ptr<steps::Sequence> sequence, const Document& document)
    : player_serial_(next_player_serial()),
      words_(std::move(words)),
      call_(line_of_call(words_)),
      sequence_(std::move(sequence)),
      tables_(*sequence_),
      serial_(document.serial()),
      revision_(document.revision()),
      hash_(document.mesh().hash()),
      history_position_(document.position()) {}

bool Player::fits(const Document& document) const {
  return document.serial() == serial_ && document.position() == history_position_;
}

void Player::go_to(Document& document, std::size_t position) {
  position_ = position;
  step_.reset();
  if (position > 0) step_ = sequence_->at(position);
  if (sequence_->edits()) {
    const Mesh& mesh = sequence_->mesh_at(position);
    const bool differs = mesh.hash() != hash_;
    if (differs)
      document.show_on_trial(mesh.columns());
    else
      document.end_trial();
  }
  revision_ = document.revision();
}

void Player::end(Document& document) const {
  if (is_shown(document)) document.end_trial();
}

Outcome begin_playing(Session& session, std::span<const std::string> words) {
  end_playing(session);
  Document& document = session.document();
  session.end_trial();
  Result<std::unique_ptr<steps::Sequence>> sequence = make_played(document, words);
  if (!sequence) return failed(sequence.failure());
  session.player =
      std::make_shared<Player>(std::vector(words.begin(), words.end()), std::move(sequence).value(), document);
  if (session.player->begins_with_nothing()) {
    if (document.mesh().live().vertices > 0) session.player->camera_before = session.camera;
    session.player->was_framed = session.is_framed();
    session.player->go_to(document, session.player->size());
    with_places_to_frame(session.mesh(), [&](std::span<const glm::dvec3> places) {
      session.player->places_at_end.assign(places.begin(), places.end());
    });
    session.frame_all();
  } else if (session.is_framed() && session.covered_px != glm::dvec2(0)) {
    session.frame_all();
  }
  session.player->go_to(document, 0);
  return {};
}

bool shows_another_mesh(const Session& session) {
  const Document& document = session.document();
  return document.is_on_trial() && (shows_level(session) || (session.player && session.player->is_shown(document)));
}

Outcome not_on_a_step(const Session& session) {
  if (session.levels && session.levels->is_shown(session.document()))
    return failed(ExitCode::refused,
                  {"the view shows a level of detail, not the mesh that is open; Esc or levels close ends that",
                   "ビューは詳細度の一段階を表示中です。Esc または levels close で開いているメッシュに戻ります"});
  const Text name = session.player ? session.player->name() : Text();
  return failed(
      ExitCode::refused,
      {"the view shows a step of '" + name.en + "', not the mesh that is open; Esc or steps close ends that",
       "ビューは「" + name.ja + "」の手順を表示中です。Esc または steps close で開いているメッシュに戻ります"});
}

void end_playing(Session& session) {
  const std::shared_ptr<Player> player = std::exchange(session.player, nullptr);
  if (!player) return;
  player->end(session.document());
  look_as_before(session, *player);
}

Outcome leave_playing(Session& session) {
  Outcome outcome;
  outcome.sentence = end_of(*session.player);
  end_playing(session);
  return outcome;
}

PlayerAside::PlayerAside(Session& session, Effect effect)
    : session_(session),
      player_(std::move(session.player)),
      camera_(session.camera),
      document_serial_(session.document().serial()),
      was_shown_(player_ && player_->is_shown(session.document())),
      effect_(effect) {
  session.player.reset();
  if (player_) player_->end(session.document());
}

PlayerAside::~PlayerAside() {
  if (!is_back_ && player_ && !session_.player) session_.player = std::move(player_);
}

void PlayerAside::bring_back(Outcome& outcome) {
  is_back_ = true;
  if (!player_ || session_.player) return;
  Document& document = session_.document();
  if (player_->fits(document) && !document.is_on_trial()) {
    session_.player = player_;
    if (!was_shown_) return;
    if (outcome.done() && effect_ == Effect::none) return show_beneath(outcome);
    player_->go_to(document, player_->position());
    if (outcome.done() && effect_ == Effect::writes && session_.shows_step())
      outcome.say({"This is the open mesh, not the step that is shown.",
                   "保存したのは開いているメッシュで、表示中の手順ではありません。"});
  } else if (effect_ == Effect::steps) {
    make_anew(outcome);
  } else {
    if (document.serial() == document_serial_) look_as_before(session_, *player_);
    outcome.say(end_of(*player_));
  }
}

// Until the next step, and from where it was looked at before, unless the command looks from elsewhere. So what was taken
// back or done again is seen.
void PlayerAside::show_beneath(Outcome& outcome) {
  if (session_.camera == camera_) look_as_before(session_, *player_);
  const Text name = player_->name();
  outcome.say({"The view shows the open mesh; the next step shows '" + name.en + "' again.",
               "ビューは開いているメッシュです。次の手順で「" + name.ja + "」に戻ります。"});
}

void PlayerAside::make_anew(Outcome& outcome) {
  const std::size_t position = player_->position();
  const Text name = player_->name();
  if (const Outcome begun = begin_playing(session_, player_->words()); !begun.done()) {
    look_as_before(session_, *player_);
    return outcome.say(Text{"The steps of '" + name.en + "' are left: ", "「" + name.ja + "」の再生を終えました："} +
                       begun.sentence);
  }
  session_.player->camera_before = player_->camera_before;
  session_.player->was_framed = player_->was_framed;
  session_.player->is_running = player_->is_running;
  session_.camera = camera_;
  player_ = session_.player;
  player_->go_to(session_.document(), std::min(position, player_->size()));
  if (!session_.shows_step()) return;
  session_.document().end_trial();
  if (was_shown_) show_beneath(outcome);
}

}  // namespace ryosen
