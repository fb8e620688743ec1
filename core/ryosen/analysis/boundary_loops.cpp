#include "ryosen/analysis/boundary_loops.h"

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

}  // namespace ryosen
