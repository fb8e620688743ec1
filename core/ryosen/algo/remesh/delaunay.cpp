#include <deque>

#include "ryosen/algo/preparation.h"
#include "ryosen/algo/remesh/features.h"
#include "ryosen/algo/remesh/remesh.h"
#include "ryosen/algo/seams/flat_normals.h"
#include "ryosen/algo/unit_scale.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/swap_edge.h"

namespace ryosen::remesh {

namespace {

// The four points of an edge and its triangles: (a b c) and (b a d).
struct Kite {
  glm::dvec3 a, b, c, d;
};

double cotangents(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
  return cotangent_at(p, q, r) + cotangent_at(q, r, p) + cotangent_at(r, p, q);
}

bool is_delaunay(const Kite& k) {
  const double sum = cotangent_at(k.c, k.a, k.b) + cotangent_at(k.d, k.b, k.a);
  return sum >= -1e-9;
}

bool becomes_less(const Kite& k) {
  const double before = cotangents(k.a, k.b, k.c) + cotangents(k.b, k.a, k.d);
  const double after = cotangents(k.c, k.d, k.b) + cotangents(k.d, k.c, k.a);
  return after < before - 1e-9 * std::abs(before);
}

class DelaunaySwapper {
 public:
  DelaunaySwapper(Edit& edit, double scale, const SwapOptions& options, Descent* descent)
      : edit_(edit),
        mesh_(edit.mesh()),
        scale_(scale),
        features_(find_features(mesh_, options.most_turn_rad, options.seams)),
        descent_(descent) {}

  // False: cancelled.
  bool run(Progress& progress, Swapped& result) {
    std::deque<Edge> waiting;
    std::vector<std::uint8_t> waits(mesh_.edge_slots(), 0);
    const auto add = [&](Edge e) {
      if (waits[e.index] || !mesh_.is_alive(e) || features_.edges[e.index]) return;
      waits[e.index] = 1;
      waiting.push_back(e);
    };
    for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i) add(Edge(i));
    for (std::size_t step = 0; !waiting.empty(); ++step) {
      if (step % 1024 == 0 && !progress.go_on()) return false;
      const Edge e = waiting.front();
      waiting.pop_front();
      waits[e.index] = 0;
      const Halfedge h = halfedge(e);
      if (!wants_swap(h)) continue;
      const SwapEdge swap{h};
      if (!swap.is_legal(mesh_)) continue;
      swap.apply(edit_);
      ++result.swaps;
      if (descent_) descent_->lose(e);
      for (const Halfedge side : {h, twin(h)})
        for (const Halfedge around : {mesh_.next(side), mesh_.prev(side)}) add(edge(around));
    }
    for (const Edge e : live_edges(mesh_)) {
      const std::uint8_t kind = features_.edges[e.index];
      if (kind == Features::held || is_delaunay(kite(halfedge(e)))) continue;
      if (kind == Features::seam)
        result.held_by_seams.push_back(e);
      else
        ++result.refused;
    }
    return true;
  }

 private:
  glm::dvec3 place(Vertex v) const { return scale_ * mesh_.position(v); }
  Kite kite(Halfedge h) const {
    return {place(mesh_.from(h)), place(mesh_.to(h)), place(mesh_.from(mesh_.prev(h))),
            place(mesh_.from(mesh_.prev(twin(h))))};
  }
  bool wants_swap(Halfedge h) const {
    const Kite k = kite(h);
    if (is_delaunay(k) || !becomes_less(k)) return false;
    const glm::dvec3 left = area_normal({k.a, k.b, k.c}), right = area_normal({k.b, k.a, k.d});
    for (const glm::dvec3& after : {area_normal({k.c, k.d, k.b}), area_normal({k.d, k.c, k.a})})
      if (!keeps_facing(left, after, 0.5) || !keeps_facing(right, after, 0.5)) return false;
    return true;
  }

  Edit& edit_;
  const Mesh& mesh_;
  double scale_;
  Features features_;
  Descent* descent_;
};

}  // namespace

Swapped delaunay_swapped(const Mesh& mesh, const SwapOptions& options, Progress& progress, Descent* descent) {
  Swapped result;
  result.is_cancelled = !progress.go_on(0, 1);
  if (result.is_cancelled) return result;
  Mesh work = mesh;
  const std::vector<std::uint8_t> flat = prepare_seams(work, options.seams);
  Descent own_descent;
  if (!flat.empty() && !(descent && descent->is_recording())) descent = &(own_descent = Descent(mesh));
  Edit edit(work, nullptr, descent);
  const std::vector<Face> polygons = polygons_of_mesh(work);
  result.cut_faces = polygons.size();
  if ((result.fault = cut_faces(edit, polygons))) return result;
  DelaunaySwapper swapper(edit, unit_scale(mesh.positions()), options, descent);
  result.is_cancelled = !swapper.run(progress, result);
  edit.commit();
  if (result.is_cancelled) return result;
  if (!flat.empty()) put_flat_normals(work, flags_of_parts(flat, work, *descent), mesh);
  result.columns = std::move(work).columns();
  return result;
}

}  // namespace ryosen::remesh
