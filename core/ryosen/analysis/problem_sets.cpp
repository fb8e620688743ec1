#include "ryosen/analysis/problem_sets.h"

#include <algorithm>
#include <optional>

#include "ryosen/analysis/ask_elements.h"
#include "ryosen/base/interruption.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

using Members = std::array<std::vector<std::uint32_t>, most_problem_kinds>;

// Asks one of `parts` parts of the elements of a sort: a few at a time by all rows, while their surroundings are in the
// cache.
template <class Element>
void search_part(Neighbourhood& around, unsigned part, unsigned parts, Members& members) {
  constexpr std::uint32_t at_once = 1024;
  const std::uint32_t slots = slots_of(around.mesh(), Element()), end = part_begin(slots, part + 1, parts);
  for (std::uint32_t first = part_begin(slots, part, parts); first < end; first += at_once)
    for (const ProblemRow& row : problem_table())
      if (!row.find_all)
        search_range<Element>(row, around, first, std::min(first + at_once, end),
                              members[static_cast<std::size_t>(row.kind)]);
}

bool is_further(Neighbourhood& around, Vertex v) {
  const Mesh& mesh = around.mesh();
  return mesh.exists(v) && mesh.is_alive(v) && around.point(v) != v;
}

// Sheets with a face come first, then the lower ones.
bool is_further(Neighbourhood& around, Edge e) {
  const Mesh& mesh = around.mesh();
  if (!mesh.exists(e) || !mesh.is_alive(e) || around.is_single_sheet(halfedge(e))) return false;
  return mesh.is_wire(e) ? !around.is_first_wire(e) : !around.is_first_sheet(e);
}

void put(IndexSet& set, std::uint32_t index, bool is_member) {
  if (is_member)
    set.insert(index);
  else
    set.erase(index);
}

}  // namespace

ProblemSets::ProblemSets(const Mesh& mesh, unsigned threads, std::span<const Vertex> on_lines) {
  for (const Vertex v : on_lines) on_lines_.insert(v.index);
  search(mesh, threads);
}

void ProblemSets::search(const Mesh& mesh, unsigned threads) {
  had_copies_ = mesh.has_copies();
  if (threads == 0) threads = threads_for(mesh.halfedge_slots());
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  const unsigned parts = threads == 1 ? 1 : 2 * threads;
  std::vector<Members> found(parts + 1);
  for_each_task(parts + 1, threads, [&](unsigned task) {
    std::optional<Neighbourhood> own;  // what is gathered must not be shared
    if (threads > 1) own.emplace(mesh, Neighbourhood::Reach::whole);
    Neighbourhood& asked = own ? *own : around;
    Members& members = found[task];
    if (task == 0) {
      for (const ProblemRow& row : problem_table())
        if (row.find_all) members[static_cast<std::size_t>(row.kind)] = row.find_all(asked);
      return;
    }
    search_part<Vertex>(asked, task - 1, parts, members);
    search_part<Edge>(asked, task - 1, parts, members);
    search_part<Face>(asked, task - 1, parts, members);
  });
  for (const Members& members : found)
    for (const ProblemRow& row : problem_table())
      for (const std::uint32_t i : members[static_cast<std::size_t>(row.kind)]) set_for(row, i).insert(i);
  find_further(around);
}

// The table of places is made when it is needed first: most sets are never updated.
void ProblemSets::update_coincident(const Mesh& mesh) {
  const ProblemRow& row = row_of(ProblemKind::coincident_points);
  const auto ask = [&](Vertex v) { set(row, v.index, coincident_.is_on_another(v)); };
  if (coincident_.knows_places()) {
    for (const Vertex v : coincident_.update(mesh, reach_.vertices)) ask(v);
    return;
  }
  coincident_ = CoincidentPoints(mesh);
  for (const std::uint32_t i : of(row.kind).to_vector()) ask(Vertex(i));
  for (Vertex v(0); v.index < mesh.vertex_slots(); ++v.index) ask(v);
}

