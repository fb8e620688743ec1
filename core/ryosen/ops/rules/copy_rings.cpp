#include "ryosen/ops/rules/copy_rings.h"

#include <algorithm>
#include <vector>

#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

// Returns the last of the copies (ascending) that stay and have edges or, if there is none, the last that stays.
template <class Copies>
Vertex heir_among(const Mesh& m, const Copies& copies, std::span<const Vertex> going) {
  Vertex last;
  for (auto copy = copies.rbegin(); copy != copies.rend(); ++copy) {
    if (std::binary_search(going.begin(), going.end(), *copy)) continue;
    if (!m.is_isolated(*copy)) return *copy;
    if (!last) last = *copy;
  }
  return last;
}

}  // namespace

bool CopyRings::get_to_know(Vertex p) {
  constexpr int few = 32;
  if (knows(p)) return true;
  int count = 0;
  if (walked_.insert(p).second || !any_of_copies(edit_.mesh(), p, [&](Vertex) { return ++count > few; })) return false;
  know(p);
  return true;
}

void CopyRings::know(Vertex p) {
  const Mesh& m = edit_.mesh();
  std::set<Vertex>& ring = rings_[p];
  for_each_copy(m, p, [&](Vertex copy) {
    ring.insert(copy);
    before_[m.next_copy(copy)] = copy;
  });
}

void CopyRings::join(Vertex a, Vertex b) {
  const Mesh& m = edit_.mesh();
  const Vertex p = point(m, a), q = point(m, b);
  if (!knows(p) && !knows(q)) return join_copies(edit_, a, b);
  for (const Vertex each : {p, q})
    if (!knows(each)) know(each);
  join_copies(edit_, a, b);
  before_[m.next_copy(a)] = a;
  before_[m.next_copy(b)] = b;
  std::set<Vertex> one = std::move(rings_.at(p)), other = std::move(rings_.at(q));
  if (one.size() < other.size()) one.swap(other);
  one.merge(other);
  rings_.erase(p);
  rings_.erase(q);
  rings_.emplace(std::min(p, q), std::move(one));
}

void CopyRings::leave(Vertex v, Vertex other) {
  const Mesh& m = edit_.mesh();
  const Vertex p = point(m, v);
  if (p != v && m.next_copy(other) == v) return unlink(v, other);
  if (p != v && get_to_know(p)) return unlink(v, before_.at(v));
  rings_.erase(p);
  leave_copies(edit_, v);
}

// Takes out a copy that is not the representative of its point.
void CopyRings::unlink(Vertex v, Vertex before) {
  const Mesh& m = edit_.mesh();
  const Vertex p = point(m, v), after = m.next_copy(v);
  edit_.set_copy_links(before, after, p);
  edit_.set_copy_links(v, v, v);
  const auto ring = rings_.find(p);
  if (ring == rings_.end()) return;
  before_[after] = before;
  before_.erase(v);
  ring->second.erase(v);
}

Vertex CopyRings::leave_all(std::span<const Vertex> going) {
  const Mesh& m = edit_.mesh();
  const Vertex p = point(m, going.front());
  if (!get_to_know(p)) return leave_small(going);
  std::vector<Vertex> go(going.begin(), going.end());
  std::sort(go.begin(), go.end());
  Vertex heir;
  if (go.front() == p) {
    heir = heir_among(m, rings_.at(p), go);
    go.front() = heir ? heir : go.back();
    if (!heir) go.pop_back();
  }
  for (const Vertex v : go) unlink(v, before_.at(v));
  if (rings_.at(p).size() == 1) rings_.erase(p);
  return heir;
}

Vertex CopyRings::leave_small(std::span<const Vertex> going) {
  const Mesh& m = edit_.mesh();
  const Vertex p = point(m, going.front());
  std::vector<Vertex> go(going.begin(), going.end()), stay, ascending;
  std::sort(go.begin(), go.end());
  for_each_copy(m, p, [&](Vertex copy) {
    if (!std::binary_search(go.begin(), go.end(), copy)) stay.push_back(copy);
  });
  Vertex heir;
  if (go.front() == p && !stay.empty()) {
    ascending = stay;
    std::sort(ascending.begin(), ascending.end());
    heir = heir_among(m, ascending, go);
    go.front() = heir;
    stay.erase(std::find(stay.begin(), stay.end(), heir));
    stay.insert(stay.begin(), p);
  }
  for (const Vertex copy : go) edit_.set_copy_links(copy, copy, copy);
  if (!stay.empty()) link_copies(edit_, stay);
  return heir;
}

}  // namespace ryosen
