// What is found in the mesh of a session and kept through its edits: the sets of highlights, values, counts and kind.
#include <cassert>
#include <chrono>
#include <new>
#include <utility>

#include "app/editor/session/session.h"
#include "app/editor/shown/levels.h"
#include "ryosen/io/elements.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

const MapValues& Session::map_values() {
  assert(view.colouring);
  const std::shared_ptr<const OtherSurface> other = view.colouring->map->against ? other_surface() : nullptr;
  if (!map_values_ || &map_values_->map() != view.colouring->map || map_values_->other() != other.get()) {
    map_extent_.reset();
    if (map_values_) changes_.note_everything();
    map_values_.emplace(mesh(), *view.colouring->map, 0, other);
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
  if (!view.colouring) return map_values_.reset();
  const Mesh& m = mesh();
  const auto changed = map_values_->update(m, document_->journal(), transaction);
  if (!changed) changes_.note_everything();
  if (!changed || !picker_) return;
  const auto note = [&](Face f) {
    if (!f) return;
    picker_->note_changed(picker_->triangles().slots_of(m, f));
  };
  for (const std::uint32_t i : *changed) {
    if (view.colouring->map->sort() == Element::Kind::face && m.is_alive(Face(i))) note(Face(i));
    if (view.colouring->map->sort() == Element::Kind::edge && m.is_alive(Edge(i)))
      for (unsigned side : {0u, 1u}) note(m.face(halfedge(Edge(i), side)));
    if (view.colouring->map->sort() == Element::Kind::vertex && m.is_alive(Vertex(i)))
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

const CornerNormals& Session::corner_normals() {
  if (!corner_normals_ || corner_normals_->crease_deg() != preferences.crease_deg)
    corner_normals_.emplace(mesh(), picker().triangles(), preferences.crease_deg,
                            FileNormals::are_in(mesh()) ? &file_normals_ : nullptr);
  return *corner_normals_;
}

void Session::forget_hidden() {
  for (const HighlightRow& row : highlight_table())
    if (row.has_predicate() && !view.highlights.contains(std::string(row.id))) highlights_->forget(row);
}

const HighlightSets& Session::highlights() {
  finish_preparation();
  if (!highlights_) {
    highlights_.emplace(mesh(), 0, vertices_on_lines(document_->file(), mesh().file_vertices()));
    judge_as_drawn();
  }
  forget_hidden();
  for (const HighlightRow& row : highlight_table()) {
    if (highlights_->keeps(row) || !view.highlights.contains(std::string(row.id))) continue;
    highlights_->keep(mesh(), row);
    changes_.note_search();
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
  changes_.note_search();
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
    if (row.has_predicate() && view.highlights.contains(std::string(row.id))) beside.shown.push_back(&row);
  preparation_ = std::make_unique<Preparation>(mesh(), picker(), std::move(beside));
}

void Session::ask_slice_of_verdicts() {
  if (!frontend.asks_in_slices || !tool_verdicts()) return;
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
  judge_as_drawn();
  boundary_loops_ = std::move(found.boundary_loops);
  euler_ = std::move(found.euler);
  kind_ = std::move(found.kind);
  kind_revision_ = document_->revision();
  changes_.note_search();
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

}  // namespace ryosen
