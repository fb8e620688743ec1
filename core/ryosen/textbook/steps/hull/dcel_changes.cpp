#include "ryosen/textbook/steps/hull/dcel_changes.h"

#include <array>

namespace ryosen {

using forms::DcelRecords;

std::string_view id_of(DcelChange::Table table) {
  constexpr std::array<std::string_view, 3> ids{"vertex", "half_edge", "face"};
  return ids[static_cast<std::size_t>(table)];
}

std::string_view id_of(DcelChange::Field field) {
  constexpr std::array<std::string_view, 7> ids{"incident_edge", "origin", "twin",           "next",
                                                "prev",          "face",   "outer_component"};
  return ids[static_cast<std::size_t>(field)];
}

std::uint32_t& cell(DcelRecords& records, const DcelChange& change) {
  const auto row_of = [&](auto& table) -> auto& {
    if (change.row >= table.size()) table.resize(change.row + std::size_t{1});
    return table[change.row];
  };
  if (change.table == DcelChange::Table::vertex) return records.vertices[change.row].incident_edge;
  if (change.table == DcelChange::Table::face) return row_of(records.faces).outer_component;
  DcelRecords::HalfEdgeRecord& h = row_of(records.half_edges);
  switch (change.field) {
    case DcelChange::Field::origin:
      return h.origin;
    case DcelChange::Field::twin:
      return h.twin;
    case DcelChange::Field::next:
      return h.next;
    case DcelChange::Field::prev:
      return h.prev;
    default:
      return h.face;
  }
}

void apply_changes(std::span<const DcelChange> changes, DcelRecords& records) {
  for (const DcelChange& change : changes) cell(records, change) = change.new_value;
}

void take_back_changes(std::span<const DcelChange> changes, std::size_t half_edge_rows, std::size_t face_rows,
                       DcelRecords& records) {
  for (auto change = changes.rbegin(); change != changes.rend(); ++change) cell(records, *change) = change->old_value;
  records.half_edges.resize(half_edge_rows);
  records.faces.resize(face_rows);
}

DcelRecords in_use(const DcelRecords& records) {
  using Index = std::uint32_t;
  std::vector<Index> half_edge(records.half_edges.size(), no_index), face(records.faces.size(), no_index);
  DcelRecords kept;
  kept.vertices = records.vertices;
  for (Index h = 0; h < half_edge.size(); ++h) {
    if (records.half_edges[h].origin == no_index) continue;
    half_edge[h] = static_cast<Index>(kept.half_edges.size());
    kept.half_edges.push_back(records.half_edges[h]);
  }
  for (Index f = 0; f < face.size(); ++f) {
    if (records.faces[f].outer_component == no_index) continue;
    face[f] = static_cast<Index>(kept.faces.size());
    kept.faces.push_back(records.faces[f]);
  }
  const auto renumber = [](Index& link, const std::vector<Index>& number) {
    if (link != no_index) link = number[link];
  };
  for (auto& v : kept.vertices) renumber(v.incident_edge, half_edge);
  for (auto& h : kept.half_edges) {
    for (Index* const link : {&h.twin, &h.next, &h.prev}) renumber(*link, half_edge);
    renumber(h.face, face);
  }
  for (auto& f : kept.faces) renumber(f.outer_component, half_edge);
  return kept;
}

}  // namespace ryosen
