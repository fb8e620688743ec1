// Answers about a vertex of a form that stores no link from it: a search through the sides of all faces.
#pragma once

#include "ryosen/base/sort_unique.h"
#include "ryosen/textbook/forms/form.h"

namespace ryosen::forms {

// Fills `out`, which is empty, for a relation that asks about a vertex. for_each_side(visit) calls visit(face, ends)
// for every side of every face. O(sides).
template <class ForEachSide>
void answer_by_all_sides(Relation relation, std::uint32_t v, ForEachSide for_each_side, Answer& out) {
  for_each_side([&](std::uint32_t f, EdgeEnds ends) {
    if (ends.a != v && ends.b != v) return;
    if (relation == Relation::vertex_faces)
      out.numbers.push_back(f);
    else if (relation == Relation::vertex_edges)
      out.edges.push_back(ends);
    else
      out.numbers.push_back(ends.a == v ? ends.b : ends.a);
  });
  sort_unique(out.numbers);
  sort_unique(out.edges);
  if (relation == Relation::valence) out.numbers = {static_cast<std::uint32_t>(out.numbers.size())};
}

}  // namespace ryosen::forms
