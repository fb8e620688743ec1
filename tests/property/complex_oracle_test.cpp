// Every operator on random meshes with rings, bridges, wires, isolated vertices, several fans and copies, against the
// lists of the oracle: verdicts and results.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/kernel_sum.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/oracle/complex_rules.h"
#include "tests/support/core/oracle/extruding.h"
#include "tests/support/core/random_ops.h"

namespace ryosen {
namespace {

using namespace test;
using oracle::Complex;
using oracle::ComplexFacts;
using oracle::Corners;
using oracle::Outcome;
using oracle::Outcomes;
using oracle::Pair;
using oracle::Place;

constexpr int max_reports = 3;  // per operator

struct Count {
  std::map<std::string, std::size_t> legal, refused;
  std::map<std::string, std::map<std::string, std::size_t>> rules;
  std::size_t verdicts = 0, disagreements = 0;
  std::map<std::string, int> reports;
};

oracle::Shape compared(const Complex& complex) { return shape_of(oracle::on_points(complex)); }

// The numbers of points that were not there before, renamed in the order in which faces and corners meet them.
Complex with_new_points_in_order(const Complex& complex, const std::set<int>& before) {
  Complex points = oracle::on_points(complex);
  std::map<int, int> name;
  int next = 1000;
  for (auto& face : points.faces)
    for (Corners& loop : face)
      for (int& v : loop)
        if (!before.contains(v)) {
          if (name.try_emplace(v, next).second) ++next;
          v = name[v];
        }
  for (const auto& [was, is] : name) points.live[was] = 0;
  points.live.resize(static_cast<std::size_t>(next), 0);
  points.point_of.resize(points.live.size());
  for (const auto& [was, is] : name) points.live[is] = 1, points.point_of[is] = is;
  return points;
}

class Comparison {
 public:
  Comparison(std::uint64_t seed, Count& count)
      : count_(count), dice_(seed), mesh_(random_complex(seed)), raw_(complex_of(mesh_, &places_)) {
    separated_ = oracle::separated(raw_);
    points_ = oracle::on_points(raw_);
    facts_ = oracle::facts_of(raw_);
    separated_facts_ = oracle::facts_of(separated_);
    points_facts_ = oracle::facts_of(points_);
    for (int v = 0; v < points_.size(); ++v)
      if (points_.live[v]) live_points_.insert(v);
    name_ = "seed " + std::to_string(seed) + ": " + to_text(raw_);
  }

  const Mesh& mesh() const { return mesh_; }

  void all() {
    for (std::uint32_t i = 0; i < mesh_.halfedge_slots(); ++i)
      if (mesh_.is_alive(Halfedge(i))) halfedge_operators(Halfedge(i));
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i)
      if (mesh_.is_alive(Face(i))) face_operators(Face(i));
    for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i)
      if (mesh_.is_alive(Vertex(i))) vertex_operators(Vertex(i));
  }

 private:
  int number(Vertex v) const { return static_cast<int>(v.index); }
  int point_of(Vertex v) const { return raw_.point_of[number(v)]; }
  const Place* place(Halfedge h) const {
    const auto found = places_.find(h);
    return found == places_.end() ? nullptr : &found->second;
  }
  // The ends of a halfedge in the separated list.
  Pair separated_ends(Halfedge h) const {
    if (const Place* at = place(h)) return {vertex_at(separated_, *at), next_vertex(separated_, *at)};
    if (const Place* at = place(twin(h))) return {next_vertex(separated_, *at), vertex_at(separated_, *at)};
    return {number(mesh_.from(h)), number(mesh_.to(h))};
  }
  Corners cycle_of(Halfedge h) const {
    Corners cycle;
    for (Vertex v : CycleRange<detail::next, detail::from>(mesh_, h)) cycle.push_back(number(v));
    return cycle;
  }
  Outcomes legal_among(const ComplexFacts& before, Outcomes outcomes, bool local) const {
    std::erase_if(outcomes, [&](const Outcome& outcome) {
      return !(local ? is_legal_local(before, outcome) : is_legal_euler(before, outcome));
    });
    return outcomes;
  }
  Outcomes euler(Outcomes outcomes) const { return legal_among(facts_, std::move(outcomes), false); }
  Outcomes local(Outcomes outcomes) const { return legal_among(separated_facts_, std::move(outcomes), true); }
  // Where the result is read anew from its points: no new fault and the same sheets, whatever the fans.
  Outcomes on_points(Outcomes outcomes) const {
    std::erase_if(outcomes, [&](const Outcome& outcome) { return !is_legal_on_points(points_facts_, outcome); });
    return outcomes;
  }

