#include "app/editor/textbook/playing.h"

#include <utility>

#include "app/editor/commands/text/outcomes.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/shown/shown.h"
#include "app/editor/textbook/exercises.h"
#include "ryosen/document/document.h"
#include "ryosen/io/input_file.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/textbook/steps/players.h"

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
  for (const std::string& word : words.subspan(1)) name += Text{" " + word, " " + word};
  return name;
}

StepsPlayer::StepsPlayer(std::vector<std::string> words, std::unique_ptr<steps::Sequence> sequence, const Mesh& mesh)
    : words_(std::move(words)),
      call_(line_of_call(words_)),
      sequence_(std::move(sequence)),
      tables_(*sequence_),
      hash_(mesh.hash()) {}

void StepsPlayer::take_step() {
  step_.reset();
  if (position() > 0) step_ = sequence_->at(position());
}

std::vector<Player::Mark> StepsPlayer::marks() const {
  std::vector<Mark> marks;
  if (!step_) return marks;
  for (const steps::Mark& mark : step_->marks)
    if (const steps::RoleRow& role = steps::row_of(mark.role); role.is_label) marks.push_back({mark.element, role.id});
  return marks;
}

const Mesh* StepsPlayer::other_mesh() const {
  if (!sequence_->edits()) return nullptr;
  const Mesh& mesh = sequence_->mesh_at(position());
  return mesh.hash() == hash_ ? nullptr : &mesh;
}

Result<std::shared_ptr<Player>> StepsPlayer::again(const Document& document) const {
  return make_player(document, words_);
}

Result<std::shared_ptr<Player>> make_player(const Document& document, std::span<const std::string> words) {
  Result<std::unique_ptr<steps::Sequence>> sequence = make_played(document, words);
  if (!sequence) return sequence.failure();
  return std::shared_ptr<Player>(std::make_shared<StepsPlayer>(std::vector(words.begin(), words.end()),
                                                               std::move(sequence).value(), document.mesh()));
}

Outcome begin_playing(const Document& document, ViewState& view, Framing& framing, Shown& shown,
                      std::span<const std::string> words) {
  end_playing(view, framing, shown);
  shown.end();
  const Result<std::shared_ptr<Player>> player = make_player(document, words);
  if (!player) return failed(player.failure());
  begin_playing(document, view, framing, shown, *player);
  return {};
}

std::shared_ptr<StepsPlayer> steps_player(const Shown& shown) {
  return std::dynamic_pointer_cast<StepsPlayer>(shown.player());
}

}  // namespace ryosen
