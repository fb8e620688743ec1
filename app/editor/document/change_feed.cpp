#include "app/editor/document/change_feed.h"

namespace ryosen {

ChangeFeed::Changes ChangeFeed::since(const Cursor& cursor) const {
  Changes changes;
  changes.now = {document_, cells_.clock()};
  if (cursor.document != document_ || !cells_.has_all_since(cursor.clock)) {
    changes.everything = changes.searched = changes.hiding = true;
    return changes;
  }
  cells_.for_each_since(cursor.clock, [&](const Cell& cell) {
    switch (cell.sort) {
      case Sort::vertex:
        changes.vertices.push_back(cell.index);
        break;
      case Sort::face:
        changes.faces.push_back(cell.index);
        break;
      case Sort::mark:
        changes.marks.push_back({cell.mark, cell.index});
        break;
      case Sort::search:
        changes.searched = true;
        break;
      case Sort::hiding:
        changes.hiding = true;
        break;
    }
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