  void halfedge_operators(Halfedge h) {
    const auto [a, b] = separated_ends(h);
    const int from = number(mesh_.from(h)), to = number(mesh_.to(h));
    compare(CollapseEdge{h}, local(oracle::collapse(separated_, a, b)));
    for (bool back : {false, true}) {
      const Place* at = place(h);
      compare(SwapEdge{h, back}, at ? local(oracle::swap(separated_, *at, back)) : Outcomes());
    }
    const int middle = raw_.size(), p = point_of(mesh_.from(h)), q = point_of(mesh_.to(h));
    compare(SplitEdge{h}, oracle::put_into_edge(raw_, p, q, middle, true));
    compare(SeparateEdge{h}, oracle::put_into_edge(raw_, p, q, middle, false));
    compare(DeleteEdge{h}, euler(oracle::delete_edge(raw_, from, to)));
    const bool outside = mesh_.is_outside(h);
    const Corners cycle = cycle_of(h);
    compare(MakeLoop{h}, outside ? euler(oracle::make_loop(raw_, cycle)) : Outcomes());
    const bool is_simple = std::set<int>(cycle.begin(), cycle.end()).size() == cycle.size();
    compare(Fill{h}, outside && is_simple ? euler(oracle::make_loop(raw_, cycle)) : Outcomes());
    if (const Place* at = place(h)) {
      compare(UniteLoop{h}, euler(oracle::unite_loop(raw_, *at)));
      compare(MakeRing{h}, euler(oracle::make_ring(raw_, *at)));
    }
    if (h.index % 2 == 0) compare_delete(edge(h), faces_at(p, q), {std::minmax(p, q)}, -1);
    weld_edges(h, random_halfedge(mesh_, dice_));
  }

  std::vector<int> faces_at(int p, int q) const {
    std::vector<int> faces;
    for (const auto& side : sides_between(points_, p, q)) faces.push_back(side.first);
    return faces;
  }

  void compare_delete(Element element, const std::vector<int>& faces, const std::vector<Pair>& wires, int gone) {
    Outcome outcome{oracle::without_faces(points_, faces, wires)};
    if (gone >= 0) outcome.after.live[gone] = 0;
    compare(Delete{element}, {outcome});
  }

  void face_operators(Face f) {
    const int number_of_face = static_cast<int>(f.index);
    compare(DeleteLoop{f}, oracle::delete_loop(raw_, number_of_face));
    compare_delete(f, {number_of_face}, {}, -1);
    Outcome reversed{points_};
    for (int g : oracle::component_of(points_, number_of_face))
      for (Corners& loop : reversed.after.faces[g]) std::reverse(loop.begin(), loop.end());
    compare(Reverse{{f}}, {reversed});
    detach(f);
    for (int i = 0; i < 3; ++i) extrude(std::get<Extrude>(random_op_of(Extrude::info)));
    for (int i = 0; i < 3; ++i) extrude_edges(std::get<ExtrudeEdges>(random_op_of(ExtrudeEdges::info)));
    std::vector<Halfedge> corners;
    for (Halfedge h : halfedges_around(mesh_, f)) corners.push_back(h);
    for (Halfedge into_a : corners)
      for (Halfedge into_b : corners) {
        if (corners.size() > 8 && !dice_.one_in(6)) continue;
        compare_corners(into_a, into_b);
      }
  }

