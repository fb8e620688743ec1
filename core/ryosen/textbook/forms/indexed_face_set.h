// Table 2 of the source texts: coordinates once per vertex, and per face the numbers of its corners.
#pragma once

#include "ryosen/textbook/forms/form.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

// All relations except those of a face need a linear search of all faces: O(n) per query. It stores points, not copies,
// so it also represents non-manifold edges. The handle of an edge is its first corner in the list.
class IndexedFaceSet : public Form {
 public:
  explicit IndexedFaceSet(const Mesh& mesh);

  std::size_t bytes() const override;
  Mesh to_mesh() const override;
  std::uint32_t find_edge(std::uint32_t a, std::uint32_t b) const override;
  bool answer(Relation relation, std::uint32_t element, Answer& out) const override;
  Fields record(Element own) const override;

 private:
  template <class Visit>
  void for_each_side(Visit visit) const;  // visit(face, corner, ends)
  EdgeEnds ends_of_corner(std::uint32_t corner) const;
  void answer_about_vertex(Relation relation, std::uint32_t v, Answer& out) const;
  void answer_about_edge(Relation relation, std::uint32_t corner, Answer& out) const;
  void answer_about_face(Relation relation, std::uint32_t f, Answer& out) const;

  Polygons list_;
};

}  // namespace ryosen::forms
