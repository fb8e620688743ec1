#include "ryosen/ops/rules/shared_chain.h"

#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

std::vector<Halfedge> chain_from(const Mesh& m, Halfedge h) {
  std::vector<Halfedge> chain{h};
  while (has_two_edges(m, m.to(chain.back())) && m.next(chain.back()) != h) chain.push_back(m.next(chain.back()));
  return chain;
}

std::vector<Halfedge> chain_through(const Mesh& m, Halfedge h) {
  const std::vector<Halfedge> back = chain_from(m, twin(h));
  return chain_from(m, has_two_edges(m, m.to(back.back())) ? h : twin(back.back()));
}

std::vector<Vertex> inner_vertices(const Mesh& m, std::span<const Halfedge> chain) {
  std::vector<Vertex> inner;
  for (std::size_t i = 1; i < chain.size(); ++i) inner.push_back(m.from(chain[i]));
  return inner;
}

}  // namespace ryosen