  void compare_corners(Halfedge into_a, Halfedge into_b) {
    const Place a = *place(mesh_.next(into_a)), b = *place(mesh_.next(into_b));
    const Outcomes all = oracle::separate_loop(raw_, a, b), good = euler(all);
    // Which side a ring goes to is decided by places, which lists do not have.
    if (good.size() == all.size() || good.empty()) compare(SeparateLoop{into_a, into_b}, good);
    compare(UniteRing{into_a, into_b}, euler(oracle::unite_ring(raw_, a, b)));
  }

  void detach(Face f) {
    const int named = static_cast<int>(f.index);
    std::vector<int> faces = oracle::sheet_of(points_, named);
    const auto touches = [&](const std::vector<int>& some) {
      return compared(oracle::detached(points_, some, 500)) != compared(points_);
    };
    if (!touches(faces)) faces = {named};
    Outcomes outcomes;
    if (touches(faces)) outcomes.push_back({oracle::detached(points_, faces, 500)});
    compare(Detach{{f}}, outcomes);
  }

  // Faces on equal point sets may not come apart; there is nothing else that raising faces could break.
  void extrude(const Extrude& op) {
    std::vector<int> faces;
    for (Face f : op.faces) faces.push_back(static_cast<int>(f.index));
    const Outcome outcome{oracle::extruded(points_, faces).after};
    const bool keeps_equal = oracle::facts_of(outcome.after).equal_faces == points_facts_.equal_faces;
    compare(op, keeps_equal ? Outcomes{outcome} : Outcomes());
  }

  // A bridge goes nowhere. What has faces on both sides or none may run either way.
  void extrude_edges(const ExtrudeEdges& op) {
    std::vector<std::vector<Pair>> ways{{}};
    std::set<Pair> met;
    for (Halfedge h : op.edges) {
      const int a = point_of(mesh_.from(h)), b = point_of(mesh_.to(h));
      if (!met.insert(std::minmax({a, b})).second) continue;
      std::vector<Pair> directions;
      std::set<int> faces;
      for (const auto& [face, is_forward] : oracle::sides_between(points_, a, b)) {
        if (!faces.insert(face).second) return compare(op, {});
        directions.push_back(is_forward ? Pair(a, b) : Pair(b, a));
      }
      const bool has_left = !mesh_.is_outside(h), has_right = !mesh_.is_outside(twin(h));
      if (has_left != has_right)
        directions = {has_left ? Pair(a, b) : Pair(b, a)};
      else
        directions = {{a, b}, {b, a}};
      std::vector<std::vector<Pair>> longer;
      for (const std::vector<Pair>& way : ways)
        for (const Pair& direction : directions) {
          longer.push_back(way);
          longer.back().push_back(direction);
        }
      ways = longer;
    }
    Outcomes outcomes;
    for (const std::vector<Pair>& way : ways) outcomes.push_back({oracle::with_extruded_edges(points_, way)});
    compare(op, outcomes);
  }

  AnyOp random_op_of(const OpInfo& wanted) {
    const auto is_wanted = [&](const OpInfo& info) { return info.id == wanted.id; };
    const auto found = std::find_if(all_ops().begin(), all_ops().end(), is_wanted);
    return random_op(mesh_, static_cast<std::size_t>(found - all_ops().begin()), dice_);
  }

