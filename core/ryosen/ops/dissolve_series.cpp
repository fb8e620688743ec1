#include "ryosen/ops/dissolve_series.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/euler/unite_loop.h"
#include "ryosen/ops/op_series.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/local_facts.h"
#include "ryosen/ops/rules/shares.h"
#include "ryosen/ops/rules/surgery.h"
#include "ryosen/ops/unite_series.h"

namespace ryosen {

Face DissolveSeries::number(Face slot) const {
  const auto found = numbers_.find(slot);
  return found == numbers_.end() ? slot : found->second;
}

// Grows with each change of one of the two.
std::uint64_t DissolveSeries::changes(Face f, Face g) const {
  const auto of = [&](Face face) {
    const auto found = changes_.find(face);
    return found == changes_.end() ? std::uint64_t{0} : found->second;
  };
  return std::max(of(f), of(g));
}

std::uint64_t DissolveSeries::key(Face f, Face g) const {
  const auto [low, high] = std::minmax(f.index, g.index);
  return std::uint64_t{low} << 32 | high;
}

const Rule* DissolveSeries::known_refusal(Face f, Face g) const {
  const auto found = refused_.find(key(f, g));
  return found != refused_.end() && found->second.at == changes(f, g) ? &found->second.rule : nullptr;
}

std::vector<Halfedge> DissolveSeries::chain_of(Halfedge h) const {
  return takes_ == Takes::chain ? chain_through(mesh(), h) : std::vector{h};
}

// Whether no point between the edges of its chain has copies, as far as that is known.
bool DissolveSeries::is_known_chain(Halfedge h) const {
  const Mesh& m = mesh();
  if (takes_ == Takes::edge || (!has_two_edges(m, m.from(h)) && !has_two_edges(m, m.to(h)))) return true;
  const auto found = known_chains_.find(edge(h));
  return found != known_chains_.end() && found->second == changes(m.face(h), m.face(twin(h)));
}

void DissolveSeries::refuse(Face f, Face g, Rule rule) {
  refused_.insert_or_assign(key(f, g), Refusal{rule, changes(f, g)});
}

std::optional<Rule> DissolveSeries::broken_rule(const Dissolve& op) {
  plain_.clear();
  plain_star_ = {};
  if (op.vertex.is_none() && is_there(mesh(), op.halfedge)) return broken_rule_of_edge(op.halfedge);
  const Union star = op.vertex && is_there(mesh(), op.vertex) ? judge_star(op.vertex) : Union::unsure;
  if (star == Union::touching) return Rule::loop;
  if (star == Union::plain) {
    plain_star_ = op.vertex;
    return std::nullopt;
  }
  return first_rule_of(op.check(mesh()));
}

// In the order in which check() refuses.
std::optional<Rule> DissolveSeries::broken_rule_of_edge(Halfedge h) {
  const Mesh& m = mesh();
  const Face f = m.face(h), g = m.face(twin(h));
  if (!f || !g) return Rule::boundary;
  if (f == g) return Rule::same_face;
  if (is_cut_on_points(m, h)) return Rule::copies;
  const Rule* const known = known_refusal(f, g);
  if (known && is_known_chain(h)) return *known;
  std::vector<Halfedge> chain = chain_of(h);
  looks_ += chain.size();
  for (const Halfedge side : chain)
    if (is_cut_on_points(m, side) || (side != chain[0] && has_copies(m, m.from(side)))) return Rule::copies;
  if (known) {
    // A closed chain begins at the edge that is asked about.
    if (m.from(chain.front()) != m.to(chain.back()) || !has_copies(m, m.from(chain.front())))
      for (const Halfedge side : chain) known_chains_[edge(side)] = changes(f, g);
    return *known;
  }
  const Union both = judge_union(m, chain, known_, &looks_);
  if (both == Union::plain) {
    plain_ = std::move(chain);
    return std::nullopt;
  }
  if (both == Union::touching) {
    refuse(f, g, Rule::loop);
    return Rule::loop;
  }
  looks_ += known_.corner_count(m, f) + known_.corner_count(m, g);
  const Verdict verdict = takes_ == Takes::chain ? Dissolve{h}.check(m) : UniteLoop{h}.check(m);
  if (verdict.legal()) return std::nullopt;
  // Two faces with several chains between them are refused at each by `loop`, and with one by one rule all along it.
  if (verdict.reasons[0].rule != Rule::copies) refuse(f, g, verdict.reasons[0].rule);
  return verdict.reasons[0].rule;
}

// Faces that may be united have one chain between them, so that what is said of it is said of the two.
std::optional<Rule> DissolveSeries::doubt(const Dissolve& op) {
  const std::vector<Reason> doubts =
      takes_ == Takes::chain ? op.warnings(mesh()) : UniteLoop{op.halfedge}.warnings(mesh());
  if (doubts.empty()) return std::nullopt;
  if (!plain_.empty()) refuse(mesh().face(plain_[0]), mesh().face(twin(plain_[0])), doubts[0].rule);
  return doubts[0].rule;
}

void DissolveSeries::apply(const Dissolve& op) {
  if (!plain_.empty()) {
    merge_values(plain_);
    unite(plain_);
    plain_.clear();
    return;
  }
  if (plain_star_) return unite_star(std::exchange(plain_star_, {}));
  finish();
  if (takes_ == Takes::chain)
    op.apply(edit_);
  else
    UniteLoop{op.halfedge}.apply(edit_);
}

void DissolveSeries::merge_values(std::span<const Halfedge> halves) {
  std::vector<Edge> edges;
  for (const Halfedge h : halves) edges.push_back(edge(h));
  std::sort(edges.begin(), edges.end());
  merge_corner_values(edit_, edges, [&](Face f) { return number(f).index; });
}

void DissolveSeries::unite(const std::vector<Halfedge>& chain) {
  const Mesh& m = mesh();
  const Face left = m.face(chain[0]), right = m.face(twin(chain[0]));
  const std::uint32_t of_left = known_.corner_count(m, left), of_right = known_.corner_count(m, right);
  const Face large = of_left < of_right ? right : left, small = large == left ? right : left;
  const Face numbers[] = {number(left), number(right)};
  const bool left_stays = numbers[0] < numbers[1];
  // The common face begins where the one whose number stays began.
  Halfedge start = m.halfedge(left_stays ? left : right);
  const Halfedge past = left_stays ? m.next(twin(chain.front())) : m.next(chain.back());
  for (const Halfedge h : chain)
    if (start == (left_stays ? h : twin(h))) start = past;
  // Values stand at the numbers.
  const Face slots[] = {left_stays ? left : right, left_stays ? right : left};
  const Face both[] = {number(slots[0]), number(slots[1])};
  edit_.unite<Face>(both[0], both, [&] { return areas_of(m, slots); });
  known_.unites(m, large, small);
  give_corners(small, large);
  const std::vector<Vertex> inner = inner_vertices(m, chain);
  for (const Halfedge h : chain) unlink_edge(edit_, h);
  for (const Vertex v : inner) edit_.drop(v);
  edit_.set_halfedge(large, start);

  const Face stays = left_stays ? numbers[0] : numbers[1];
  for (const Face slot : {left, right, numbers[0], numbers[1]})
    if (slot != large && slot != stays && m.is_alive(slot)) edit_.remove(slot);
  numbers_.erase(small);
  numbers_[large] = stays;
  known_.united(large, small, of_left + of_right - static_cast<std::uint32_t>(2 * chain.size()), inner);
  changes_.erase(small);
  changes_[large] = ++change_;
}

void DissolveSeries::give_corners(Face from, Face to) {
  for (const Halfedge h : loop(mesh(), mesh().halfedge(from))) {
    ++looks_;
    edit_.set_face(h, to);
  }
}

bool DissolveSeries::finish() {
  bool renumbers = false;
  for (const auto& [slot, stays] : numbers_) {
    if (slot == stays) continue;
    renumbers = true;
    give_corners(slot, stays);
    edit_.set_halfedge(stays, mesh().halfedge(slot));
    edit_.remove(slot);
  }
  forget_all();
  return renumbers;
}

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
  for (const Vertex v : gone) edit_.drop(v);
  known_.united(f, Face(), known_.corner_count(m, f) - static_cast<std::uint32_t>(2 * chain.size()), gone);
  changes_[f] = ++change_;
}

