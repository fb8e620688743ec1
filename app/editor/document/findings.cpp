#include "app/editor/document/findings.h"

#include <algorithm>
#include <new>
#include <utility>

#include "ryosen/io/edited_file.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"

namespace ryosen {

Findings::Findings(const Document& document, const ViewState& view, const Preferences& preferences)
    : document_(document), views_{&view}, preferences_(preferences) {
  changes_.begin(document.serial());
}

void Findings::take_views_of(const Findings& other) {
  views_.insert(views_.end(), other.views_.begin() + 1, other.views_.end());
}

void Findings::remove_view(const ViewState& view) { std::erase(views_, &view); }

template <class Wants>
bool Findings::any_view(Wants wants) const {
  return std::any_of(views_.begin(), views_.end(), [&](const ViewState* view) { return wants(*view); });
}

bool Findings::is_shown(const HighlightRow& row) const {
  return any_view([id = std::string(row.id)](const ViewState& view) { return view.highlights.contains(id); });
}

bool Findings::needs_corner_normals() const {
  return any_view([](const ViewState& view) {
    return view.settings.shading == Shading::smooth || view.settings.normals == Normals::vertices;
  });
}

void Findings::forget() {
  preparation_.reset();  // it builds the tree of the picker
  maps_.clear();
  hidden_ = HiddenElements();
  picker_.reset();
  corner_normals_.reset();
  file_normals_.end();
  highlights_.reset();
  boundary_loops_.reset();
  euler_.reset();
  kind_.reset();
  changes_.note_everything();
}

void Findings::follow(const Journal& journal, std::size_t transaction, Document::Change change,
                      const TouchedElements& touched) {
  const bool is_trial = change == Document::Change::tried || change == Document::Change::trial_ended;
  hidden_.follow(mesh(), touched);
  const bool has_normals =
      !is_trial && change != Document::Change::undone && document_.history()[transaction].has_normals;
  if (has_normals)
    file_normals_ = FileNormals();
  else if (!is_trial)
    file_normals_.follow(mesh(), touched);
  if (touched.everything) changes_.note_everything();
  for (Vertex v : touched.moved) changes_.note_vertex(v.index);
  for (Face f : touched.faces) changes_.note_face(f.index);
  for (const TouchedElements::Value& value : touched.values) changes_.note_value(value);
  if (touched.all_values) changes_.note_all_values();
  if (picker_) follow_picker(touched);
  follow_map_values(transaction, is_trial);
  if (highlights_) follow_highlights(journal, transaction, touched);
  follow_counts(transaction, is_trial, touched);
}

void Findings::follow_picker(const TouchedElements& touched) {
  const std::vector<std::uint32_t> slots = picker_->update(mesh(), touched);
  if (corner_normals_ && (touched.everything || !needs_corner_normals())) {
    corner_normals_.reset();
    changes_.note_everything();  // what was drawn with them knows nothing of this edit
  }
  if (corner_normals_) picker_->note_changed(corner_normals_->update(mesh(), picker_->triangles(), touched));
  picker_->note_changed(slots);
}

void Findings::follow_highlights(const Journal& journal, std::size_t transaction, const TouchedElements& touched) {
  forget_unshown();
  highlights_->update(mesh(), journal, transaction);
  if (highlights_->changed_everything()) changes_.note_everything();
  for (const ChangeFeed::Marked& marked : highlights_->changes()) changes_.note_mark(marked);
  note_marks(touched);
  // A mark at a point is hidden with all its copies, wherever they are.
  if (!hidden_.empty() && mesh().has_copies()) changes_.note_search();
}

void Findings::follow_counts(std::size_t transaction, bool is_trial, const TouchedElements& touched) {
  if (boundary_loops_) {
    const IndexSet& boundary = highlights_->of(ProblemKind::boundary_loop);
    Neighbourhood around(mesh());
    if (highlights_->changed_everything())
      boundary_loops_->search(around, boundary);
    else
      boundary_loops_->update(around, boundary, highlights_->problems().edges_asked());
  }
  if (!euler_) return;
  const std::string_view line =
      is_trial ? std::string_view() : std::string_view(document_.history()[transaction].command);
  const OpInfo* op = find_op(line.substr(0, line.find(' ')));
  const bool is_kept = op && op->topology == Topology::kept && !touched.everything &&
                       follow_operator(*euler_, mesh(), highlights_->problems(), *boundary_loops_);
  if (!is_kept) euler_.reset();
}

Picker& Findings::picker() {
  if (!picker_) picker_.emplace(mesh(), &hidden_);
  picker_->set_clip({});
  return *picker_;
}

Picker& Findings::picker(const ViewState& view) {
  picker().set_clip(view.clip_plane());
  return *picker_;
}

bool Findings::is_coloured_by(const ColourMap& map) const {
  return any_view([&](const ViewState& view) { return view.colouring && view.colouring->map == &map; });
}

Findings::KeptMap& Findings::kept_map(const ColourMap& map) {
  const std::shared_ptr<const OtherSurface> other = map.against ? other_surface() : nullptr;
  const auto kept =
      std::find_if(maps_.begin(), maps_.end(), [&](const KeptMap& each) { return &each.values.map() == &map; });
  if (kept != maps_.end() && kept->values.other() == other.get()) return *kept;
  if (kept != maps_.end()) {
    changes_.note_everything();
    maps_.erase(kept);
  }
  std::erase_if(maps_, [&](const KeptMap& each) { return !is_coloured_by(each.values.map()); });
  return maps_.emplace_back(KeptMap{MapValues(mesh(), map, 0, other), {}});
}

const MapValues& Findings::map_values(const Colouring& colouring) { return kept_map(*colouring.map).values; }

MapRange Findings::map_extent(const Colouring& colouring) {
  KeptMap& kept = kept_map(*colouring.map);
  if (!kept.extent) kept.extent = extent_of(kept.values.all()).value_or(MapRange{});
  return *kept.extent;
}

// Records the triangles of what has another value, as long as the surface is coloured by it.
void Findings::follow_map_values(std::size_t transaction, bool is_trial) {
  if (maps_.empty()) return;
  if (is_trial) {  // no transaction of the history
    maps_.clear();
    return changes_.note_everything();
  }
  std::erase_if(maps_, [&](const KeptMap& kept) { return !is_coloured_by(kept.values.map()); });
  for (KeptMap& kept : maps_) {
    kept.extent.reset();
    const auto changed = kept.values.update(mesh(), document_.journal(), transaction);
    if (!changed) changes_.note_everything();
    if (changed) note_coloured(kept.values.map().sort(), *changed);
  }
}

void Findings::note_coloured(Element::Kind sort, std::span<const std::uint32_t> changed) {
  const Mesh& m = mesh();
  const auto note = [&](Face f) {
    if (!f) return;
    changes_.note_face(f.index);
    if (picker_) picker_->note_changed(picker_->triangles().slots_of(m, f));
  };
  for (const std::uint32_t i : changed) {
    if (sort == Element::Kind::face && m.is_alive(Face(i))) note(Face(i));
    if (sort == Element::Kind::edge && m.is_alive(Edge(i)))
      for (unsigned side : {0u, 1u}) note(m.face(halfedge(Edge(i), side)));
    if (sort == Element::Kind::vertex && m.is_alive(Vertex(i))) for_each_face_at(m, Vertex(i), note);
  }
}

// Records members of the highlights that may have moved.
void Findings::note_marks(const TouchedElements& touched) {
  const Mesh& m = mesh();
  std::vector<Edge> edges;
  for (Halfedge h : touched.halfedges) edges.push_back(edge(h));
  for (Vertex v : touched.moved)
    if (m.exists(v) && m.is_alive(v))
      for (Edge e : edges_around(m, v)) edges.push_back(e);
  const auto note = [&](Mark mark, const auto& elements) {
    for (const auto element : elements)
      if (highlights_->of(mark).contains(element.index)) changes_.note_mark({mark, element.index});
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

const CornerNormals& Findings::corner_normals() {
  if (!corner_normals_ || corner_normals_->crease_deg() != preferences_.crease_deg)
    corner_normals_.emplace(mesh(), picker().triangles(), preferences_.crease_deg,
                            FileNormals::are_in(mesh()) ? &file_normals_ : nullptr);
  return *corner_normals_;
}

void Findings::forget_unshown() {
  for (const HighlightRow& row : highlight_table())
    if (row.has_predicate() && !is_shown(row)) highlights_->forget(row);
}

const HighlightSets& Findings::highlights() {
  finish_preparation();
  if (!highlights_) {
    highlights_.emplace(mesh(), 0, vertices_on_lines(document_.file(), mesh().file_vertices()));
    if (after_search) after_search();
  }
  forget_unshown();
  for (const HighlightRow& row : highlight_table()) {
    if (highlights_->keeps(row) || !is_shown(row)) continue;
    highlights_->keep(mesh(), row);
    changes_.note_search();
  }
  return *highlights_;
}

void Findings::put(ProblemKind kind, std::span<const std::uint32_t> found, std::vector<FacePair> pairs) {
  forget(kind);
  highlights_->put_findings(kind, found);
  searched_ = {kind, document_.serial(), document_.revision(), std::move(pairs)};
}

void Findings::forget(ProblemKind kind) {
  highlights();  // are there
  highlights_->put_findings(kind, {});
  changes_.note_search();
  searched_.reset();
}

bool Findings::has_searched(ProblemKind kind) const {
  return searched_ && searched_->kind == kind && searched_->document == document_.serial() &&
         searched_->revision == document_.revision();
}

const BoundaryLoopCount& Findings::boundary_loops() {
  const IndexSet& boundary = highlights().of(ProblemKind::boundary_loop);
  if (!boundary_loops_) {
    Neighbourhood around(mesh(), Neighbourhood::Reach::whole);
    boundary_loops_.emplace().search(around, boundary);
  }
  return *boundary_loops_;
}

const EulerPoincare& Findings::euler_terms() {
  boundary_loops();
  if (!euler_) euler_ = euler_poincare(mesh(), highlights_->problems());
  return *euler_;
}

const KindOfMesh& Findings::kind(bool anew) {
  constexpr std::uint32_t most_faces = 20000;  // more would be felt after each edit
  const bool is_quick = mesh().live().faces <= most_faces || is_kind_evident(mesh(), highlights().problems());
  if (!kind_ || (is_kind_stale() && (anew || is_quick))) {
    kind_ = find_kind(mesh(), highlights().problems(), totals_of(document_.file()).lines);
    kind_revision_ = document_.revision();
  }
  return *kind_;
}

std::shared_ptr<const OtherSurface> Findings::surface() {
  if (!surface_ || surface_revision_ != document_.revision()) {
    surface_ = std::make_shared<const OtherSurface>(mesh());
    surface_revision_ = document_.revision();
  }
  return surface_;
}

void Findings::prepare() {
  constexpr std::uint32_t least_faces = 200000;  // less is not felt
  if (preparation_ && preparation_->is_done()) finish_preparation();
  if (preparation_ || highlights_ || mesh().live().faces < least_faces) return;
  if (unprepared_revision_ == document_.revision()) return;
  Preparation::Beside beside{
      vertices_on_lines(document_.file(), mesh().file_vertices()), totals_of(document_.file()).lines, {}};
  for (const HighlightRow& row : highlight_table())
    if (row.has_predicate() && is_shown(row)) beside.shown.push_back(&row);
  preparation_ = std::make_unique<Preparation>(mesh(), picker(), std::move(beside));
}

void Findings::finish_preparation() {
  if (!preparation_) return;
  const std::unique_ptr<Preparation> done = std::exchange(preparation_, nullptr);
  Preparation::Found found;
  try {
    found = done->take();
  } catch (const std::bad_alloc&) {  // what is asked for is found when it is asked for
    unprepared_revision_ = document_.revision();
    return;
  }
  highlights_ = std::move(found.highlights);
  if (after_search) after_search();
  boundary_loops_ = std::move(found.boundary_loops);
  euler_ = found.euler;
  kind_ = std::move(found.kind);
  kind_revision_ = document_.revision();
  changes_.note_search();
}

const RepairReport* Findings::last_repair() const {
  const bool is_of_now =
      last_repair_ && last_repair_->serial == document_.serial() && last_repair_->revision == document_.revision();
  return is_of_now ? &last_repair_->report : nullptr;
}

void Findings::keep_report(RepairReport report) {
  last_repair_ = {document_.serial(), document_.revision(), std::move(report)};
}

const LeftEdges* Findings::left_edges() const {
  const bool is_of_now =
      left_edges_ && left_edges_->serial == document_.serial() && left_edges_->revision == document_.revision();
  return is_of_now ? left_edges_.get() : nullptr;
}

void Findings::keep_left_edges(LeftEdges edges) { left_edges_ = std::make_shared<const LeftEdges>(std::move(edges)); }

}  // namespace ryosen
