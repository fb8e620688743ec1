#include "app/editor/session/session.h"

#include <algorithm>
#include <cassert>
#include <new>
#include <utility>

#include "app/editor/camera/framing.h"
#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/input/input.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/recovery/autosave.h"
#include "ryosen/base/resource_limits.h"
#include "ryosen/document/document.h"

namespace ryosen {

Session::Session(std::unique_ptr<Document> document) {
  for (const HighlightRow& row : highlight_table())
    if (row.is_shown_at_first()) view.highlights.insert(std::string(row.id));
  set_document(std::move(document));
}

Session::~Session() { trials.forget(); }  // one that goes on reads the document

bool Session::is_at_start() const {
  return !frontend.begins_empty && is_empty() && open_.document->path().empty() && open_.document->history().empty();
}

bool Session::is_empty() const {
  return !frontend.awaits_file && !open_.document->is_on_trial() && mesh().live() == ElementCounts();
}

// What may find no memory comes first.
void Session::set_document(std::unique_ptr<Document> document, std::optional<std::filesystem::path> read_from) {
  RunFiles files_then = files;
  files_then.begin_document();
  const std::filesystem::path& source = read_from ? *read_from : document->path();
  if (!source.empty()) files_then.reads(source, FileRole::mesh);
  document->add_listener([this](const Journal& journal, std::size_t transaction, Document::Change change) {
    follow(journal, transaction, change);
  });
  const Camera first = frontend.turns_to_solids ? first_camera_of(document->mesh()) : first_camera();
  Covered covered = framing.covered();
  covered.above = 0;  // what is played ends
  const Camera camera_then = ryosen::framing({&document->mesh()}, first, view.size, covered);
  document->before_writing = [this] {
    open_.findings->end_preparation();
    trials.let_write();
  };
  auto found = std::make_unique<Findings>(*document, view, preferences);
  if (open_.findings) found->take_views_of(*open_.findings);
  found->after_search = [this] { gesturing.judge_as_drawn(); };
  trials.forget();
  if (frontend.autosave) frontend.autosave->begin(*document);
  end_comparing();
  open_.findings = std::move(found);
  open_.document = std::move(document);
  change_on_disk_ = FileState::Change::none;
  files = std::move(files_then);
  framing.frame(camera_then);
  shown.forget();
  forget_pointed();
  selecting.begin_document();
  view.colouring.reset();
  view.links.forget_trail();
  view.cut.reset();
  log_.clear();
}

void Session::forget_derived() {
  open_.findings->forget();
  forget_pointed();
}

void Session::forget_pointed() {
  shown.forget_aside();
  selecting.forget_pointed();
  pointing.leave_handles();
  gesturing.drop();
}

void Session::follow(const Journal& journal, std::size_t transaction, Document::Change change) {
  try {
    update_derived(journal, transaction, change);
  } catch (const std::bad_alloc&) {
    forget_derived();
    selecting.selection.clear();
  }
}

void Session::update_derived(const Journal& journal, std::size_t transaction, Document::Change change) {
  if (change == Document::Change::tried) {  // nothing is pointed at meanwhile: a preview would touch the trial
    selecting.release_verdict();
    selecting.point_to({});
    shown.set_aside();
  }
  if (change == Document::Change::trial_ended) gesturing.forget();
  const TouchedElements touched = touched_elements(mesh(), journal, transaction);
  if (touched.everything) view.links.forget_trail();
  open_.findings->follow(journal, transaction, change, touched);
  selecting.follow(journal, transaction, change, touched);
  if (change == Document::Change::trial_ended) shown.bring_back();
  selecting.refresh();
}

void Session::prepare() {
  trials.follow(*open_.document);
  if (compared_) compared_->findings().prepare();
  selecting.ask_slice_of_verdicts();
  open_.findings->prepare();
}

bool Session::look_at_disk() {
  const FileState::Change before = change_on_disk_;
  change_on_disk_ = open_.document->change_on_disk();
  if (change_on_disk_ == FileState::Change::gone) open_.document->mark_unsaved();  // no file holds this mesh any more
  return change_on_disk_ != before;
}

Input& Session::input() {
  if (const std::shared_ptr<Input> wanted = frontend.input.lock()) return *wanted;
  if (!view_input_) view_input_ = make_view_input(*this);
  return *view_input_;
}

std::string Session::document_name() const {
  const std::string name = open_.document->path().filename().string();
  if (!name.empty() || is_at_start()) return name;
  return preferences.language == Language::japanese ? "（無題）" : "(unnamed)";
}

static constexpr int gap_px = 2;  // between the halves

void Session::place_view(Size whole, glm::dvec2 origin) {
  view.size = whole;
  view.origin = origin;
  if (!compared_) return;
  view.size.width = std::max(1, (whole.width - gap_px) / 2);
  compared_->place({std::max(1, whole.width - gap_px - view.size.width), whole.height},
                   origin + glm::dvec2(view.size.width + gap_px, 0));
}

void Session::end_comparing() {
  if (!compared_) return;
  pointing.remove(compared_->view());
  open_.findings->against = nullptr;
  compared_.reset();
}

void Session::compare_with(std::unique_ptr<Document> other) {
  Size whole = view.size;
  if (compared_) whole.width += gap_px + compared_->state().size.width;
  if (!other && view.colouring && view.colouring->map->against) view.colouring.reset();
  // Distances are measured from another mesh.
  if (view.colouring && view.colouring->map->against) open_.findings->changes().note_everything();
  auto compared = other ? std::make_unique<Compared>(std::move(other), preferences) : nullptr;
  if (compared) pointing.add(compared->view());  // the last that may find no memory
  end_comparing();
  compared_ = std::move(compared);
  if (compared_) open_.findings->against = &compared_->findings();
  if (compared_) compared_->findings().against = open_.findings.get();
  place_view(whole, view.origin);
  framing.frame_all_if_possible();
}

Compared* Session::compared() {
  if (!compared_) return nullptr;
  compared_->look_as(view);
  // Where this mesh has changed, so have the distances from it.
  if (view.colouring && view.colouring->map->against) compared_->findings().map_values(*view.colouring);
  return compared_.get();
}

SeenMesh Session::seen() { return {document(), findings(), view, preferences, gesturing.drawn_positions()}; }

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
  // Memory for the log is reserved first, so that nothing fails once the command is done.
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
