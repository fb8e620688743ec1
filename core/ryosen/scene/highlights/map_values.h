// The values of a colour map, one per slot of its sort of element, and what is said of them together.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ryosen/mesh/journal.h"
#include "ryosen/scene/highlights/colour_maps.h"

namespace ryosen {

class MapValues {
 public:
  // Asks about every element. O(corners); on several threads where that pays. 0 chooses.
  // `other`: what a map of distances measures from; without it such a map has no values.
  MapValues(const Mesh& mesh, const ColourMap& map, unsigned threads = 0,
            std::shared_ptr<const OtherSurface> other = nullptr);

  const ColourMap& map() const { return *map_; }
  const OtherSurface* other() const { return other_.get(); }
  // By slot; NaN where there is none, also of dead elements.
  std::span<const double> all() const { return values_; }
  double of(std::uint32_t slot) const { return slot < values_.size() ? values_[slot] : missing; }

  // After transaction i of the journal was committed, undone or redone: asks what it reached. The elements whose value
  // is another now, in ascending order; none where everything was asked anew.
  std::optional<std::vector<std::uint32_t>> update(const Mesh& mesh, const Journal& journal, std::size_t i);

 private:
  static const double missing;
  const ColourMap* map_;
  std::shared_ptr<const OtherSurface> other_;
  bool had_copies_ = false;
  int attribute_ = -1;  // of the mesh, whose numbers these are
  std::vector<double> values_;
};

// Of those values that are finite; all 0 where there are none.
struct MapFigures {
  std::size_t count = 0;
  double lowest = 0, highest = 0, mean = 0, deviation = 0;  // the last: the root of the mean square from the mean
  double percentile_5 = 0, quartile_1 = 0, median = 0, quartile_3 = 0, percentile_95 = 0;  // between neighbours linear
  std::uint32_t lowest_at = no_index, highest_at = no_index;  // the first slots that have them
};
MapFigures figures_of(std::span<const double> values);

// The lowest and the highest of those values that are finite; none where there are none.
std::optional<MapRange> extent_of(std::span<const double> values);
// What a map shows first: the middle nine tenths of the values, so that a few far ones do not make all others look
// alike, and as far on both sides of the middle where the map has one, unless it counts: then values may not exist
// there. Up to the ends where these are near, and all of them where those are equal.
MapRange first_range(const ColourMap& map, const MapFigures& figures);
// The range that shows all values, likewise.
MapRange whole_range(const ColourMap& map, const MapFigures& figures);

// How many finite values lie in each of `bars` parts of a range that are equally wide; the last one with its end. What
// lies outside counts nowhere, or in the first and the last one.
enum class Outside : std::uint8_t { left_out, at_the_ends };
std::vector<std::uint32_t> histogram(std::span<const double> values, MapRange range, std::size_t bars,
                                     Outside outside = Outside::left_out);

}  // namespace ryosen
