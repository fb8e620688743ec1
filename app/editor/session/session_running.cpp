// Commands are carried out and kept in the log.
#include <cassert>
#include <new>
#include <utility>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "ryosen/base/resource_limits.h"

namespace ryosen {

template <class Run>
Outcome Session::run_safely(Run run) {
  const std::uint64_t serial = open_.document->serial();
  const std::size_t position = open_.document->position();
  try {
    return run();
  } catch (const std::bad_alloc&) {
    running_.clear();
    shown.forget();
    forget_derived();  // some of it may be half made
    if (open_.document->serial() == serial) {
      open_.document->take_back(position);
      drop_lost(selecting.selection.changed(), mesh(), false);
    }
    return failed(ExitCode::out_of_memory, out_of_memory().message.text);
  }
}

Outcome Session::run(const Command& command) {
  return run_safely([&] { return run_command(command); });
}

Outcome Session::run_command(const Command& command) {
  const std::string line = command.line(mesh());
  const std::vector<std::string_view> words = command.written() ? split_words(line) : std::vector<std::string_view>();
  if (command.written() && words.empty()) return {};
  const CommandRow* const row = row_of(command);
  if (!row) return unknown_command(words[0]);
  const Words arguments = words.empty() ? Words() : Words(words).subspan(1);
  const Effect effect = effect_of(*row, arguments);
  const std::uint64_t made_on = open_.document->revision();
  Shown::Passage passage(shown, effect, line);
  if (passage.answered) return *std::move(passage.answered);
  if (is_logged(effect)) gesturing.cancel();
  [[maybe_unused]] const std::uint64_t serial = open_.document->serial();
  [[maybe_unused]] const std::size_t position = open_.document->position();
  [[maybe_unused]] const std::size_t entries = open_.document->history().size();
  [[maybe_unused]] const std::size_t logged = lines_logged_;
  [[maybe_unused]] const bool was_on_trial = open_.document->is_on_trial();
  // What is needed once the command is done is made before.
  if (log_.size() + 2 > log_.capacity()) log_.reserve(2 * log_.size() + 2);
  std::string entry, usual = is_logged(effect) ? std::string(without_blanks(line)) : std::string();
  entry.reserve(2 * line.size() + 256);
  const std::string outer = std::exchange(running_, std::string(row->id));
  Outcome outcome = command.algorithm() ? run_algorithm(*this, *command.algorithm(), line)
                    : command.op()      ? apply(*command.op(), line, made_on)
                                        : row->run(*this, arguments, behind_id(line));
  running_ = outer;
  passage.finish(outcome);
  // A command that changes the mesh without saying so would be left out of the log; what is on trial is in none.
  assert(is_logged(effect) || lines_logged_ > logged ||
         (open_.document->position() == position && open_.document->history().size() == entries &&
          (open_.document->serial() == serial || was_on_trial || open_.document->is_on_trial())));
  if (!outcome.done() || !is_logged(effect)) return outcome;
  if (effect == Effect::edits || effect == Effect::steps)
    if (outcome.performed.empty()) outcome.performed = std::move(usual);
  if (outcome.performed.empty()) return outcome;
  if (!outcome.selecting.empty()) log_line(outcome, std::move(outcome.selecting));
  entry = outcome.performed;
  log_line(outcome, std::move(entry));
  return outcome;
}

// The line is read where the mesh is no longer the one that the operator was made on.
Outcome Session::apply(const AnyOp& op, const std::string& line, std::uint64_t made_on) {
  if (open_.document->revision() == made_on) {
    Outcome outcome = open_.document->apply(op, frontend.is_strict, line);
    if (outcome.done()) outcome.performed = line;
    return outcome;
  }
  const std::vector<std::string_view> words = split_words(line);
  return find_command_row(words[0])->run(*this, Words(words).subspan(1), behind_id(line));
}

Text Session::at_work() const { return name_of_command(running_); }

void Session::log_line(Outcome& outcome, std::string line) {
  log_.push_back(std::move(line));
  ++lines_logged_;
  if (!frontend.autosave) return;
  try {
    if (const auto warning = frontend.autosave->note(*open_.document, log_)) outcome.say(*warning);
  } catch (const std::bad_alloc&) {
    frontend.autosave->stop();
  }
}

}  // namespace ryosen
