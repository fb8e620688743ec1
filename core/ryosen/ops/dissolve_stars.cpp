// DissolveSeries: vertices inside the surface, each of which unites the faces around it.
#include <algorithm>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/dissolve_series.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/shared_chain.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

// The chains from the vertex, each between two faces of a simple kind, none of which comes twice; else none.
std::vector<std::vector<Halfedge>> DissolveSeries::plain_chains(Vertex v) {
  const Mesh& m = mesh();
  std::vector<std::vector<Halfedge>> chains;
  if (m.is_isolated(v) || m.is_boundary(v) || has_copies(m, v)) return {};
  std::vector<Face> faces;
  for (const Halfedge h : outgoing(m, v)) {
    const Face f = m.face(h);
    if (!f || !known_.is_one_simple_loop(m, f) || known_.has_equal_face(m, f)) return {};
    faces.push_back(f);
    chains.push_back(chain_from(m, h));
    looks_ += chains.back().size();
    if (m.to(chains.back().back()) == v) return {};
    for (const Halfedge side : chains.back())
      if (is_cut_on_points(m, side) || (side != h && has_copies(m, m.from(side)))) return {};
  }
  sort_unique(faces);
  return faces.size() > 2 && faces.size() == chains.size() ? chains : std::vector<std::vector<Halfedge>>();
}

// Whether a face that is not at the vertex may lie on the points of the united one.
bool DissolveSeries::may_another_lie_on(std::span<const std::uint32_t> points, std::size_t corners, Vertex v) {
  const Mesh& m = mesh();
  return any_of_copies(m, loneliest_point(m, points), [&](Vertex copy) {
    for (const Face f : faces_around(m, copy)) {
      ++looks_;
      if (f && known_.corner_count(m, f) >= corners && !touches(m, f, v)) return true;
    }
    return false;
  });
}

// The way around the vertex past all faces but the largest meets no point twice, and the largest at its ends alone.
Union DissolveSeries::judge_star(Vertex v) {
  const Mesh& m = mesh();
  if (takes_ != Takes::chain) return Union::unsure;
  std::vector<std::vector<Halfedge>> chains = plain_chains(v);
  if (chains.empty()) return Union::unsure;
  const auto corners_left_of = [&](const auto& chain) { return known_.corner_count(m, m.face(chain.front())); };
  const auto largest = std::max_element(chains.begin(), chains.end(), [&](const auto& a, const auto& b) {
    return corners_left_of(a) < corners_left_of(b);
  });
  std::rotate(chains.begin(), largest, chains.end());
  std::vector<std::uint32_t> way;
  for (std::size_t i = 1; i < chains.size(); ++i) {
    const Halfedge end = twin(chains[(i + 1) % chains.size()].back());
    for (Halfedge side = m.next(chains[i].back()); side != end; side = m.next(side))
      way.push_back(point(m, m.from(side)).index);
  }
  looks_ += way.size();
  // Where both chains of the largest face end at one point, nothing of it is left.
  if (way.empty() || m.to(chains[0].back()) == m.to(chains[1].back())) return Union::unsure;
  std::vector<std::uint32_t> met = way;
  met.push_back(point(m, m.to(chains[0].back())).index);
  sort_unique(met);
  if (met.size() != way.size() + 1) return Union::touching;
  const Face large = m.face(chains[0].front());
  for (std::size_t i = 1; i < way.size(); ++i)
    if (known_.touches(m, large, Vertex(way[i]), looks_)) return Union::touching;
  const std::size_t corners = corners_left_of(chains[0]) + way.size() - chains[0].size() - chains[1].size();
  return corners < 3 || may_another_lie_on(met, corners, v) ? Union::unsure : Union::plain;
}

// Face by face, as one call does it; the last chain is left with one face on both sides.
void DissolveSeries::unite_star(Vertex v) {
  const Mesh& m = mesh();
  std::vector<std::vector<Halfedge>> chains;
  std::vector<Halfedge> halves;
  for (const Halfedge h : outgoing(m, v)) {
    chains.push_back(chain_from(m, h));
    halves.insert(halves.end(), chains.back().begin(), chains.back().end());
  }
  merge_values(halves);
  for (const std::vector<Halfedge>& chain : chains) {
    if (m.face(chain[0]) != m.face(twin(chain[0])))
      unite(chain);
    else
      take_spike_away(chain);
  }
}

void DissolveSeries::take_spike_away(const std::vector<Halfedge>& chain) {
  const Mesh& m = mesh();
  const Face f = m.face(chain.front());
  const Halfedge after = m.next(chain.back());
  std::vector<Vertex> gone = inner_vertices(m, chain);
  gone.push_back(m.from(chain.front()));
  for (const Halfedge h : chain)
    for (const Halfedge side : {h, twin(h)}) replace_start(edit_, f, side, after);
  for (const Halfedge h : chain) unlink_edge(edit_, h);
  for (const Vertex v : gone) edit_.remove(v);
  known_.united(f, Face(), known_.corner_count(m, f) - static_cast<std::uint32_t>(2 * chain.size()), gone);
  changes_[f] = ++change_;
}

}  // namespace ryosen
