#include "ryosen/analysis/boundary_loops.h"

#include <unordered_map>
#include <unordered_set>

#include "ryosen/base/interruption.h"

namespace ryosen {

namespace {

Halfedge inside_half(const Mesh& mesh, Edge e) {
  return mesh.is_outside(halfedge(e, 0)) ? halfedge(e, 1) : halfedge(e, 0);
}

// Appends the edges from `start` on until the chain closes or ends; returns whether it closed.
bool follow(Neighbourhood& around, BoundaryStep start, IndexSet& left, std::vector<Halfedge>& chain) {
  BoundaryStep step = start;
  do {
    stop_if_interrupted();
    left.erase(edge(step.inside).index);
    chain.push_back(twin(step.inside));
    step = around.next_boundary(step);
    if (!step.inside) return false;
  } while (left.contains(edge(step.inside).index));
  return step.inside == start.inside;
}

// One end of an edge: 2 * edge, plus 1 for the end of its first halfedge.
using EdgeEnd = std::uint32_t;
constexpr EdgeEnd chain_stop = no_index;  // at a non-manifold edge
constexpr EdgeEnd no_link = no_index - 1;
using EndLinks = std::unordered_map<EdgeEnd, EdgeEnd>;

struct BoundaryPart {
  EndLinks joints;  // of ends at which the boundary leaves it: another such end to which it leads within it, or a stop
  std::uint32_t loops = 0;  // within the part
};

EdgeEnd other_end(EdgeEnd end) { return end ^ 1u; }

// The end of the edge at which a step leaves it.
EdgeEnd end_of(const BoundaryStep& step) {
  const bool along_first_half = (step.inside.index & 1u) == 0;
  return 2 * edge(step.inside).index + (step.at_end == along_first_half ? 1u : 0u);
}

// Number of closed loops formed by two sets of joints between the same ends.
std::uint32_t loops_of(const EndLinks& inside, const EndLinks& outside) {
  std::unordered_set<EdgeEnd> seen;
  std::uint32_t loops = 0;
  for (const auto& [start, unused] : inside) {
    if (seen.contains(start)) continue;
    EdgeEnd at = start;
    do {
      seen.insert(at);
      at = inside.at(at);
      if (at == chain_stop) break;
      seen.insert(at);
      at = outside.at(at);
    } while (at != chain_stop && at != start);
    // An open chain ends at a stop from either direction and is not counted.
    loops += at == start;
  }
  return loops;
}

template <class Put>
void put_links(Neighbourhood& around, Edge e, Put put) {
  const Halfedge inside = inside_half(around.mesh(), e);
  stop_if_interrupted();
  for (const bool at_end : {true, false}) {
    const BoundaryStep step{inside, at_end}, next = around.next_boundary(step);
    put(end_of(step), next.inside ? other_end(end_of(next)) : chain_stop);
  }
}

std::uint32_t count_loops(std::span<const EdgeEnd> links, const IndexSet& boundary) {
  std::vector<bool> seen(links.size() / 2, false);
  std::uint32_t loops = 0;
  // Marks the edges from an end on; returns where the walk ends.
  const auto follow = [&](EdgeEnd end) {
    while (end != chain_stop && !seen[end / 2]) {
      seen[end / 2] = true;
      end = links[other_end(end)];
    }
    return end;
  };
  boundary.for_each([&](std::uint32_t i) {
    if (seen[i]) return;
    if (follow(2 * i) == 2 * i)
      ++loops;
    else
      follow(links[2 * i]);
  });
  return loops;
}

EndLinks links_at(std::span<const EdgeEnd> links, std::span<const Edge> edges) {
  EndLinks found;
  for (Edge e : edges)
    for (const EdgeEnd end : {2 * e.index, 2 * e.index + 1})
      if (end < links.size() && links[end] != no_link) found[end] = links[end];
  return found;
}

// How many ends are linked to a stop.
std::uint32_t stops_in(const EndLinks& links) {
  std::uint32_t stops = 0;
  for (const auto& [end, next] : links) stops += next == chain_stop;
  return stops;
}

BoundaryPart part_of(const EndLinks& links) {
  BoundaryPart part;
  std::unordered_set<EdgeEnd> seen;  // always both ends of an edge
  const auto leads_out = [&](EdgeEnd end) { return end != chain_stop && !links.contains(end); };
  // Follows the boundary from an end to the last end within the part.
  const auto follow = [&](EdgeEnd end) {
    const EdgeEnd start = other_end(end);
    for (;;) {
      end = other_end(end);
      seen.insert({end, other_end(end)});
      const EdgeEnd next = links.at(end);
      if (next == chain_stop || leads_out(next) || next == other_end(start)) return end;
      end = next;
    }
  };
  for (const auto& [end, next] : links) {
    if (next != chain_stop && !leads_out(next)) continue;
    const EdgeEnd last = follow(end);
    if (next != chain_stop) part.joints[end] = links.at(last) == chain_stop ? chain_stop : last;
  }
  for (const auto& [end, next] : links) {
    if (seen.contains(end)) continue;
    follow(end);
    ++part.loops;
  }
  return part;
}

// The joints through the complement of the part with the links `inside`.
EndLinks joints_outside(std::span<const EdgeEnd> links, const BoundaryPart& part, const EndLinks& inside) {
  EndLinks joints;
  for (const auto& [end, unused] : part.joints) {
    if (joints.contains(end)) continue;
    EdgeEnd at = inside.at(end), next = chain_stop;
    for (;; at = next) {
      next = links[other_end(at)];
      if (next == chain_stop || inside.contains(next)) break;
    }
    joints[end] = next;
    if (next != chain_stop) joints[next] = end;
  }
  return joints;
}

}  // namespace

BoundaryLoops find_boundary_loops(Neighbourhood& around, const IndexSet& boundary) {
  const Mesh& mesh = around.mesh();
  BoundaryLoops loops;
  IndexSet left = boundary;
  std::vector<Halfedge> chain;
  boundary.for_each([&](std::uint32_t i) {
    if (!left.contains(i)) return;
    chain.clear();
    const Halfedge inside = inside_half(mesh, Edge(i));
    if (follow(around, {inside, true}, left, chain)) {
      loops.halfedges.insert(loops.halfedges.end(), chain.begin(), chain.end());
      loops.offsets.push_back(static_cast<std::uint32_t>(loops.halfedges.size()));
    } else {
      follow(around, {inside, false}, left, chain);  // removes the other half of the open chain
      loops.has_open_chain = true;
    }
  });
  return loops;
}

void BoundaryLoopCount::search(Neighbourhood& around, const IndexSet& boundary) {
  links_.clear();
  resize_in_steps(links_, 2 * std::size_t{around.mesh().edge_slots()});
  for (std::size_t i = 0; i < links_.size(); ++i) {
    stop_if_interrupted(static_cast<std::uint32_t>(i));
    links_[i] = no_link;
  }
  stops_ = 0;
  boundary.for_each([&](std::uint32_t i) {
    put_links(around, Edge(i), [&](EdgeEnd end, EdgeEnd next) {
      links_[end] = next;
      stops_ += next == chain_stop;
    });
  });
  count_ = count_loops(links_, boundary);
  ++revision_;
}

void BoundaryLoopCount::update(Neighbourhood& around, const IndexSet& boundary, std::span<const Edge> edges) {
  if (links_.size() < 2 * std::size_t{around.mesh().edge_slots()})
    links_.resize(2 * std::size_t{around.mesh().edge_slots()}, no_link);
  const EndLinks before = links_at(links_, edges);
  EndLinks after;
  for (Edge e : edges)
    if (boundary.contains(e.index)) put_links(around, e, [&](EdgeEnd end, EdgeEnd next) { after[end] = next; });
  if (before == after) return;
  const BoundaryPart part_before = part_of(before), part_after = part_of(after);
  // The links out of the part must be unchanged; otherwise `edges` was incomplete: recount.
  for (const auto& [end, joined] : part_before.joints) {
    const auto same = after.find(end);
    if (same == after.end() || same->second != before.at(end)) return search(around, boundary);
  }
  if (part_before.joints.size() != part_after.joints.size()) return search(around, boundary);
  count_ += part_after.loops - part_before.loops;
  if (part_before.joints != part_after.joints) {
    const EndLinks outside = joints_outside(links_, part_before, before);
    count_ += loops_of(part_after.joints, outside) - loops_of(part_before.joints, outside);
  }
  stops_ += stops_in(after) - stops_in(before);
  for (const auto& [end, next] : before) links_[end] = no_link;
  for (const auto& [end, next] : after) links_[end] = next;
  ++revision_;
}

}  // namespace ryosen
