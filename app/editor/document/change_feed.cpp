#include "app/editor/document/change_feed.h"

namespace ryosen {

ChangeFeed::Changes ChangeFeed::since(const Cursor& cursor) const {
  Changes changes;
  changes.now = {document_, cells_.clock()};
  if (cursor.document != document_ || !cells_.has_all_since(cursor.clock)) {
    changes.everything = changes.all_values = changes.searched = changes.hiding = true;
    return changes;
  }
  cells_.for_each_since(cursor.clock, [&](const Cell& cell) {
    if (cell.sort == Sort::vertex) changes.vertices.push_back(cell.index);
    if (cell.sort == Sort::face) changes.faces.push_back(cell.index);
    if (cell.sort == Sort::mark) changes.marks.push_back({cell.mark, cell.index});
    if (cell.sort == Sort::value && cell.index == no_index) changes.all_values = true;
    if (cell.sort == Sort::value && cell.index != no_index) changes.values.push_back({cell.attribute, cell.index});
    changes.searched |= cell.sort == Sort::search;
    changes.hiding |= cell.sort == Sort::hiding;
  });
  return changes;
}

void ChangeFeed::begin(std::uint64_t document) {
  document_ = document;
  cells_.forget();
}

void ChangeFeed::note_mark(const Marked& marked) {
  if (marked.mark.sort == Element::Kind::face) note_face(marked.index);
  cells_.add({Sort::mark, marked.mark, marked.index});
}

}  // namespace ryosen
