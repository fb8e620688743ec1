// A command line is carried out, and kept in the log.
#include <cassert>
#include <new>
#include <optional>
#include <utility>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/words.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/levels.h"
#include "app/editor/textbook/playing.h"
#include "ryosen/base/out_of_memory.h"

namespace ryosen {

Outcome Session::run(const std::string& line) {
  const std::uint64_t serial = document_->serial();
  const std::size_t position = document_->position();
  try {
    return run_line(line);
  } catch (const std::bad_alloc&) {
    running_.clear();
    forget_derived();  // some of it may be half made
    if (document_->serial() == serial) {
      document_->take_back(position);
      drop_lost(selection.changed(), mesh(), false);
    }
    return failed(ExitCode::out_of_memory, out_of_memory().message.text);
  }
}

Outcome Session::run_line(const std::string& line) {
  const std::vector<std::string_view> words = split_words(line);
  if (words.empty()) return {};
  const auto row = find_command_row(words[0]);
  if (!row) return unknown_command(words[0]);
  const std::size_t after_id = static_cast<std::size_t>(words[0].data() - line.data()) + words[0].size();
  if (row->leaves_level && shows_level(*this)) return leave_level(*this);
  // What is seen is not what would be edited. A level is made to what it was made of.
  const bool makes_level = shows_level(*this) && without_blanks(line) == levels->line();
  const bool edits = (row->effect == Effect::edits || row->leads_to_edits) && !makes_level;
  if (edits && shows_another_mesh(*this)) return not_on_a_step(*this);
  std::optional<PlayerAside> played;
  std::optional<LevelAside> level;
  const bool needs_elements = row->effect == Effect::none && !row->keeps_trial;
  if (row->effect != Effect::none) cancel_gesture();
  if (row->effect != Effect::none || (needs_elements && document_->is_on_trial())) {
    played.emplace(*this, row->effect);
    level.emplace(*this, row->effect);
  }
  if (needs_elements) end_trial();
  [[maybe_unused]] const std::uint64_t serial = document_->serial();
  [[maybe_unused]] const std::size_t position = document_->position();
  [[maybe_unused]] const std::size_t entries = document_->history().size();
  [[maybe_unused]] const std::size_t logged = lines_logged_;
  [[maybe_unused]] const bool was_on_trial = document_->is_on_trial();
  // What is needed once the command is done is made before.
  if (log_.size() + 2 > log_.capacity()) log_.reserve(2 * log_.size() + 2);
  std::string entry, usual = row->effect == Effect::none ? std::string() : std::string(without_blanks(line));
  entry.reserve(2 * line.size() + 256);
  const std::string outer = std::exchange(running_, std::string(row->id));
  Outcome outcome = row->run(*this, Words(words).subspan(1), std::string_view(line).substr(after_id));
  running_ = outer;
  if (played) played->bring_back(outcome);
  if (level) level->bring_back(outcome);
  // A row that says `none` of a command that changes the mesh would leave it out of the log; what is on trial is in none.
  assert(row->effect != Effect::none || lines_logged_ > logged ||
         (document_->position() == position && document_->history().size() == entries &&
          (document_->serial() == serial || was_on_trial || document_->is_on_trial())));
  if (!outcome.done() || row->effect == Effect::none) return outcome;
  if (row->effect == Effect::edits || row->effect == Effect::steps)
    if (outcome.performed.empty()) outcome.performed = std::move(usual);
  if (outcome.performed.empty()) return outcome;
  if (!outcome.selecting.empty()) log_line(outcome, std::move(outcome.selecting));
  entry = outcome.performed;
  log_line(outcome, std::move(entry));
  return outcome;
}

Text Session::at_work() const { return name_of_command(running_); }

void Session::log_line(Outcome& outcome, std::string line) {
  log_.push_back(std::move(line));
  ++lines_logged_;
  if (!autosave) return;
  try {
    if (const auto warning = autosave->note(*this, log_.back())) outcome.say(*warning);
  } catch (const std::bad_alloc&) {
    autosave->stop();
  }
}

}  // namespace ryosen
