// Table 3 of the source texts: a vertex stores one of its faces, a face its vertices and the faces across its sides.
#pragma once

#include "ryosen/textbook/forms/form.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

// The neighbours of a face are in the order of its sides, none at a boundary, so the faces at a vertex are found by
// walking from one to the next. The handle of an edge is a corner of the list whose side it is.
class FaceAdjacency : public Form {
 public:
  explicit FaceAdjacency(const Mesh& mesh);

  std::size_t bytes() const override;
  Mesh to_mesh() const override;
  std::uint32_t find_edge(std::uint32_t a, std::uint32_t b) const override;
  bool answer(Relation relation, std::uint32_t element, Answer& out) const override;
  Fields record(Element own) const override;

 private:
  struct Place {
    std::uint32_t face = no_index, corner = no_index;
  };
  std::uint32_t next_corner(Place at) const;
  std::uint32_t previous_corner(Place at) const;
  Place place_of(std::uint32_t face, std::uint32_t v) const;
  std::uint32_t face_of(std::uint32_t corner) const;
  EdgeEnds ends_of(Place side) const;
  // visit(place) for the corner of every face at v.
  template <class Visit>
  void for_each_face_at(std::uint32_t v, Visit visit) const;
  template <class Visit>
  void for_each_neighbour(std::uint32_t v, Visit visit) const;
  void answer_about_vertex(Relation relation, std::uint32_t v, Answer& out) const;
  void answer_about_edge(Relation relation, std::uint32_t corner, Answer& out) const;
  void answer_about_face(Relation relation, std::uint32_t f, Answer& out) const;

  Polygons list_;
  std::vector<std::uint32_t> vertex_face_;
  std::vector<std::uint32_t> face_across_;  // per corner
};

}  // namespace ryosen::forms