void ProblemSets::find_further(Neighbourhood& around) {
  const Mesh& mesh = around.mesh();
  if (!mesh.has_copies()) return;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    stop_if_interrupted();
    if (is_further(around, Vertex(i))) further_copies_.insert(i);
  }
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    stop_if_interrupted();
    if (is_further(around, Edge(i))) further_sheets_.insert(i);
  }
}

bool ProblemSets::put_member(const ProblemRow& row, std::uint32_t index, bool is_member) {
  IndexSet& members = set_for(row, index);
  return (is_member ? members.insert(index) : members.erase(index)) && &members != &only_on_lines_;
}

void ProblemSets::set(const ProblemRow& row, std::uint32_t index, bool is_member) {
  if (put_member(row, index, is_member)) changes_.push_back({row.kind, index, is_member});
}

void ProblemSets::put_findings(ProblemKind kind, std::span<const std::uint32_t> found) {
  IndexSet& members = sets_[static_cast<std::size_t>(kind)];
  members.clear();
  for (const std::uint32_t i : found) members.insert(i);
}

void ProblemSets::update(const Mesh& mesh, const Journal& journal, std::size_t i) {
  // The journal does not list the cells of a column of copies that came or went as a whole.
  if (journal.replaces_everything(i) || had_copies_ != mesh.has_copies()) {
    IndexSet on_lines = std::move(on_lines_);
    *this = ProblemSets();
    on_lines_ = std::move(on_lines);
    return search(mesh, 0);
  }
  changes_.clear();
  changed_everything_ = false;
  Neighbourhood around(mesh);
  reach_ = edit_reach(journal, i, around);
  const auto ask = [&](const ProblemRow& row, const auto& elements) {
    for (const auto element : elements)
      if (speaks_of(row, element)) set(row, element.index, is_member(row, around, element));
  };
  for (const ProblemRow& row : problem_table()) {
    ask(row, reach_.vertices);
    ask(row, reach_.edges);
    ask(row, reach_.faces);
    if (row.is_on_request())
      for (const std::uint32_t k : of(row.kind).to_vector()) set(row, k, false);
    // Slots that undoing took away.
    if (!row.is_local() || row.is_found_whole()) continue;
    const std::uint32_t slots = row.vertex ? mesh.vertex_slots() : row.edge ? mesh.edge_slots() : mesh.face_slots();
    for (std::uint32_t k : of(row.kind).members_from(slots)) set(row, k, false);
  }
  update_coincident(mesh);
  if (had_copies_) {
    for (Vertex v : reach_.vertices) put(further_copies_, v.index, is_further(around, v));
    for (Edge e : reach_.edges) put(further_sheets_, e.index, is_further(around, e));
    for (std::uint32_t k : further_copies_.members_from(mesh.vertex_slots())) further_copies_.erase(k);
    for (std::uint32_t k : further_sheets_.members_from(mesh.edge_slots())) further_sheets_.erase(k);
  }
  list_edges_asked(around);
}

void ProblemSets::list_edges_asked(Neighbourhood& around) {
  const Mesh& mesh = around.mesh();
  edges_asked_ = reach_.edges;
  for (const Change& change : changes_)
    if (row_of(change.kind).edge) edges_asked_.emplace_back(change.index);
  // Which sheets are one edge changes with the copies at either end.
  for (Vertex v : reach_.vertices) {
    if (!mesh.exists(v) || !mesh.is_alive(v) || !has_copies(mesh, v)) continue;
    if (around.point(v) != v) continue;  // all copies are listed with the first one, which is in the reach as well
    for_each_copy(mesh, v, [&](Vertex copy) {
      for (Edge e : edges_around(mesh, copy)) edges_asked_.push_back(e);
    });
  }
  sort_unique(edges_asked_);
}

}  // namespace ryosen
