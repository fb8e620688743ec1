// Table 4 of the source texts: all links are stored in the edges.
//
//    left_next \ / right_prev    an edge runs from start to end; seen along it, one face is left, one right; "next" and
//               o end            "prev" follow the loop of that face, counter-clockwise: left_next leaves end and
//               ^                right_prev comes to it, right_next leaves start and left_prev comes to it
//          left | right
//               |
//               o start
//    left_prev / \ right_next
#pragma once

#include <glm/vec3.hpp>

#include "ryosen/textbook/forms/form.h"

namespace ryosen::forms {

// At a boundary the face and its two wings are none. A face starts at its stored edge. The handle of an edge is its
// number.
class WingedEdge : public Form {
 public:
  explicit WingedEdge(const Mesh& mesh);

  std::size_t bytes() const override;
  Mesh to_mesh() const override;
  std::uint32_t find_edge(std::uint32_t a, std::uint32_t b) const override;
  bool answer(Relation relation, std::uint32_t element, Answer& out) const override;
  Fields record(Element own) const override;

 private:
  struct EdgeRecord {
    std::uint32_t start, end;
    std::uint32_t left, right;
    std::uint32_t left_next, left_prev, right_next, right_prev;
  };
  EdgeEnds ends_of(std::uint32_t e) const { return edge_ends(edges_[e].start, edges_[e].end); }
  std::uint32_t other_end(std::uint32_t e, std::uint32_t v) const {
    return edges_[e].start == v ? edges_[e].end : edges_[e].start;
  }
  // visit(edge) for every edge at v.
  template <class Visit>
  void for_each_edge_at(std::uint32_t v, Visit visit) const;
  // visit(edge, is_left) along the loop of a face.
  template <class Visit>
  void for_each_edge_of(std::uint32_t f, Visit visit) const;
  void answer_about_vertex(Relation relation, std::uint32_t v, Answer& out) const;
  void answer_about_edge(Relation relation, std::uint32_t e, Answer& out) const;
  void answer_about_face(Relation relation, std::uint32_t f, Answer& out) const;

  std::vector<glm::dvec3> positions_;
  std::vector<std::uint32_t> vertex_edge_;
  std::vector<EdgeRecord> edges_;
  std::vector<std::uint32_t> face_edge_;
};

}  // namespace ryosen::forms
