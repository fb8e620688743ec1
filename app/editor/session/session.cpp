#include "app/editor/session/session.h"

#include <cassert>
#include <new>
#include <utility>

#include "app/editor/camera/first_camera.h"
#include "app/editor/input/input.h"
#include "app/editor/recovery/autosave.h"

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

}  // namespace ryosen
