#include "ryosen/algo/repair/new_crossings.h"

#include <algorithm>

#include "ryosen/analysis/self_intersections.h"
#include "ryosen/base/count_text.h"

namespace ryosen {

namespace {

// More pairs are of no use to anyone.
constexpr std::size_t most_pairs = 1000000;

}  // namespace

void add_new_crossings(const Mesh& before, const Mesh& after, AlgorithmResult& result) {
  const SelfIntersections old = find_self_intersections(before, most_pairs);
  SelfIntersections now = find_self_intersections(after, most_pairs);
  std::size_t added = now.count - std::min(now.count, old.count);
  const bool is_exact = now.is_all() && old.is_all();
  if (is_exact)
    added = std::erase_if(
        now.pairs, [&](const FacePair& pair) { return !std::binary_search(old.pairs.begin(), old.pairs.end(), pair); });
  result.crossings = added;
  if (added == 0) return;
  result.text =
      result.text +
      (is_exact ? count_text(added, " One pair of faces meets now that did not.",
                             " # pairs of faces meet now that did not.", "新たに交わる面が # 組あります。")
                : count_text(added, " At least one more pair of faces meets now.",
                             " At least # more pairs of faces meet now.", "交わる面が少なくとも # 組増えました。"));
}

}  // namespace ryosen
