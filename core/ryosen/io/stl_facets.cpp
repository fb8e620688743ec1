#include "ryosen/io/stl_facets.h"

#include <array>
#include <atomic>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/parallel.h"

namespace ryosen {
namespace {

class FacetWelder {
 public:
  FacetWelder(const StlFacets& facets, unsigned threads, std::vector<std::uint32_t>& corners)
      : facets_(facets), threads_(threads), hashes_(facets.corners()), corners_(corners) {
    reserve_large(corners_, facets.corners());
    corners_.resize(facets.corners());
  }

  StlFacetFindings weld(std::vector<glm::dvec3>& positions) {
    find_hashes();
    for_each_task(threads_, threads_, [&](unsigned share) { find_firsts(share); });
    number_places(positions);
    return findings_;
  }

 private:
  void find_hashes() {
    std::atomic<bool> all_finite = true, has_attributes = false;
    for_each_part(facets_.count(), threads_, [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      float nothing = 0;  // stays zero while all are finite
      unsigned attributes = 0;
      for (std::uint32_t facet = begin; facet < end; ++facet) {
        for (std::uint32_t c = 3 * facet; c < 3 * facet + 3; ++c) {
          const glm::vec3 p = facets_.place(c);
          nothing += p.x * 0.0f + p.y * 0.0f + p.z * 0.0f;
          hashes_[c] = hash_of_place(p);
        }
        attributes |= facets_.attribute(facet);
      }
      if (!(nothing == 0.0f)) all_finite = false;
      if (attributes != 0) has_attributes = true;
    });
    findings_ = {all_finite, has_attributes};
  }

  // Maps the corners of a share to the first one at their position.
  void find_firsts(unsigned share) {
    PlaceTable table(facets_.corners() / threads_);
    std::array<std::uint32_t, 64> batch;
    std::size_t count = 0;
    const auto do_batch = [&] {
      for (std::size_t i = 0; i < count; ++i) table.prefetch(hashes_[batch[i]]);
      for (std::size_t i = 0; i < count; ++i) corners_[batch[i]] = first_at_place_of(batch[i], table);
      count = 0;
    };
    for (std::uint32_t c = 0; c < facets_.corners(); ++c) {
      batch[count] = c;
      count += std::uint64_t{hashes_[c]} * threads_ >> 32 == share;
      if (count == batch.size()) do_batch();
    }
    do_batch();
  }

  std::uint32_t first_at_place_of(std::uint32_t c, PlaceTable& table) const {
    const glm::vec3 place = facets_.place(c);
    if (place != place) return c;  // NaN equals nothing
    return table.first(hashes_[c], c, [&](std::uint32_t first) { return facets_.place(first) == place; });
  }

  // Numbers the first corners in order, reusing the memory of their hashes.
  void number_places(std::vector<glm::dvec3>& positions) {
    std::vector<std::uint32_t> begins(threads_ + 1, 0);
    for_each_part(facets_.corners(), threads_, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
      std::uint32_t count = 0;
      for (std::uint32_t c = begin; c < end; ++c) count += corners_[c] == c;
      begins[t + 1] = count;
    });
    for (unsigned t = 0; t < threads_; ++t) begins[t + 1] += begins[t];
    reserve_large(positions, begins[threads_]);
    positions.resize(begins[threads_]);
    for_each_part(facets_.corners(), threads_, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
      std::uint32_t number = begins[t];
      for (std::uint32_t c = begin; c < end; ++c) {
        if (corners_[c] != c) continue;
        positions[number] = glm::dvec3(facets_.place(c));
        hashes_[c] = number++;
      }
    });
    for_each_part(facets_.corners(), threads_, [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t c = begin; c < end; ++c) corners_[c] = hashes_[corners_[c]];
    });
  }

  const StlFacets& facets_;
  const unsigned threads_;
  UnwrittenVector<std::uint32_t> hashes_;
  std::vector<std::uint32_t>& corners_;  // holds first corners during the search
  StlFacetFindings findings_;
};

}  // namespace

StlFacetFindings weld_facets(const StlFacets& facets, unsigned threads, std::vector<glm::dvec3>& positions,
                             std::vector<std::uint32_t>& corners) {
  return FacetWelder(facets, threads, corners).weld(positions);
}

}  // namespace ryosen
