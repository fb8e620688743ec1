#include "app/editor/session.h"

#include <cassert>
#include <chrono>
#include <new>
#include <utility>

#include "app/editor/autosave.h"
#include "app/editor/commands.h"
#include "app/editor/levels.h"
#include "app/editor/playing.h"
#include "app/editor/view_input.h"
#include "app/editor/words.h"
#include "core/base/out_of_memory.h"
#include "core/io/elements.h"
#include "core/mesh/circulate.h"
#include "core/mesh/find_element.h"

namespace ryosen {

namespace {

// From the front, slightly above and right, so that three sides of the shape are visible.
Camera first_camera() {
  Camera camera;
  camera.eye = {0.42, 0.36, 1};
  return camera;
}

}  // namespace

Session::Session(std::unique_ptr<Document> document) {
  for (const HighlightRow& row : highlight_table())
    if (row.is_shown_at_first()) shown.insert(std::string(row.id));
  for (const PanelRow& row : panel_list())
    if (row.place == PanelPlace::over && row.shown_at_first()) open_panel = row.id;
  set_document(std::move(document));
}

bool Session::is_shown(const PanelRow& panel) const {
  return panel.place == PanelPlace::over ? open_panel == panel.id : layout.is_shown(panel);
}

bool Session::is_at_start() const {
  return !begins_empty && document_->path().empty() && document_->history().empty() && mesh().live() == ElementCounts();
}

void Session::show(const PanelRow& panel, bool on) {
  if (on && panel.place != PanelPlace::over) layout.wanted = panel.id;
  if (is_shown(panel) == on) return;
  if (panel.place == PanelPlace::over)
    open_panel = on ? panel.id : "";
  else
    layout.show(panel, on);
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
  const Camera camera_then = framing(document->mesh(), first_camera());
  document->before_writing = [this] {
    preparation_.reset();
    trials_.let_write();
  };
  trials_.forget();
  if (autosave) autosave->begin(*document);
  preparation_.reset();
  document_ = std::move(document);
  beside_.reset();
  surface_.reset();
  change_on_disk_ = FileState::Change::none;
  files = std::move(files_then);
  camera = camera_then;
  aside_.reset();
  forget_derived();
  file_normals_ = FileNormals();
  remedy_line_.clear();
  selection.clear();
  selections.clear();
  colouring.reset();
  measures.clear();
  links.forget_trail();
  player.reset();
  levels.reset();
  cut.reset();
  log_.clear();
}

void Session::forget_derived() {
  if (aside_) selection = std::move(aside_->selection);
  aside_.reset();
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
  drawn_changes_ = DrawnChanges();
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
  if (change == Document::Change::tried) set_aside();
  if (change == Document::Change::trial_ended) forget_gesture();
  const TouchedElements touched = touched_elements(m, journal, transaction);
  hidden_.follow(m, touched);
  if (touched.everything) links.forget_trail();
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
      drawn_changes_.everything = true;  // what was drawn with them knows nothing of this edit
    }
    if (corner_normals_)
      for (const std::uint32_t slot : corner_normals_->update(m, picker_->triangles(), touched))
        drawn_changes_.triangles.push_back(slot);
    drawn_changes_.everything |= touched.everything;
    drawn_changes_.triangles.insert(drawn_changes_.triangles.end(), slots.begin(), slots.end());
    for (Vertex v : touched.moved) drawn_changes_.vertices.push_back(v.index);
    for (Face f : touched.faces) drawn_changes_.faces.push_back(f.index);
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
    drawn_changes_.everything = true;
  }
  if (highlights_) {
    forget_hidden();
    highlights_->update(m, journal, transaction);
    drawn_changes_.everything |= highlights_->changed_everything();
    for (const Marked& marked : highlights_->changes()) {
      if (marked.mark.sort == Element::Kind::face) drawn_changes_.faces.push_back(marked.index);
      drawn_changes_.marks.push_back(marked);
    }
    note_marks(touched);
    // A mark at a point is hidden with all its copies, wherever they are.
    drawn_changes_.searched |= !hidden_.empty() && m.has_copies();
  }
  if (drawn_changes_.everything) drawn_changes_ = DrawnChanges();  // the lists are not needed
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
                         follow_operator(*euler_, m, highlights_->problems(), boundary_loops_->count());
    if (!is_kept) euler_.reset();
  }
  if (change == Document::Change::made)
    selections.made(transaction, selection.changed(), m, touched.everything, journal.lengths_before(transaction));
  if (change == Document::Change::undone) selections.undone(transaction, selection.changed(), m, touched.everything);
  if (change == Document::Change::redone) selections.redone(transaction, selection.changed(), m, touched.everything);
  if (change == Document::Change::tried && touched.everything) {
    selection.clear();
    measures.clear();
  }
  if (change == Document::Change::tried) drop_lost(selection.changed(), m, false);
  if (change == Document::Change::trial_ended) bring_back();
  drop_hidden(selection.changed());
  if (is_verdict_held_)
    ask_held_verdict_again();
  else if (hover_)
    point_at(hover_->pixel, hover_->modifiers);
}

