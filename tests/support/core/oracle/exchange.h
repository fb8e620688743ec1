// Facts about edges on points after some points got other numbers.
#pragma once

#include <algorithm>
#include <utility>

namespace ryosen::oracle {

// Renumbers the ends of the edges by `exchange(int&)` and puts everything in order again.
template <class Nonmanifold, class Misoriented, class Exchange>
void exchange_points(Nonmanifold& nonmanifold, Misoriented& misoriented, Exchange exchange) {
  const auto renumber = [&](int& lo, int& hi) {
    exchange(lo);
    exchange(hi);
    if (lo > hi) std::swap(lo, hi);
  };
  for (auto& [lo, hi, count] : nonmanifold) renumber(lo, hi);
  for (auto& [lo, hi] : misoriented) renumber(lo, hi);
  std::sort(nonmanifold.begin(), nonmanifold.end());
  std::sort(misoriented.begin(), misoriented.end());
}

}  // namespace ryosen::oracle
