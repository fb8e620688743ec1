#include "tests/support/core/oracle/orienting.h"

#include <algorithm>
#include <map>

namespace ryosen::oracle {
namespace {

// Of one component.
struct Tally {
  int lowest = 0, faces = 0, turned = 0, patches = 0;
  int misoriented_before = 0, misoriented_after = 0;
  bool orientable = true;
};

std::vector<int> live_numbers(const PolygonList& list) {
  std::vector<int> found;
  for (int v = 0; v < list.size(); ++v)
    if (list.live[v]) found.push_back(v);
  return found;
}

bool is_turned(const Corners& before, Corners after) {
  std::reverse(after.begin() + 1, after.end());
  return before == after;
}

// Each component by a face of it. Lists over the same pairs.
std::map<int, Tally> tally(const PolygonList& before, const PolygonList& after, const Sides& sides, const Sides& now) {
  const int n = static_cast<int>(before.faces.size());
  Groups components(n), patches(n), twofold(2 * n);  // a face as it was, and turned
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    if (sides.count(pair) != 2) continue;
    const int f = sides.begin(pair)[0].face, g = sides.begin(pair)[1].face;
    components.join(f, g);
    if (is_joined(now, pair)) patches.join(f, g);
    const int turn = is_misoriented(sides, pair) ? n : 0;
    twofold.join(f, g + turn);
    twofold.join(f + n, g + n - turn);
  }
  std::map<int, Tally> found;
  for (int f = 0; f < n; ++f) {
    Tally& at = found[components.root(f)];
    if (at.faces++ == 0) at.lowest = f;
    at.turned += before.faces[f] != after.faces[f];
    at.patches += patches.root(f) == f;
    at.orientable = at.orientable && twofold.root(f) != twofold.root(f + n);
  }
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    Tally& at = found[components.root(sides.begin(pair)->face)];
    at.misoriented_before += is_misoriented(sides, pair);
    at.misoriented_after += is_misoriented(now, pair);
  }
  return found;
}

// A face whose turn would leave fewer misoriented pairs, or -1.
int face_against_most(const PolygonList& list, const Sides& sides) {
  for (int f = 0; f < static_cast<int>(list.faces.size()); ++f) {
    int against = 0;
    for (int c = 0; c < static_cast<int>(list.faces[f].size()); ++c) {
      const int pair = sides.pair_of(f, c);
      against += is_misoriented(sides, pair) - is_joined(sides, pair);
    }
    if (against > 0) return f;
  }
  return -1;
}

std::string wrong_component(const Tally& at, const PolygonList& before, const PolygonList& after) {
  const std::string name = "the component of face " + std::to_string(at.lowest) + ": ";
  if (at.orientable && at.misoriented_after > 0) return name + "misoriented though it can be oriented";
  if (at.turned > 0 && at.misoriented_after >= at.misoriented_before) return name + "turned for nothing";
  if (at.misoriented_after > at.misoriented_before) return name + "a longer seam";
  if (2 * at.turned > at.faces) return name + "more faces turned than not";
  if (2 * at.turned == at.faces && before.faces[at.lowest] != after.faces[at.lowest])
    return name + "the lowest of as many faces turned";
  if (at.patches != 1) return name + "patches that would come together by turning";
  return "";
}

}  // namespace

std::string wrong_orienting(const PolygonList& before, const PolygonList& after) {
  if (before.faces.size() != after.faces.size() || live_numbers(before) != live_numbers(after)) return "other elements";
  for (std::size_t f = 0; f < before.faces.size(); ++f)
    if (before.faces[f] != after.faces[f] && !is_turned(before.faces[f], after.faces[f]))
      return "face " + std::to_string(f) + " has other corners";
  const Sides sides(before), now(after);
  for (const auto& [root, at] : tally(before, after, sides, now))
    if (std::string wrong = wrong_component(at, before, after); !wrong.empty()) return wrong;
  if (const int f = face_against_most(after, now); f >= 0)
    return "face " + std::to_string(f) + " would agree with more neighbours if turned";
  return "";
}

}  // namespace ryosen::oracle