  void vertex_operators(Vertex v) {
    const int n = number(v), p = point_of(v);
    compare(UniteEdge{v}, euler(oracle::unite_edge(raw_, n)));
    Outcome removed{raw_, -1};
    removed.after.live[n] = 0;
    const bool is_isolated = mesh_.is_isolated(v);
    compare(RemoveVertex{v}, is_isolated ? Outcomes{removed} : Outcomes());
    std::vector<int> faces;
    for (int f = 0; f < static_cast<int>(points_.faces.size()); ++f)
      for (const Corners& loop : points_.faces[f])
        if (std::count(loop.begin(), loop.end(), p) && (faces.empty() || faces.back() != f)) faces.push_back(f);
    std::vector<Pair> wires;
    for (const Pair& wire : points_.wires)
      if (wire.first == p || wire.second == p) wires.push_back(wire);
    compare_delete(v, faces, wires, p);
    bool has_fans = false;
    for (const auto& [fault, at, other] : facts_.faults)
      has_fans = has_fans || (fault == oracle::Fault::several_fans && raw_.point_of[at] == p);
    compare(SeparateFans{v}, has_fans ? Outcomes{{separated_}} : Outcomes());
    for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i) {
      if (!mesh_.is_alive(Vertex(i)) || (mesh_.vertex_slots() > 10 && !dice_.one_in(4))) continue;
      make_edge(v, Vertex(i));
      weld(v, Vertex(i));
    }
    const AnyOp op = random_op_of(MakeFace::info);
    if (const MakeFace* face = std::get_if<MakeFace>(&op)) make_face(*face);
  }

  Halfedge any_into(Vertex v) {
    if (mesh_.is_isolated(v)) return dice_.one_in(8) ? random_halfedge(mesh_, dice_) : Halfedge();
    std::vector<Halfedge> into{dice_.one_in(8) ? Halfedge() : twin(mesh_.halfedge(v))};
    for (Halfedge h : outgoing(mesh_, v)) into.push_back(twin(h));
    return into[static_cast<std::size_t>(dice_.below(static_cast<int>(into.size())))];
  }

  // Whether a new edge may arrive at v behind this halfedge: no face runs there.
  bool is_gap(Vertex v, Halfedge into) const {
    if (!into) return mesh_.is_isolated(v);
    return mesh_.to(into) == v && !place(into);
  }

  void make_edge(Vertex a, Vertex b) {
    const MakeEdge op{a, b, any_into(a), any_into(b)};
    const bool fits = a != b && point_of(a) != point_of(b) && is_gap(a, op.into_a) && is_gap(b, op.into_b);
    compare(op, fits ? euler(oracle::make_edge(raw_, number(a), number(b))) : Outcomes());
  }

  void weld(Vertex a, Vertex b) {
    const Weld op{a, b, {}, {}};
    const int p = point_of(a), q = point_of(b);
    if (p != q) return compare(op, on_points(oracle::weld(points_, {{std::max(p, q), std::min(p, q)}})));
    if (a == b) return compare(op, {});
    Outcome outcome = oracle::weld(raw_, {{number(b), number(a)}})[0];
    const bool fits = has_gap(raw_, number(a)) && has_gap(raw_, number(b)) && keeps_edges(outcome.after);
    compare(op, fits ? Outcomes{{points_}} : Outcomes());
  }

  // An edge that two copies both have would be one edge where they become one.
  bool keeps_edges(const Complex& complex) const { return oracle::facts_of(complex).edges == facts_.edges; }

  void weld_edges(Halfedge h, Halfedge g) {
    const Weld op{{}, {}, h, g};
    const int p = point_of(mesh_.from(h)), q = point_of(mesh_.to(h)), r = point_of(mesh_.from(g)),
              s = point_of(mesh_.to(g));
    const auto one = sides_between(points_, p, q), other = sides_between(points_, r, s);
    if (one.size() != 1 || other.size() != 1 || std::minmax(p, q) == std::minmax(r, s)) return compare(op, {});
    // The first face runs from..to, the second must run to..from.
    const int from = one[0].second ? p : q, to = one[0].second ? q : p;
    const int second_from = other[0].second ? r : s, second_to = other[0].second ? s : r;
    std::vector<Pair> pairs;
    if (second_to != from) pairs.emplace_back(std::max(second_to, from), std::min(second_to, from));
    if (second_from != to) pairs.emplace_back(std::max(second_from, to), std::min(second_from, to));
    if (second_from == from || second_to == to) return compare(op, {});
    compare(op, on_points(oracle::weld(points_, pairs)));
  }

  void make_face(const MakeFace& op) {
    Corners corners;
    for (Vertex v : op.corners) corners.push_back(point_of(v));
    const std::size_t n = corners.size();
    bool fits = std::set<int>(corners.begin(), corners.end()).size() == n && n >= 3;
    for (std::size_t i = 0; i < n && fits; ++i) {
      const int before = corners[(i + n - 1) % n], at = corners[i], after = corners[(i + 1) % n];
      const auto is_new = [&](int p, int q) { return sides_between(points_, p, q).empty() && !is_wire(points_, p, q); };
      if (!is_new(before, at) || !is_new(at, after)) continue;
      bool room = false;
      for (int v = 0; v < raw_.size(); ++v) room = room || (raw_.live[v] && raw_.point_of[v] == at && has_gap(raw_, v));
      fits = room;
    }
    compare(op, fits ? on_points(oracle::make_face(points_, corners)) : Outcomes());
  }

  void report(const std::string& what) {
    ++count_.disagreements;
    if (++count_.reports[what.substr(0, what.find(' '))] <= max_reports) ADD_FAILURE() << what << "\n  " << name_;
  }

  void compare(const AnyOp& op, const Outcomes& good) {
    const Verdict verdict = check(mesh_, op);
    const std::string id(info_of(op).id), line = command_of(mesh_, op);
    ++count_.verdicts;
    ++(verdict.legal() ? count_.legal : count_.refused)[id];
    for (const Reason& reason : verdict.reasons) ++count_.rules[id][std::string(text_of(reason.rule).id)];
    if (verdict.legal() != !good.empty())
      return report(line + ": the kernel says " +
                    (verdict.legal() ? "legal" : std::string(text_of(verdict.reasons[0].rule).id)));
    if (verdict.legal()) compare_result(op, line, good);
  }

  void compare_result(const AnyOp& op, const std::string& line, const Outcomes& good) {
    const MeshColumns before = mesh_.columns();
    Journal journal;
    try_apply(mesh_, &journal, op);
    if (const auto broken = check_invariants(mesh_)) {
      report(line + ": " + broken->sentence);
    } else {
      const KernelSum sum = kernel_sum(mesh_);
      if (sum.left() != sum.right() || sum.genus < 0) report(line + ": the sum does not hold");
      const Complex found = complex_of(mesh_);
      bool is_one = false;
      for (const Outcome& outcome : good)
        is_one = is_one || compared(with_new_points_in_order(outcome.after, live_points_)) ==
                               compared(with_new_points_in_order(found, live_points_));
      if (!is_one)
        report(line + " gives " + to_text(oracle::on_points(found)) + "\n  not " +
               to_text(oracle::on_points(good[0].after)));
      const ComplexFacts facts = oracle::facts_of(found);
      if (!facts.reads_back && !std::holds_alternative<DeleteLoop>(op))
        report(line + ": reading the result gives other fans: " + to_text(found));
    }
    journal.undo(mesh_);
    if (!(mesh_.columns() == before)) report(line + ": undo is not exact");
  }

  Count& count_;
  Dice dice_;
  Mesh mesh_;
  std::map<Halfedge, Place> places_;
  Complex raw_, separated_, points_;
  ComplexFacts facts_, separated_facts_, points_facts_;
  std::set<int> live_points_;
  std::string name_;
};

TEST(complex_oracle, every_operator_on_random_complexes) {
  Count count;
  const std::uint64_t seeds = test::is_long_run() ? 4000 : 16;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) Comparison(seed, count).all();
  std::cout << count.verdicts << " verdicts, " << count.disagreements << " disagreements\n";
  for (const auto& [id, reports] : count.reports) std::cout << id << ": " << reports << " disagreements\n";
  for (const auto& [id, refused] : count.refused) {
    std::cout << id << ": legal " << count.legal[id] << ", refused " << refused << " for";
    for (const auto& [rule, times] : count.rules[id]) std::cout << " " << rule << " " << times;
    std::cout << "\n";
  }
  for (const auto& [id, legal] : count.legal) EXPECT_GT(legal, 0u) << id;
}

}  // namespace
}  // namespace ryosen
