#include "ryosen/ops/preview/tool_verdicts.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

std::uint64_t next_serial() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

std::uint32_t slots_of(const Mesh& mesh, Element::Kind sort) {
  return sort == Element::Kind::vertex ? mesh.vertex_slots()
         : sort == Element::Kind::face ? mesh.face_slots()
                                       : mesh.edge_slots();
}

std::vector<Vertex> with_copies(const Mesh& mesh, const std::vector<Vertex>& vertices) {
  std::vector<Vertex> all;
  for (const Vertex v : vertices) for_each_copy(mesh, v, [&](Vertex copy) { all.push_back(copy); });
  sort_unique(all);
  return all;
}

std::vector<Face> faces_at(const Mesh& mesh, const std::vector<Vertex>& vertices) {
  std::vector<Face> faces;
  for (const Vertex v : vertices)
    for (const Face f : faces_around(mesh, v))
      if (f) faces.push_back(f);
  sort_unique(faces);
  return faces;
}

// Those of all copies, the other ends of their edges, and the corners of their faces.
std::vector<Vertex> with_around(const Mesh& mesh, const std::vector<Vertex>& vertices) {
  std::vector<Vertex> all = with_copies(mesh, vertices);
  const std::vector<Face> faces = faces_at(mesh, all);
  const std::size_t own = all.size();
  for (std::size_t i = 0; i < own; ++i)
    for (const Vertex v : neighbours(mesh, all[i])) all.push_back(v);
  for (const Face f : faces)
    for (const Vertex v : vertices_around(mesh, f)) all.push_back(v);
  return with_copies(mesh, all);
}

std::vector<Vertex> vertices_of(const Mesh& mesh, const TouchedElements& touched) {
  std::vector<Vertex> all;
  const auto add = [&](Vertex v) {
    if (mesh.exists(v) && mesh.is_alive(v)) all.push_back(v);
  };
  for (const Vertex v : touched.vertices) add(v);
  for (const Halfedge h : touched.halfedges)
    if (mesh.exists(h) && mesh.is_alive(h)) add(mesh.from(h)), add(mesh.to(h));
  for (const Face f : touched.faces)
    if (mesh.exists(f) && mesh.is_alive(f))
      for (const Vertex v : vertices_around(mesh, f)) add(v);
  sort_unique(all);
  return all;
}

// Those at the vertices and, of an operator that is about cycles, all along the cycles that they lie on.
std::vector<std::uint32_t> edges_at(const Mesh& mesh, const std::vector<Vertex>& vertices, bool with_cycles) {
  std::vector<std::uint32_t> edges;
  std::vector<Halfedge> outside;
  for (const Vertex v : vertices)
    for (const Halfedge h : outgoing(mesh, v)) {
      edges.push_back(edge(h).index);
      if (with_cycles)
        for (const Halfedge side : {h, twin(h)})
          if (mesh.is_outside(side)) outside.push_back(side);
    }
  sort_unique(outside);
  std::vector<bool> is_seen(outside.size());
  for (std::size_t i = 0; i < outside.size(); ++i) {
    if (is_seen[i]) continue;
    for (const Halfedge h : loop(mesh, outside[i])) {
      edges.push_back(edge(h).index);
      const auto place = std::lower_bound(outside.begin(), outside.end(), h);
      if (place != outside.end() && *place == h) is_seen[static_cast<std::size_t>(place - outside.begin())] = true;
    }
  }
  return edges;
}

}  // namespace

ToolVerdicts::ToolVerdicts(const Mesh& mesh, const OpInfo& op, Element::Kind sort)
    : serial_(next_serial()), op_(&op), sort_(sort), verdicts_(slots_of(mesh, sort), ElementVerdict::none) {}

void ToolVerdicts::ask_about(const Mesh& mesh, std::uint32_t slot) {
  Element asked;
  asked.kind = sort_;
  asked.index = slot;
  ElementVerdict& verdict = verdicts_[slot];
  verdict = ElementVerdict::none;
  if (!is_alive(mesh, asked)) return;
  OpTarget target;
  if (sort_ == Element::Kind::vertex) target.vertex = asked.vertex();
  if (sort_ == Element::Kind::edge) target.halfedge = halfedge(asked.edge());
  if (sort_ == Element::Kind::face) target.face = asked.face();
  const bool is_legal = answers_.ask(mesh, op_at(mesh, op_->id, target)).verdict.legal();
  verdict = is_legal ? ElementVerdict::legal : ElementVerdict::refused;
}

void ToolVerdicts::ask(const Mesh& mesh, const std::function<bool()>& may_go_on) {
  constexpr std::uint32_t stride = 64;
  std::uint32_t questions = 0;
  const auto is_enough = [&] { return ++questions % stride == 0 && may_go_on && !may_go_on(); };
  while (!due_.empty()) {
    ask_about(mesh, due_.back());
    asked_again_.push_back(due_.back());
    due_.pop_back();
    if (is_enough()) return;
  }
  while (asked_ < verdicts_.size()) {
    ask_about(mesh, asked_++);
    if (is_enough()) return;
  }
}

// A verdict is about the faces at the ends of an edge, at a vertex or around a face, all of whose corners it may ask
// for their copies and edges: what lies two steps from what was touched knows nothing of it.
void ToolVerdicts::follow(const Mesh& mesh, const TouchedElements& touched) {
  answers_ = KnownAnswers();
  verdicts_.resize(slots_of(mesh, sort_), ElementVerdict::none);
  asked_ = std::min<std::uint32_t>(asked_, slots_of(mesh, sort_));
  const std::vector<Vertex> around = with_around(mesh, with_around(mesh, vertices_of(mesh, touched)));
  const auto add = [&](std::uint32_t slot) {
    if (slot < asked_) due_.push_back(slot);
  };
  std::erase_if(due_, [&](std::uint32_t slot) { return slot >= asked_; });
  std::erase_if(asked_again_, [&](std::uint32_t slot) { return slot >= asked_; });
  if (sort_ == Element::Kind::vertex) {
    for (const Vertex v : around) add(v.index);
    for (const Vertex v : touched.vertices) add(v.index);  // also those that died
  } else if (sort_ == Element::Kind::face) {
    for (const Face f : faces_at(mesh, around)) add(f.index);
    for (const Face f : touched.faces) add(f.index);
  } else {
    for (const std::uint32_t e : edges_at(mesh, around, op_->subject == Subject::cycle)) add(e);
    for (const Halfedge h : touched.halfedges) add(edge(h).index);
  }
  sort_unique(due_);
}

std::vector<std::uint32_t> ToolVerdicts::take_asked_again() {
  sort_unique(asked_again_);
  return std::exchange(asked_again_, {});
}

}  // namespace ryosen
