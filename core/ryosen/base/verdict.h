// Whether an operation is legal, and if not, which rules it breaks and which elements are in the way.
#pragma once

#include <algorithm>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/base/reasons.h"

namespace ryosen {

struct Reason {
  Rule rule;
  std::vector<Element> witnesses;

  friend bool operator==(const Reason&, const Reason&) = default;
};

// Empty means legal. Holds every broken rule, each with its witnesses, in a fixed order.
struct Verdict {
  std::vector<Reason> reasons;

  bool legal() const { return reasons.empty(); }
  void refuse(Rule rule, std::initializer_list<Element> witnesses) { reasons.push_back({rule, witnesses}); }
  bool has(Rule rule) const {
    return std::any_of(reasons.begin(), reasons.end(), [&](const Reason& r) { return r.rule == rule; });
  }
};

// The verdict that one broken rule gives alone.
inline Verdict refused_by(Rule rule, std::initializer_list<Element> witnesses) { return {{{rule, witnesses}}}; }

}  // namespace ryosen
