// This program's Mesh as a row of the comparison; the only form that answers through the mesh's circulators.
#pragma once

#include "ryosen/textbook/forms/form.h"

namespace ryosen::forms {

// Represents any mesh. Answers refer to points: the union over the copies of a point. The handle of an edge is one of
// the halfedges between its points.
class Kernel : public Form {
 public:
  explicit Kernel(const Mesh& mesh);

  std::size_t bytes() const override { return mesh_.core_bytes(); }
  Mesh to_mesh() const override { return mesh_; }
  std::uint32_t find_edge(std::uint32_t a, std::uint32_t b) const override;
  bool answer(Relation relation, std::uint32_t element, Answer& out) const override;
  Fields record(Element own) const override;

 private:
  std::uint32_t point_of(Vertex v) const { return points_.empty() ? v.index : points_[v.index]; }
  Vertex vertex_of(std::uint32_t point) const { return vertices_.empty() ? Vertex(point) : Vertex(vertices_[point]); }
  EdgeEnds ends_of(Halfedge h) const { return edge_ends(point_of(mesh_.from(h)), point_of(mesh_.to(h))); }
  void add_neighbours(std::uint32_t point, std::vector<std::uint32_t>& out) const;
  void add_faces_beside(Halfedge h, std::vector<std::uint32_t>& out) const;
  void answer_about_vertex(Relation relation, std::uint32_t point, Answer& out) const;
  void answer_about_edge(Relation relation, Halfedge h, Answer& out) const;
  void answer_about_face(Relation relation, Face f, Answer& out) const;

  Mesh mesh_;
  std::vector<std::uint32_t> points_, vertices_;  // empty if every vertex is a point
};

}  // namespace ryosen::forms
