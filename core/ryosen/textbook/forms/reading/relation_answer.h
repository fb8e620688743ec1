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

// What it does for the kinds of forms.
void answer_by_search(RecordReader& reader, const Asked& asked, Answer& out);
void answer_by_faces(RecordReader& reader, const Asked& asked, Answer& out);
void answer_by_wings(RecordReader& reader, const Asked& asked, Answer& out);
void answer_by_links(RecordReader& reader, const Asked& asked, Answer& out);

// The halfedge by which a form with halfedges reaches an edge: what the edge's record says, else the one that it
// numbers.
std::uint32_t side_of_edge(RecordReader& reader, Edge e);

}  // namespace ryosen::forms
