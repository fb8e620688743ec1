#include "tests/support/core/oracle/complex_rules.h"

#include <algorithm>

#include "tests/support/core/oracle/exchange.h"

namespace ryosen::oracle {
namespace {

ComplexFacts read_as(ComplexFacts facts, const std::vector<Pair>& pairs) {
  const auto exchange = [&](int& v) {
    for (const auto& [gone, stays] : pairs)
      if (v == gone) v = stays;
  };
  for (auto& [fault, a, b] : facts.faults) {
    if (fault != Fault::directed_edge_twice && fault != Fault::several_fans && fault != Fault::pair_twice) continue;
    exchange(a);
    exchange(b);
  }
  std::sort(facts.faults.begin(), facts.faults.end());
  exchange_points(facts.nonmanifold, facts.misoriented, exchange);
  return facts;
}

bool has_new_fault(const ComplexFacts& before, const ComplexFacts& after, bool fans_count) {
  for (const auto& fault : after.faults) {
    if (!fans_count && std::get<0>(fault) == Fault::several_fans) continue;
    if (!std::binary_search(before.faults.begin(), before.faults.end(), fault)) return true;
  }
  return false;
}

bool is_same_on_points(const ComplexFacts& before, const ComplexFacts& after) {
  return after.loops_on_points && after.reads_back && after.nonmanifold == before.nonmanifold &&
         after.misoriented == before.misoriented && after.equal_faces == before.equal_faces &&
         std::includes(before.doubled_wires.begin(), before.doubled_wires.end(), after.doubled_wires.begin(),
                       after.doubled_wires.end());
}

}  // namespace

bool is_legal_local(const ComplexFacts& facts, const Outcome& outcome) {
  const ComplexFacts before = read_as(facts, outcome.read_as);
  const ComplexFacts after = facts_of(outcome.after);
  if (has_new_fault(before, after, true) || !is_same_on_points(before, after) || after.groups != before.groups)
    return false;
  const auto euler = [](const ComplexFacts& f) { return f.vertices - f.edges + f.faces - f.rings; };
  return after.vertices - before.vertices == outcome.vertices && euler(after) == euler(before) &&
         after.rings == before.rings && after.boundary_loops == before.boundary_loops &&
         after.components == before.components && after.isolated == before.isolated;
}

bool is_legal_euler(const ComplexFacts& facts, const Outcome& outcome) {
  const ComplexFacts before = read_as(facts, outcome.read_as);
  const ComplexFacts after = facts_of(outcome.after);
  if (has_new_fault(before, after, false) || !is_same_on_points(before, after)) return false;
  return after.vertices - before.vertices == outcome.vertices && after.edges - before.edges == outcome.edges &&
         after.faces - before.faces == outcome.faces && after.rings - before.rings == outcome.rings;
}

bool is_legal_on_points(const ComplexFacts& facts, const Outcome& outcome) {
  const ComplexFacts before = read_as(facts, outcome.read_as), after = facts_of(outcome.after);
  if (has_new_fault(before, after, false)) return false;
  return after.loops_on_points && after.nonmanifold == before.nonmanifold && after.misoriented == before.misoriented &&
         after.equal_faces == before.equal_faces;
}

}  // namespace ryosen::oracle
