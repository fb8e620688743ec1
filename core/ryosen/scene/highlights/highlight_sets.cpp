#include "ryosen/scene/highlights/highlight_sets.h"

#include <array>

#include "ryosen/analysis/ask_elements.h"

namespace ryosen {

namespace {

using OwnMembers = std::array<std::vector<std::uint32_t>, enum_count<Element::Kind>>;

std::uint32_t slots_of(const Mesh& mesh, Element::Kind sort) {
  return sort == Element::Kind::vertex ? mesh.vertex_slots()
         : sort == Element::Kind::edge ? mesh.edge_slots()
                                       : mesh.face_slots();
}

}  // namespace

void HighlightSets::keep(const Mesh& mesh, const HighlightRow& row, unsigned threads) {
  if (keeps(row)) return;
  if (threads == 0) threads = threads_for(mesh.halfedge_slots());
  const unsigned parts = threads == 1 ? 1 : 2 * threads;
  std::vector<OwnMembers> found(parts);
  for_each_task(parts, threads, [&](unsigned part) {
    Neighbourhood around(mesh, Neighbourhood::Reach::whole);
    const auto members = [&](Element::Kind sort) -> auto& { return found[part][static_cast<std::size_t>(sort)]; };
    search_part<Vertex>(row, around, part, parts, members(Element::Kind::vertex));
    search_part<Edge>(row, around, part, parts, members(Element::Kind::edge));
    search_part<Face>(row, around, part, parts, members(Element::Kind::face));
  });
  kept_[number_of(row)] = true;
  own_.resize(own_marks);
  for_each_own_mark(row, [&](Mark mark) {
    for (const OwnMembers& members : found)
      for (const std::uint32_t i : members[static_cast<std::size_t>(mark.sort)]) own_[mark.number].insert(i);
  });
}

void HighlightSets::forget(const HighlightRow& row) {
  if (!row.has_predicate() || !keeps(row)) return;
  kept_[number_of(row)] = false;
  for_each_own_mark(row, [&](Mark mark) { own_[mark.number].clear(); });
  if (kept_.none()) own_.clear();
}

const IndexSet& HighlightSets::of(Mark mark) const {
  if (mark.number >= own_marks) return of(static_cast<ProblemKind>(mark.number - own_marks));
  return own_[mark.number];
}

std::uint64_t HighlightSets::count(const HighlightRow& row) const {
  std::uint64_t n = 0;
  for_each_mark(row, [&](Mark mark) { n += of(mark).size(); });
  return n;
}

void HighlightSets::update(const Mesh& mesh, const Journal& journal, std::size_t i) {
  problems_.update(mesh, journal, i);
  changes_.clear();
  if (!changed_everything()) {
    for (const ProblemSets::Change& change : problems_.changes())
      changes_.push_back({mark_of(change.kind), change.index});
    if (kept_.any()) update_kept(mesh, journal, i);
    return;
  }
  for (const HighlightRow& row : highlight_table()) {
    if (!row.has_predicate() || !keeps(row)) continue;
    forget(row);
    keep(mesh, row);
  }
}

void HighlightSets::update_kept(const Mesh& mesh, const Journal& journal, std::size_t i) {
  Neighbourhood around(mesh);
  bool reads_whole_faces = false, reads_values = false;
  for (const HighlightRow& row : highlight_table()) {
    if (!kept_[number_of(row)]) continue;
    reads_whole_faces |= row.reads_whole_faces;
    reads_values |= row.reads_values;
  }
  // To ask too many costs time alone, so the widest reach serves all.
  EditReach reach =
      reads_values ? edit_reach(journal, i, around, WrittenValues::counted) : EditReach(problems_.reach());
  if (reads_whole_faces) add_whole_faces(around, reach);
  const auto put = [&](Mark mark, std::uint32_t index, bool is_in) {
    IndexSet& members = own_[mark.number];
    if (is_in ? members.insert(index) : members.erase(index)) changes_.push_back({mark, index});
  };
  const auto ask = [&](const HighlightRow& row, Element::Kind sort, const auto& elements) {
    for (const auto element : elements)
      if (speaks_of(row, element)) put(own_mark(row, sort), element.index, is_member(row, around, element));
  };
  for (const HighlightRow& row : highlight_table()) {
    if (!kept_[number_of(row)]) continue;
    ask(row, Element::Kind::vertex, reach.vertices);
    ask(row, Element::Kind::edge, reach.edges);
    ask(row, Element::Kind::face, reach.faces);
    // Slots that undoing took away.
    for_each_own_mark(row, [&](Mark mark) {
      for (std::uint32_t k : own_[mark.number].members_from(slots_of(mesh, mark.sort))) put(mark, k, false);
    });
  }
}

}  // namespace ryosen
