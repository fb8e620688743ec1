#include "ryosen/textbook/steps/hull_kernel.h"

#include <algorithm>
#include <array>

#include "ryosen/base/sort_unique.h"
#include "ryosen/indexed/from_indexed.h"

namespace ryosen::steps {

using forms::DcelRecords;
using Row = std::uint32_t;

HullKernel::HullKernel(const DcelRecords& records, bool is_planar) : is_planar_(is_planar) {
  IndexedMesh list;
  std::vector<Row> rows;  // of the half-edges of all corners
  for (const DcelRecords::VertexRecord& v : records.vertices) list.positions.push_back(v.coordinates);
  for (const DcelRecords::FaceRecord& f : records.faces) {
    if (f.outer_component == no_index) continue;
    Row h = f.outer_component;
    do {
      rows.push_back(h);
      list.corners.push_back(records.half_edges[h].origin);
    } while ((h = records.half_edges[h].next) != f.outer_component);
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  mesh_ = from_indexed(std::move(list));
  half_.resize(records.half_edges.size());
  face_.resize(records.faces.size());
  std::size_t corner = 0;
  for (std::uint32_t f = 0; f < mesh_.face_slots(); ++f) {
    const Row first = rows[corner];
    face_[records.half_edges[first].face] = Face(f);
    Halfedge h = mesh_.halfedge(Face(f));
    while (mesh_.from(h).index != records.half_edges[first].origin) h = mesh_.next(h);
    const Halfedge start = h;
    do {
      const Row row = rows[corner++];
      half_[row] = h;
      if (is_planar) half_[records.half_edges[row].twin] = twin(h);
    } while ((h = mesh_.next(h)) != start);
  }
}

void HullKernel::follow(const HullStep& step, const DcelRecords& records) {
  if (step.made.empty()) return;
  half_.resize(records.half_edges.size());
  face_.resize(records.faces.size());
  Edit edit(mesh_, &journal_);
  if (is_planar_)
    follow_in_plane(edit, step, records);
  else
    follow_in_space(edit, step, records);
  edit.commit();
}

void HullKernel::follow_in_space(Edit& edit, const HullStep& step, const DcelRecords& records) {
  remove_seen(edit, step);
  for (const Row f : step.made) add_face(edit, records, f);
}

void HullKernel::remove_seen(Edit& edit, const HullStep& step) {
  std::vector<Edge> around;
  for (const Row h : step.horizon) around.push_back(edge(half_[h]));
  std::sort(around.begin(), around.end());
  std::vector<Edge> within;
  std::vector<Vertex> corners;
  for (const Row f : step.seen) {
    Halfedge h = mesh_.halfedge(face_[f]);
    for (int k = 0; k < 3; ++k, h = mesh_.next(h)) {
      corners.push_back(mesh_.from(h));
      if (!std::binary_search(around.begin(), around.end(), edge(h))) within.push_back(edge(h));
    }
  }
  sort_unique(within);
  for (const Vertex v : corners) edit.set_halfedge(v, Halfedge());
  for (const Row h : step.horizon) edit.set_halfedge(mesh_.from(half_[h]), half_[h]);
  for (const Row f : step.seen) edit.remove(face_[f]);
  for (const Edge e : within) edit.remove(e);
}

// Its half-edges: one beside an edge that stays, or whose twin has been entered, gets that edge; else a new one.
void HullKernel::add_face(Edit& edit, const DcelRecords& records, Row f) {
  const Face face = edit.add_face(Halfedge());
  face_[f] = face;
  std::array<Row, 3> rows{};
  rows[0] = records.faces[f].outer_component;
  rows[1] = records.half_edges[rows[0]].next;
  rows[2] = records.half_edges[rows[1]].next;
  for (const Row row : rows) {
    const DcelRecords::HalfEdgeRecord& h = records.half_edges[row];
    const Vertex from(h.origin), to(records.half_edges[h.next].origin);
    const Halfedge beside = half_[h.twin];
    const bool is_there = beside && beside.index < mesh_.halfedge_slots() && mesh_.is_alive(beside) &&
                          mesh_.from(beside) == to && mesh_.from(twin(beside)) == from;
    half_[row] = is_there ? twin(beside) : edit.add_edge(from, to);
    edit.set_face(half_[row], face);
    edit.set_halfedge(from, half_[row]);
  }
  for (std::size_t k = 0; k < 3; ++k) edit.connect(half_[rows[k]], half_[rows[(k + 1) % 3]]);
  edit.set_halfedge(face, half_[rows[0]]);
}

// The edges of a polygon, whose corners hold their halfedges outside of it.
void HullKernel::follow_in_plane(Edit& edit, const HullStep& step, const DcelRecords& records) {
  const Row face_row = records.half_edges[step.made[0]].face;
  if (step.kind == HullStep::Kind::begin) face_[face_row] = edit.add_face(Halfedge());
  for (const Row h : step.seen) {
    edit.set_halfedge(mesh_.to(half_[h]), Halfedge());
    edit.remove(edge(half_[h]));
  }
  for (const Row row : step.made) {
    const DcelRecords::HalfEdgeRecord& h = records.half_edges[row];
    half_[row] = edit.add_edge(Vertex(h.origin), Vertex(records.half_edges[h.twin].origin));
    half_[h.twin] = twin(half_[row]);
    edit.set_face(half_[row], face_[face_row]);
    edit.set_halfedge(Vertex(records.half_edges[h.twin].origin), half_[h.twin]);
  }
  for (const Row row : step.made) {
    const DcelRecords::HalfEdgeRecord& h = records.half_edges[row];
    edit.connect(half_[h.prev], half_[row]);
    edit.connect(half_[row], half_[h.next]);
    edit.connect(half_[h.twin], half_[records.half_edges[h.twin].next]);
    edit.connect(half_[records.half_edges[h.twin].prev], half_[h.twin]);
  }
  edit.set_halfedge(face_[face_row], half_[records.faces[face_row].outer_component]);
}

}  // namespace ryosen::steps
