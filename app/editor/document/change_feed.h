// The changes of a mesh that is shown, for any number of views, each at its own pace. A document has one feed, in its
// findings; only the thread of the frames writes and reads it.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/base/recent_cells.h"
#include "ryosen/scene/highlights/highlight_sets.h"

namespace ryosen {

class ChangeFeed {
 public:
  // An element that entered or left a highlight set, or moved while in it.
  using Marked = HighlightSets::Change;

  // Where a reader stands; at first it has seen nothing.
  struct Cursor {
    std::uint64_t document = 0, clock = 0;
  };
  // With `everything` the lists are empty: rebuild all. Entries may be repeated, dead or past the end.
  struct Changes {
    bool everything = false;
    std::vector<std::uint32_t> vertices;  // created or moved
    std::vector<std::uint32_t> faces;     // with changed corners or changed tinting highlights
    std::vector<Marked> marks;
    std::vector<TouchedElements::Value> values;  // of attributes: written, or of elements that were created
    bool all_values = false;                     // more of these than are listed may be others now
    bool searched = false;                       // for a highlight: take all marks and tints anew
    bool hiding = false;                         // something was hidden or shown: it is in the lists
    Cursor now;                                  // for the next call
  };
  // Since the cursor was given out; everything where that is another document's, or where more has changed than is
  // kept. O(answer).
  Changes since(const Cursor& cursor) const;

  // For the session, which notes edits, undo, trials, steps of gestures, hiding and findings.
  void begin(std::uint64_t document);  // everything
  void note_everything() { cells_.forget(); }
  void note_vertex(std::uint32_t index) { cells_.add({Sort::vertex, {}, index}); }
  void note_face(std::uint32_t index) { cells_.add({Sort::face, {}, index}); }
  void note_value(const TouchedElements::Value& value) { cells_.add({Sort::value, {}, value.index, value.attribute}); }
  void note_all_values() { cells_.add({Sort::value, {}, no_index}); }
  // A face that is marked looks otherwise, too.
  void note_mark(const Marked& marked);
  void note_search() { cells_.add({Sort::search, {}, 0}); }
  void note_hiding() { cells_.add({Sort::hiding, {}, 0}); }

 private:
  enum class Sort : std::uint8_t { vertex, face, mark, value, search, hiding };
  struct Cell {
    Sort sort;
    Mark mark;
    std::uint32_t index;
    std::uint32_t attribute = 0;
  };

  RecentCells<Cell> cells_;
  std::uint64_t document_ = 0;
};

}  // namespace ryosen
