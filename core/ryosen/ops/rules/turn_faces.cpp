#include "ryosen/ops/rules/turn_faces.h"

#include <utility>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/rules/sheets.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

class Turner {
 public:
  Turner(Mesh& mesh, const std::vector<bool>& turned, Descent* descent)
      : m_(mesh), turned_(turned), edit_(mesh, nullptr, descent), sheets_(edit_) {}

  OpEffect turn() {
    cut_apart();
    const std::vector<Vertex> vertices = turned_vertices();
    turn_faces();
    for (Vertex v : vertices) turn_around(v);
    for (Vertex v : vertices) hold_outside(edit_, v);
    sheets_.make_manifold(vertices);
    edit_.commit();
    return sheets_.finish();
  }

 private:
  bool turns(Face f) const { return f && turned_[f.index]; }

  // Cuts so that at every vertex either all faces are flipped or none.
  void cut_apart() {
    const std::uint32_t edges = m_.edge_slots(), vertices = m_.vertex_slots();
    for (std::uint32_t i = 0; i < edges; ++i) {
      const Halfedge h = halfedge(Edge(i));
      if (!m_.is_alive(h) || m_.is_outside(h) || m_.is_outside(twin(h))) continue;
      if (turns(m_.face(h)) != turns(m_.face(twin(h)))) sheets_.open(h);
    }
    for (std::uint32_t i = 0; i < vertices; ++i) {
      if (!m_.is_alive(Vertex(i)) || !m_.is_boundary(Vertex(i))) continue;
      const std::vector<Fan> fans = fans_at(m_, Vertex(i));
      for (const Fan& fan : fans)
        if (turns(fan.lowest_face) != turns(fans[0].lowest_face)) sheets_.take_out(fan);
    }
  }

  std::vector<Vertex> turned_vertices() const {
    std::vector<Vertex> found;
    for (const Vertex v : live_vertices(m_))
      for (Face f : faces_around(m_, v)) {
        if (!turns(f)) continue;
        found.push_back(v);
        break;
      }
    return found;
  }

  //      a --h--> b              the corner at a is that of h before, and of the other half of prev(h) afterwards
  //      ^        |
  //      +--prev--+
  void turn_faces() {
    std::vector<std::pair<Halfedge, Face>> sides;
    std::vector<std::pair<Halfedge, Halfedge>> corners;  // of that side, and of the one before
    std::vector<std::pair<std::uint32_t, Halfedge>> rings;
    for (const Face f : live_faces(m_)) {
      if (!turns(f)) continue;
      sheets_.changed(f);
      for (Halfedge h : halfedges_around(m_, f)) {
        sides.emplace_back(twin(m_.prev(h)), f);
        corners.emplace_back(sides.back().first, h);
      }
      for (std::uint32_t r = m_.first_ring(f); r != no_index; r = m_.ring(r).next)
        rings.emplace_back(r, twin(m_.prev(m_.ring(r).halfedge)));
      edit_.set_halfedge(f, twin(m_.prev(m_.halfedge(f))));
    }
    for (const auto& [h, f] : sides) edit_.set_face(twin(h), Face());
    for (const auto& [h, f] : sides) edit_.set_face(h, f);
    edit_.move_corners(corners);
    for (const auto& [r, h] : rings) edit_.set_ring_halfedge(r, h);
  }

  // Reverses the cyclic order of the outgoing halfedges.
  void turn_around(Vertex v) {
    std::vector<Halfedge> around;
    for (Halfedge h : outgoing(m_, v)) around.push_back(h);
    for (std::size_t i = 0; i < around.size(); ++i) edit_.connect(twin(around[i]), around[(i + 1) % around.size()]);
  }

  const Mesh& m_;
  const std::vector<bool>& turned_;
  Edit edit_;
  Sheets sheets_;
};

}  // namespace

TurnedMesh turn_faces(const Mesh& mesh, const std::vector<bool>& turned, Descent* descent) {
  Mesh copy = mesh;
  OpEffect effect = Turner(copy, turned, descent).turn();
  return {std::move(copy).columns(), std::move(effect)};
}

}  // namespace ryosen
