#include "ryosen/ops/rules/edge_sides.h"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>

#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

// The side of a face along an edge between two points: that of the halfedge, of its twin, else of another sheet. The
// halfedge itself where there are but wires.
Halfedge side_of(const Mesh& m, Halfedge h) {
  if (!m.is_outside(h)) return h;
  if (!m.is_outside(twin(h))) return twin(h);
  for (Halfedge sheet : sheets_between(m, m.from(h), m.to(h)))
    for (Halfedge side : {sheet, twin(sheet)})
      if (!m.is_outside(side)) return side;
  return h;
}

class NamedSides {
 public:
  NamedSides(const Mesh& m, std::span<const Halfedge> edges) : m_(m) {
    std::set<std::pair<Vertex, Vertex>> met;
    for (Halfedge h : edges)
      if (met.insert(std::minmax(start(h), start(twin(h)))).second) sides_.push_back(side_of(m, h));
    for (std::size_t i = 0; i < sides_.size(); ++i)
      for (Halfedge h : {sides_[i], twin(sides_[i])}) at_[start(h)].push_back(i);
    is_directed_.resize(sides_.size());
    for (std::size_t i = 0; i < sides_.size(); ++i)
      if (m.is_outside(sides_[i]) != m.is_outside(twin(sides_[i]))) direct(i);
    follow();
    for (std::size_t i = 0; i < sides_.size(); ++i, follow())
      if (!is_directed_[i]) direct(i);
  }

  std::vector<Halfedge> take() { return std::move(sides_); }

 private:
  Vertex start(Halfedge h) const { return point(m_, m_.from(h)); }
  void direct(std::size_t i) {
    is_directed_[i] = true;
    waiting_.push_back(i);
  }
  void follow() {
    for (; !waiting_.empty();) {
      const std::size_t i = waiting_.back();
      waiting_.pop_back();
      lead(i, sides_[i]);
      lead(i, twin(sides_[i]));
    }
  }
  // To the other edge at the beginning of a halfedge of this one: it ends there, or begins where this one ends.
  void lead(std::size_t i, Halfedge from) {
    const std::vector<std::size_t>& here = at_.at(start(from));
    if (here.size() != 2) return;
    const std::size_t other = here[0] == i ? here[1] : here[0];
    if (is_directed_[other]) return;
    const bool is_to_end_here = from == sides_[i];
    const bool ends_here = start(twin(sides_[other])) == start(from);
    if (is_to_end_here != ends_here) sides_[other] = twin(sides_[other]);
    direct(other);
  }

  const Mesh& m_;
  std::vector<Halfedge> sides_;
  std::unordered_map<Vertex, std::vector<std::size_t>> at_;  // by point
  std::vector<bool> is_directed_;
  std::vector<std::size_t> waiting_;
};

}  // namespace

std::vector<Halfedge> sides_of(const Mesh& m, std::span<const Halfedge> edges) { return NamedSides(m, edges).take(); }

}  // namespace ryosen
