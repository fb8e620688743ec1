// The nine relations, and the valence, asked of the records of a form by what its text stores: by a search through all
// faces, or a walk along the links. The reader counts the records that this reads.
#pragma once

#include "ryosen/textbook/forms/reading/record_reader.h"

namespace ryosen::forms {

// What is asked: a relation of an element; of an edge also its ends, by their points.
struct Asked {
  const RelationRow& row;
  Element element;
  EdgeEnds ends;
};
Asked asked_about(const Mesh& mesh, const RelationRow& row, Element element);

// In slots of the mesh, points by their first copy; lists that have no order come sorted. False where the form stores
// no vertices, places alone: then it tells nothing. The form must be suitable.
bool answer_by_records(RecordReader& reader, const Asked& asked, Answer& out);

}  // namespace ryosen::forms