void DissolveSeries::forget_all() {
  known_ = {};
  numbers_.clear();
  changes_.clear();
  refused_.clear();
  known_chains_.clear();
  plain_.clear();
  plain_star_ = {};
}

namespace {

// Vertices with two edges are taken out by a series of their own: each is told where the other has changed the mesh.
class Dissolves : public OpSeries {
 public:
  explicit Dissolves(Edit& edit) : edit_(edit), of_edges_(edit), of_vertices_(edit) {}
  std::optional<Rule> broken_rule(const AnyOp& any) override {
    const Dissolve& op = std::get<Dissolve>(any);
    return is_two_edged(op) ? of_vertices_.broken_rule(op.vertex) : of_edges_.broken_rule(op);
  }
  std::optional<Rule> doubt(const AnyOp& any) override {
    const Dissolve& op = std::get<Dissolve>(any);
    return is_two_edged(op) ? std::nullopt : of_edges_.doubt(op);
  }
  void apply(const AnyOp& any) override {
    const Dissolve& op = std::get<Dissolve>(any);
    if (is_two_edged(op)) {
      if (of_edges_.finish()) {  // what is known of faces is known by their numbers
        of_vertices_ = UniteSeries(edit_);
        of_vertices_.broken_rule(op.vertex);
      }
      of_vertices_.apply(op.vertex);
    } else {
      of_edges_.apply(op);
      of_vertices_ = UniteSeries(edit_);
    }
  }
  void finish() override { of_edges_.finish(); }

 private:
  bool is_two_edged(const Dissolve& op) const {
    return op.vertex && edit_.mesh().is_alive(op.vertex) && has_two_edges(edit_.mesh(), op.vertex);
  }

  Edit& edit_;
  DissolveSeries of_edges_;
  UniteSeries of_vertices_;
};

class UnitedLoops : public OpSeries {
 public:
  explicit UnitedLoops(Edit& edit) : series_(edit, DissolveSeries::Takes::edge) {}
  std::optional<Rule> broken_rule(const AnyOp& op) override { return series_.broken_rule(as_dissolve(op)); }
  std::optional<Rule> doubt(const AnyOp& op) override { return series_.doubt(as_dissolve(op)); }
  void apply(const AnyOp& op) override { series_.apply(as_dissolve(op)); }
  void finish() override { series_.finish(); }

 private:
  static Dissolve as_dissolve(const AnyOp& op) { return {std::get<UniteLoop>(op).halfedge}; }

  DissolveSeries series_;
};

}  // namespace

std::unique_ptr<OpSeries> dissolves_in_series(Edit& edit) { return std::make_unique<Dissolves>(edit); }
std::unique_ptr<OpSeries> unites_loops_in_series(Edit& edit) { return std::make_unique<UnitedLoops>(edit); }

}  // namespace ryosen