// Nothing is pointed at meanwhile: a preview would end the trial.
void Session::set_aside() {
  release_verdict();
  hover_.reset();
  Aside& aside = aside_.emplace(Aside{selection, measures, hidden_.elements(), {}, {}, {}});
  const bool is_of_now = highlights_ && searched_ && searched_->document == document_->serial() &&
                         searched_->revision + 1 == document_->revision();
  if (!is_of_now) return;
  aside.searched = searched_->kind;
  aside.findings = highlights_->of(searched_->kind).to_vector();
  aside.pairs = searched_->pairs;
}

void Session::bring_back() {
  if (!aside_) return;
  Aside aside = *std::exchange(aside_, std::nullopt);
  selection = aside.selection;
  measures = aside.measures;
  if (!aside.hidden.empty()) hide(aside.hidden);
  if (aside.searched) put_findings(*aside.searched, aside.findings, std::move(aside.pairs));
}

const MapValues& Session::map_values() {
  assert(colouring);
  const std::shared_ptr<const OtherSurface> other = colouring->map->against ? other_surface() : nullptr;
  if (!map_values_ || &map_values_->map() != colouring->map || map_values_->other() != other.get()) {
    map_extent_.reset();
    drawn_changes_.everything |= map_values_.has_value();
    map_values_.emplace(mesh(), *colouring->map, 0, other);
  }
  return *map_values_;
}

MapRange Session::map_extent() {
  const MapValues& values = map_values();
  if (!map_extent_) map_extent_ = extent_of(values.all()).value_or(MapRange{});
  return *map_extent_;
}

// Records the triangles of what has another value, as long as the surface is coloured by it.
void Session::update_map_values(std::size_t transaction) {
  if (!map_values_) return;
  map_extent_.reset();
  if (!colouring) return map_values_.reset();
  const Mesh& m = mesh();
  const auto changed = map_values_->update(m, document_->journal(), transaction);
  drawn_changes_.everything |= !changed;
  if (!changed || !picker_) return;
  const auto note = [&](Face f) {
    if (!f) return;
    const std::vector<std::uint32_t> slots = picker_->triangles().slots_of(m, f);
    drawn_changes_.triangles.insert(drawn_changes_.triangles.end(), slots.begin(), slots.end());
  };
  for (const std::uint32_t i : *changed) {
    if (colouring->map->sort() == Element::Kind::face && m.is_alive(Face(i))) note(Face(i));
    if (colouring->map->sort() == Element::Kind::edge && m.is_alive(Edge(i)))
      for (unsigned side : {0u, 1u}) note(m.face(halfedge(Edge(i), side)));
    if (colouring->map->sort() == Element::Kind::vertex && m.is_alive(Vertex(i)))
      for_each_copy(m, Vertex(i), [&](Vertex copy) {
        for (Face f : faces_around(m, copy)) note(f);
      });
  }
}

// Records members of the highlights that may have moved.
void Session::note_marks(const TouchedElements& touched) {
  const Mesh& m = mesh();
  std::vector<Edge> edges;
  for (Halfedge h : touched.halfedges) edges.push_back(edge(h));
  for (Vertex v : touched.moved)
    if (m.exists(v) && m.is_alive(v))
      for (Edge e : edges_around(m, v)) edges.push_back(e);
  const auto note = [&](Mark mark, const auto& elements) {
    for (const auto element : elements)
      if (highlights_->of(mark).contains(element.index)) drawn_changes_.marks.push_back({mark, element.index});
  };
  for (const HighlightRow& row : highlight_table()) {
    if (!highlights_->keeps(row)) continue;
    for_each_mark(row, [&](Mark mark) {
      if (highlights_->of(mark).empty()) return;
      if (mark.sort == Element::Kind::vertex) note(mark, hidden_.empty() ? touched.moved : touched.vertices);
      if (mark.sort == Element::Kind::edge) note(mark, edges);
      if (mark.sort == Element::Kind::face) note(mark, touched.faces);
    });
  }
}

