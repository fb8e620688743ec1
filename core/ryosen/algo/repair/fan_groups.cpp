#include "ryosen/algo/repair/fan_groups.h"

#include <algorithm>
#include <tuple>

#include "ryosen/mesh/copies.h"

namespace ryosen {

// From the first corner of an open fan, or from this one of a closed fan.
std::vector<Halfedge> FanGroups::corners_of_fan(Halfedge corner) const {
  std::vector<Halfedge> found{corner};
  for (;;) {
    const Halfedge side = across_.at(found.back());
    if (!side) break;
    const Halfedge next = mesh_.next(side);
    if (next == corner) return found;
    found.push_back(next);
  }
  for (Halfedge first = corner; const Halfedge side = across_.at(mesh_.prev(first));) {
    first = side;
    found.push_back(first);
  }
  return found;
}

void FanGroups::give_new_fan(Halfedge corner) {
  for (const Halfedge c : corners_of_fan(corner)) fan_[c] = fans_;
  ++fans_;
}

void FanGroups::find_fans(const std::vector<std::vector<Halfedge>>& edges) {
  for (const Halfedge corner : corners_)
    if (!fan_.contains(corner)) give_new_fan(corner);
  for (const std::vector<Halfedge>& sides : edges)
    while (exchange_two(sides)) {
    }
  groups_.reset(fans_);
}

// Forward as the first side runs.
std::vector<FanGroups::Pair> FanGroups::pairs_of(std::span<const Halfedge> sides) const {
  const auto place_of = [&](Vertex v) { return place_ ? (*place_)[v.index] : point(mesh_, v); };
  std::vector<Pair> pairs;
  for (const Halfedge side : sides) {
    const Halfedge other = across_.at(side);
    if (place_of(mesh_.from(side)) == place_of(mesh_.from(sides[0])))
      pairs.push_back({side, other, fan_.at(side), fan_.at(mesh_.next(side))});
    else if (!other)
      pairs.push_back({other, side, fan_.at(mesh_.next(side)), fan_.at(side)});
  }
  return pairs;
}

// Exchanges two pairs with the same fans at both ends, so that each fan becomes two; pairs two single sides.
bool FanGroups::exchange_two(std::span<const Halfedge> sides) {
  std::vector<Pair> pairs = pairs_of(sides);
  const auto fans = [](const Pair& p) { return std::pair(p.fan_at_start, p.fan_at_end); };
  std::stable_sort(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) { return fans(a) < fans(b); });
  const auto first =
      std::adjacent_find(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) { return fans(a) == fans(b); });
  if (first == pairs.end()) return false;
  const Pair one = *first, other = *(first + 1);
  set_pair(one.forward, other.backward);
  set_pair(other.forward, one.backward);
  if ((!one.forward && !other.backward) || (!other.forward && !one.backward)) return true;
  give_new_fan(one.forward ? one.forward : mesh_.next(other.backward));
  give_new_fan(one.forward ? mesh_.next(one.forward) : other.backward);
  return true;
}

void FanGroups::set_pair(Halfedge forward, Halfedge backward) {
  if (forward) across_[forward] = backward;
  if (backward) across_[backward] = forward;
}

void FanGroups::rename(Halfedge side, Halfedge now) {
  const Halfedge other = across_.at(side);
  across_.erase(side);
  set_pair(now, other);
  if (const auto found = fan_.find(side); found != fan_.end()) {
    fan_[now] = found->second;
    fan_.erase(side);
  }
}

}  // namespace ryosen
