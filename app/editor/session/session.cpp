#include "app/editor/session/session.h"

#include <cassert>
#include <new>
#include <utility>

#include "app/editor/camera/first_camera.h"
#include "app/editor/camera/framing.h"
#include "app/editor/input/view_input.h"
#include "app/editor/recovery/autosave.h"

namespace ryosen {

Session::Session(std::unique_ptr<Document> document) {
  for (const HighlightRow& row : highlight_table())
    if (row.is_shown_at_first()) view.highlights.insert(std::string(row.id));
  set_document(std::move(document));
}

bool Session::is_at_start() const {
  return !begins_empty && is_empty() && document_->path().empty() && document_->history().empty();
}

bool Session::is_empty() const { return !awaits_file && !document_->is_on_trial() && mesh().live() == ElementCounts(); }

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
  Covered covered = covered_view(*this);
  covered.above = 0;  // what is played ends
  const Camera camera_then = framing({&document->mesh()}, first, view.size, covered);
  document->before_writing = [this] {
    preparation_.reset();
    trials_.let_write();
  };
  trials_.forget();
  if (frontend.autosave) frontend.autosave->begin(*document);
  preparation_.reset();
  document_ = std::move(document);
  changes_.begin(document_->serial());
  beside_.reset();
  surface_.reset();
  change_on_disk_ = FileState::Change::none;
  files = std::move(files_then);
  view.camera = framed_ = camera_then;
  shown.forget();
  forget_derived();
  file_normals_ = FileNormals();
  remedy_line_.clear();
  selection.clear();
  selections.clear();
  view.colouring.reset();
  measures.clear();
  view.links.forget_trail();
  view.cut.reset();
  log_.clear();
}

void Session::forget_derived() {
  shown.forget_aside();
  map_values_.reset();
  preparation_.reset();  // it builds the tree of the picker
  hidden_ = HiddenElements();
  picker_.reset();
  corner_normals_.reset();
  file_normals_.end();
  highlights_.reset();
  boundary_loops_.reset();
  euler_.reset();
  kind_.reset();
  hover_.reset();
  pointed_handle_ = nullptr;
  tool_verdicts_.reset();
  gesturing_.reset();
  release_verdict();
  changes_.note_everything();
}

void Session::follow(const Journal& journal, std::size_t transaction, Document::Change change) {
  try {
    update_derived(journal, transaction, change);
  } catch (const std::bad_alloc&) {
    forget_derived();
    selection.clear();
  }
}

void Session::update_derived(const Journal& journal, std::size_t transaction, Document::Change change) {
  const Mesh& m = mesh();
  if (change == Document::Change::tried) {  // nothing is pointed at meanwhile: a preview would touch the trial
    release_verdict();
    hover_.reset();
    shown.set_aside();
  }
  if (change == Document::Change::trial_ended) forget_gesture();
  const TouchedElements touched = touched_elements(m, journal, transaction);
  hidden_.follow(m, touched);
  if (touched.everything) view.links.forget_trail();
  const bool is_trial = change == Document::Change::tried || change == Document::Change::trial_ended;
  const bool has_normals =
      !is_trial && change != Document::Change::undone && document_->history()[transaction].has_normals;
  if (has_normals)
    file_normals_ = FileNormals();
  else if (!is_trial)
    file_normals_.follow(m, touched);
  if (picker_) {
    const std::vector<std::uint32_t> slots = picker_->update(m, touched);
    if (corner_normals_ && (touched.everything || !needs_corner_normals())) {
      corner_normals_.reset();
      changes_.note_everything();  // what was drawn with them knows nothing of this edit
    }
    if (corner_normals_) picker_->note_changed(corner_normals_->update(m, picker_->triangles(), touched));
    if (touched.everything) changes_.note_everything();
    picker_->note_changed(slots);
    for (Vertex v : touched.moved) changes_.note_vertex(v.index);
    for (Face f : touched.faces) changes_.note_face(f.index);
  }
  if (tool_verdicts_ && touched.everything)
    tool_verdicts_.reset();
  else if (tool_verdicts_ && !is_trial)
    tool_verdicts_->follow(m, touched);
  if (!is_trial) {
    update_map_values(transaction);
  } else if (map_values_) {  // a trial is no transaction of the history
    map_values_.reset();
    map_extent_.reset();
    changes_.note_everything();
  }
  if (highlights_) {
    forget_hidden();
    highlights_->update(m, journal, transaction);
    if (highlights_->changed_everything()) changes_.note_everything();
    for (const ChangeFeed::Marked& marked : highlights_->changes()) changes_.note_mark(marked);
    note_marks(touched);
    // A mark at a point is hidden with all its copies, wherever they are.
    if (!hidden_.empty() && m.has_copies()) changes_.note_search();
  }
  if (boundary_loops_) {
    const IndexSet& boundary = highlights_->of(ProblemKind::boundary_loop);
    Neighbourhood around(m);
    if (highlights_->changed_everything())
      boundary_loops_->search(around, boundary);
    else
      boundary_loops_->update(around, boundary, highlights_->problems().edges_asked());
  }
  if (euler_) {
    const std::string_view line =
        is_trial ? std::string_view() : std::string_view(document_->history()[transaction].command);
    const OpInfo* op = find_op(line.substr(0, line.find(' ')));
    const bool is_kept = op && op->topology == Topology::kept && !touched.everything &&
                         follow_operator(*euler_, m, highlights_->problems(), *boundary_loops_);
    if (!is_kept) euler_.reset();
  }
  if (change == Document::Change::made) {
    const HistoryEntry& entry = document_->history()[transaction];
    std::optional<SelectionMemory::Passage> passage;
    if (touched.everything) passage = {entry.lineage, entry.descent.get()};
    selections.made(transaction, selection.changed(), m, passage, journal.lengths_before(transaction));
  }
  if (change == Document::Change::undone) selections.undone(transaction, selection.changed(), m, touched.everything);
  if (change == Document::Change::redone) selections.redone(transaction, selection.changed(), m, touched.everything);
  if (change == Document::Change::tried && touched.everything) {
    selection.clear();
    measures.clear();
  }
  if (change == Document::Change::tried) drop_lost(selection.changed(), m, false);
  if (change == Document::Change::trial_ended) shown.bring_back();
  drop_hidden(selection.changed());
  if (is_verdict_held_)
    ask_held_verdict_again();
  else if (hover_)
    point_at(hover_->pixel, hover_->modifiers);
}

bool Session::look_at_disk() {
  const FileState::Change before = change_on_disk_;
  change_on_disk_ = document_->change_on_disk();
  if (change_on_disk_ == FileState::Change::gone) document_->mark_unsaved();  // no file holds this mesh any more
  return change_on_disk_ != before;
}

Input& Session::input() {
  if (const std::shared_ptr<Input> wanted = frontend.input.lock()) return *wanted;
  if (!view_input_) view_input_ = std::make_unique<ViewInput>(*this);
  return *view_input_;
}

Picker& Session::picker() {
  if (!picker_) picker_.emplace(mesh(), &hidden_);
  picker_->set_clip(view.clip_plane());
  return *picker_;
}

std::string Session::document_name() const {
  const std::string name = document_->path().filename().string();
  if (!name.empty() || is_at_start()) return name;
  return preferences.language == Language::japanese ? "（無題）" : "(unnamed)";
}

void Session::frame_all() {
  view.camera = framed_ = framing_of(*this, beside_ ? &beside_->mesh() : nullptr, view.camera);
}

}  // namespace ryosen