Outcome Session::run(const std::string& line) {
  const std::uint64_t serial = document_->serial();
  const std::size_t position = document_->position();
  try {
    return run_line(line);
  } catch (const std::bad_alloc&) {
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
  if (row->effect != Effect::none) {
    cancel_gesture();
    end_playing(*this);
    end_levels(*this);
  } else if (!row->keeps_trial) {
    end_trial();
  }
  [[maybe_unused]] const std::uint64_t serial = document_->serial();
  [[maybe_unused]] const std::size_t position = document_->position(), entries = document_->history().size();
  [[maybe_unused]] const std::size_t logged = log_.size();
  [[maybe_unused]] const bool was_on_trial = document_->is_on_trial();
  // What is needed once the command is done is made before.
  if (log_.size() + 2 > log_.capacity()) log_.reserve(2 * log_.size() + 2);
  std::string entry, usual = row->effect == Effect::none ? std::string() : std::string(without_blanks(line));
  entry.reserve(2 * line.size() + 256);
  Outcome outcome = row->run(*this, Words(words).subspan(1), std::string_view(line).substr(after_id));
  // A row that says `none` of a command that changes the mesh would leave it out of the log; what is on trial is in none.
  assert(row->effect != Effect::none || log_.size() > logged ||
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

void Session::log_line(Outcome& outcome, std::string line) {
  log_.push_back(std::move(line));
  if (!autosave) return;
  try {
    if (const auto warning = autosave->note(*this, log_.back())) outcome.say(*warning);
  } catch (const std::bad_alloc&) {
    autosave->stop();
  }
}

bool Session::look_at_disk() {
  const FileState::Change before = change_on_disk_;
  change_on_disk_ = document_->change_on_disk();
  if (change_on_disk_ == FileState::Change::gone) document_->mark_unsaved();  // no file holds this mesh any more
  return change_on_disk_ != before;
}

Input& Session::input() {
  if (const std::shared_ptr<Input> frontend = frontend_input.lock()) return *frontend;
  if (!view_input_) view_input_ = std::make_unique<ViewInput>(*this);
  return *view_input_;
}

Picker& Session::picker() {
  if (!picker_) picker_.emplace(mesh(), &hidden_);
  picker_->set_clip(clip_plane());
  return *picker_;
}

void Session::prepare() {
  constexpr std::uint32_t least_faces = 200000;  // less is not felt
  trials_.follow(*document_);
  if (beside_) beside_->prepare();
  ask_slice_of_verdicts();
  if (preparation_ && preparation_->is_done()) finish_preparation();
  if (preparation_ || highlights_ || mesh().live().faces < least_faces) return;
  if (unprepared_revision_ == document_->revision()) return;
  Preparation::Beside beside{
      vertices_on_lines(document_->file(), mesh().file_vertices()), totals_of(document_->file()).lines, {}};
  for (const HighlightRow& row : highlight_table())
    if (row.has_predicate() && shown.contains(std::string(row.id))) beside.shown.push_back(&row);
  preparation_ = std::make_unique<Preparation>(mesh(), picker(), std::move(beside));
}

void Session::ask_slice_of_verdicts() {
  if (!asks_in_slices || !tool_verdicts()) return;
  constexpr std::chrono::milliseconds slice{4};
  const auto end = std::chrono::steady_clock::now() + slice;
  tool_verdicts_->ask(mesh(), [&] { return std::chrono::steady_clock::now() < end; });
}

void Session::finish_preparation() {
  if (!preparation_) return;
  const std::unique_ptr<Preparation> done = std::exchange(preparation_, nullptr);
  Findings found;
  try {
    found = done->take();
  } catch (const std::bad_alloc&) {  // what is asked for is found when it is asked for
    unprepared_revision_ = document_->revision();
    return;
  }
  highlights_ = std::move(found.highlights);
  boundary_loops_ = std::move(found.boundary_loops);
  euler_ = std::move(found.euler);
  kind_ = std::move(found.kind);
  kind_revision_ = document_->revision();
  drawn_changes_.searched = true;
}

const RepairReport* Session::last_repair() const {
  const bool is_of_now =
      last_repair_ && last_repair_->serial == document_->serial() && last_repair_->revision == document_->revision();
  return is_of_now ? &last_repair_->report : nullptr;
}

void Session::keep_report(RepairReport report) {
  last_repair_ = {document_->serial(), document_->revision(), std::move(report)};
}

const EdgeAccount* Session::account() const {
  const bool is_of_now =
      account_ && account_->serial == document_->serial() && account_->revision == document_->revision();
  return is_of_now ? account_.get() : nullptr;
}

void Session::keep_account(EdgeAccount account) { account_ = std::make_shared<const EdgeAccount>(std::move(account)); }

const CornerNormals& Session::corner_normals() {
  if (!corner_normals_ || corner_normals_->crease_deg() != crease_deg)
    corner_normals_.emplace(mesh(), picker().triangles(), crease_deg,
                            FileNormals::are_in(mesh()) ? &file_normals_ : nullptr);
  return *corner_normals_;
}

void Session::forget_hidden() {
  for (const HighlightRow& row : highlight_table())
    if (row.has_predicate() && !shown.contains(std::string(row.id))) highlights_->forget(row);
}

const HighlightSets& Session::highlights() {
  finish_preparation();
  if (!highlights_) highlights_.emplace(mesh(), 0, vertices_on_lines(document_->file(), mesh().file_vertices()));
  forget_hidden();
  for (const HighlightRow& row : highlight_table()) {
    if (highlights_->keeps(row) || !shown.contains(std::string(row.id))) continue;
    highlights_->keep(mesh(), row);
    drawn_changes_.searched = true;
  }
  return *highlights_;
}

void Session::put_findings(ProblemKind kind, std::span<const std::uint32_t> found, std::vector<FacePair> pairs) {
  forget_findings(kind);
  highlights_->put_findings(kind, found);
  searched_ = {kind, document_->serial(), document_->revision(), std::move(pairs)};
}

void Session::forget_findings(ProblemKind kind) {
  highlights();  // are there
  highlights_->put_findings(kind, {});
  drawn_changes_.searched = true;
  searched_.reset();
}

bool Session::has_searched(ProblemKind kind) const {
  return searched_ && searched_->kind == kind && searched_->document == document_->serial() &&
         searched_->revision == document_->revision();
}

const BoundaryLoopCount& Session::boundary_loops() {
  const IndexSet& boundary = highlights().of(ProblemKind::boundary_loop);
  if (!boundary_loops_) {
    Neighbourhood around(mesh(), Neighbourhood::Reach::whole);
    boundary_loops_.emplace().search(around, boundary);
  }
  return *boundary_loops_;
}

const EulerPoincare& Session::euler_terms() {
  boundary_loops();
  if (!euler_) euler_ = euler_poincare(mesh(), highlights_->problems());
  return *euler_;
}

const KindOfMesh& Session::kind(bool anew) {
  constexpr std::uint32_t most_faces = 20000;  // more would be felt after each edit
  const bool is_quick = mesh().live().faces <= most_faces || is_kind_evident(mesh(), highlights().problems());
  if (!kind_ || (is_kind_stale() && (anew || is_quick))) {
    kind_ = find_kind(mesh(), highlights().problems(), totals_of(document_->file()).lines);
    kind_revision_ = document_->revision();
  }
  return *kind_;
}

void Session::with_places_to_frame(const Mesh& mesh, const std::function<void(std::span<const glm::dvec3>)>& visit) {
  const auto has_edges = [&](std::uint32_t i) { return mesh.is_alive(Vertex(i)) && !mesh.is_isolated(Vertex(i)); };
  std::uint32_t same = 0;
  while (same < mesh.vertex_slots() && has_edges(same)) ++same;
  if (same == mesh.vertex_slots()) return visit(mesh.positions());
  std::vector<glm::dvec3> places, isolated;
  places.reserve(mesh.vertex_slots());
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const Vertex v(i);
    if (mesh.is_alive(v)) (mesh.is_isolated(v) ? isolated : places).push_back(mesh.position(v));
  }
  visit(places.empty() ? isolated : places);
}

Camera Session::framing(const Mesh& mesh, const Camera& from) const {
  Camera found = from;
  with_places_to_frame(
      mesh, [&](auto places) { found = fitted(from, places, static_cast<double>(view.width) / view.height); });
  return found;
}

std::string Session::document_name() const {
  const std::string name = document_->path().filename().string();
  if (!name.empty() || is_at_start()) return name;
  return language == Language::japanese ? "（無題）" : "(unnamed)";
}

void Session::frame_all() {
  if (!beside_) {
    camera = framing(mesh(), camera);
    return;
  }
  std::vector<glm::dvec3> both;
  for (const Mesh* const one : {&mesh(), &beside_->mesh()})
    with_places_to_frame(*one, [&](auto places) { both.insert(both.end(), places.begin(), places.end()); });
  camera = fitted(camera, both, static_cast<double>(view.width) / view.height);
}

Session::DrawnChanges Session::take_drawn_changes() {
  DrawnChanges changes = std::move(drawn_changes_);
  drawn_changes_ = {false, {}, {}, {}, {}, false, false};
  return changes;
}

}  // namespace ryosen
