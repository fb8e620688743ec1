#include "ryosen/algo/remesh/planar_regions.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>

#include "ryosen/algo/features.h"
#include "ryosen/algo/repair/sound_changes.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/trees/primitive.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/rules/surgery.h"
#include "ryosen/ops/unite_series.h"

namespace ryosen::remesh {

namespace {

// The first loop is the outer one.
struct Border {
  std::vector<std::vector<Halfedge>> loops;
  bool is_simple = true;  // no point is on it twice, each loop has three corners, and the region has no handle
};

class RegionUniter {
 public:
  RegionUniter(Edit& edit, const PlanarOptions& options)
      : edit_(edit),
        mesh_(edit.mesh()),
        options_(options),
        region_(mesh_.face_slots(), no_index),
        normals_(mesh_.face_slots(), glm::dvec3(0)),
        areas_(mesh_.face_slots(), 0) {
    for (const Face f : live_faces(mesh_)) {
      const FacePolygon polygon(mesh_, f);
      if (!polygon.is_finite()) continue;
      const std::vector<glm::dvec3> walk = polygon.keyhole_walk();
      normals_[f.index] = polygon_normal(walk);
      areas_[f.index] = polygon_area(walk);
    }
  }

  United run(Progress& progress) {
    std::vector<std::uint32_t> order(mesh_.face_slots());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return areas_[a] > areas_[b]; });
    United result;
    std::size_t done = 0;
    for (const std::uint32_t i : order) {
      if (done++ % 256 == 0 && !progress.go_on(done, order.size())) {
        result.is_cancelled = true;
        return result;
      }
      if (!mesh_.is_alive(Face(i)) || region_[i] != no_index || !has_normal(Face(i))) continue;
      const std::vector<Face> faces = grow(Face(i));
      if (faces.size() < 2) continue;
      const Border border = border_of(faces, i);
      if (border.loops.empty() || !border.is_simple) {
        result.left.push_back(Face(i));
        continue;
      }
      unite(faces, border, i);
      ++result.regions;
      result.faces += faces.size();
    }
    return result;
  }

 private:
  bool has_normal(Face f) const { return glm::dot(normals_[f.index], normals_[f.index]) > 0.5; }

  bool fits(Face f, const glm::dvec3& normal, const glm::dvec3& origin) const {
    if (!has_normal(f) || glm::dot(normals_[f.index], normal) < std::cos(options_.angle_rad)) return false;
    for (const Vertex v : vertices_around(mesh_, f))
      if (!(std::abs(glm::dot(normal, mesh_.position(v) - origin)) <= options_.distance)) return false;
    return true;
  }

  std::vector<Face> grow(Face seed) {
    const glm::dvec3 normal = normals_[seed.index], origin = mesh_.position(mesh_.from(mesh_.halfedge(seed)));
    std::vector<Face> faces{seed};
    region_[seed.index] = seed.index;
    for (std::size_t k = 0; k < faces.size(); ++k)
      for (const Halfedge h : halfedges_around(mesh_, faces[k])) {
        const Face other = mesh_.face(twin(h));
        if (!other || region_[other.index] != no_index || is_cut_on_points(mesh_, h)) continue;
        if (face_values_differ(mesh_, seed, other) || corner_values_differ(mesh_, h, twin(h), false)) continue;
        if (!fits(other, normal, origin)) continue;
        region_[other.index] = seed.index;
        faces.push_back(other);
      }
    return faces;
  }

  bool is_inside(Halfedge h, std::uint32_t region) const {
    const Face a = mesh_.face(h), b = mesh_.face(twin(h));
    return a && b && region_[a.index] == region && region_[b.index] == region && !is_cut_on_points(mesh_, h);
  }

  // The next halfedge of the border, around the end of one.
  Halfedge next_on_border(Halfedge h, std::uint32_t region) const {
    Halfedge next = mesh_.next(h);
    while (is_inside(next, region)) next = mesh_.next(twin(next));
    return next;
  }

  Border border_of(const std::vector<Face>& faces, std::uint32_t region) const {
    Border border;
    std::vector<Halfedge> starts;
    for (const Face f : faces)
      for (const Halfedge h : halfedges_around(mesh_, f))
        if (!is_inside(h, region)) starts.push_back(h);
    std::sort(starts.begin(), starts.end());
    std::vector<bool> seen(starts.size(), false);
    std::vector<Vertex> points;
    for (const Halfedge start : starts) {
      const auto place = [&](Halfedge h) {
        return static_cast<std::size_t>(std::lower_bound(starts.begin(), starts.end(), h) - starts.begin());
      };
      if (seen[place(start)]) continue;
      std::vector<Halfedge>& loop = border.loops.emplace_back();
      for (Halfedge h = start; !seen[place(h)]; h = next_on_border(h, region)) {
        seen[place(h)] = true;
        loop.push_back(h);
        points.push_back(point(mesh_, mesh_.from(h)));
      }
      border.is_simple = border.is_simple && loop.size() >= 3;
    }
    std::sort(points.begin(), points.end());
    border.is_simple = border.is_simple && std::adjacent_find(points.begin(), points.end()) == points.end();
    border.is_simple = border.is_simple && is_flat_region(faces, starts.size(), border.loops.size());
    put_outer_first(border, normals_[region]);
    return border;
  }

  // By Euler's formula: a disk with holes.
  bool is_flat_region(const std::vector<Face>& faces, std::size_t border_edges, std::size_t loops) const {
    std::vector<Vertex> corners;
    std::size_t halves = 0, rings = 0;
    for (const Face f : faces) {
      for (std::uint32_t r = mesh_.first_ring(f); r != no_index; r = mesh_.ring(r).next) ++rings;
      for (const Halfedge h : halfedges_around(mesh_, f)) {
        corners.push_back(mesh_.from(h));
        ++halves;
      }
    }
    sort_unique(corners);
    const std::size_t edges = border_edges + (halves - border_edges) / 2;
    return corners.size() + faces.size() + loops == 2 + edges + rings;
  }

  void put_outer_first(Border& border, const glm::dvec3& normal) const {
    const auto area = [&](const std::vector<Halfedge>& loop) {
      std::vector<glm::dvec3> places;
      for (const Halfedge h : loop) places.push_back(mesh_.position(mesh_.from(h)));
      return glm::dot(vector_area(places), normal);
    };
    std::size_t largest = 0;
    for (std::size_t i = 1; i < border.loops.size(); ++i)
      if (area(border.loops[i]) > area(border.loops[largest])) largest = i;
    if (!border.loops.empty()) std::swap(border.loops[0], border.loops[largest]);
  }

  void unite(const std::vector<Face>& faces, const Border& border, std::uint32_t region) {
    std::vector<Edge> inside;
    std::vector<Vertex> corners;
    for (const Face f : faces)
      for (const Halfedge h : halfedges_around(mesh_, f)) {
        corners.push_back(mesh_.from(h));
        if (is_inside(h, region) && h < twin(h)) inside.push_back(edge(h));
      }
    const Face kept = *std::min_element(faces.begin(), faces.end());
    edit_.unite<Face>(kept, faces, [&] {
      std::vector<double> shares;
      for (const Face f : faces) shares.push_back(areas_[f.index]);
      return shares;
    });
    for (const Face f : faces)
      while (mesh_.has_rings(f)) edit_.remove_ring(f, mesh_.first_ring(f));
    std::vector<Vertex> on_border;
    for (const std::vector<Halfedge>& loop : border.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        edit_.connect(loop[i], loop[(i + 1) % loop.size()]);
        edit_.set_face(loop[i], kept);
        // One with a gap already holds a halfedge outside.
        const Vertex v = mesh_.from(loop[i]);
        if (!mesh_.is_boundary(v)) edit_.set_halfedge(v, loop[i]);
        on_border.push_back(v);
      }
    edit_.set_halfedge(kept, border.loops[0][0]);
    for (std::size_t i = 1; i < border.loops.size(); ++i) edit_.add_ring(kept, border.loops[i][0]);
    std::sort(on_border.begin(), on_border.end());
    sort_unique(corners);
    for (const Edge e : inside) edit_.drop(e);
    for (const Face f : faces)
      if (f != kept) edit_.remove(f);
    for (const Vertex v : corners)
      if (!std::binary_search(on_border.begin(), on_border.end(), v)) {
        leave_copies(edit_, v);
        edit_.drop(v);
      }
    region_[kept.index] = region;
  }

  Edit& edit_;
  const Mesh& mesh_;
  PlanarOptions options_;
  std::vector<std::uint32_t> region_;  // per face: the first face of its region
  std::vector<glm::dvec3> normals_;
  std::vector<double> areas_;
};

class StraightCorners {
 public:
  StraightCorners(Edit& edit, const PlanarOptions& options)
      : edit_(edit), m_(edit.mesh()), options_(options), is_seen_(m_.vertex_slots(), false) {}

  std::size_t drop(Progress& progress) {
    for (std::uint32_t i = 0; i < m_.vertex_slots(); ++i)
      if (const Vertex v(i); may_go(v) && !is_seen_[i]) choose(chain_through(v));
    std::sort(chosen_.begin(), chosen_.end());
    std::size_t dropped = 0;
    UniteSeries series(edit_);
    for (std::size_t i = 0; i < chosen_.size() && progress.go_on(i, chosen_.size()); ++i)
      dropped += !makes_flat(chosen_[i]) && series.unite(chosen_[i]);
    return dropped;
  }

 private:
  bool may_go(Vertex v) const {
    if (!m_.is_alive(v) || m_.is_isolated(v) || has_copies(m_, v) || !has_two_edges(m_, v)) return false;
    const Halfedge h = m_.halfedge(v);
    return is_finite(m_.position(v)) && (!m_.is_outside(h) || !m_.is_outside(twin(h)));
  }

  // From one that stays to one that stays; a loop of such vertices begins and ends with the same one.
  std::vector<Vertex> chain_through(Vertex v) {
    std::vector<Vertex> chain{v};
    is_seen_[v.index] = true;
    const Halfedge out = m_.halfedge(v);
    if (!follow(v, out, chain)) return turned_to_first(std::move(chain));
    std::reverse(chain.begin(), chain.end());
    follow(v, m_.counter_clockwise(out), chain);
    return chain;
  }

  // Adds what comes behind `start`, from h on. Returns whether an end was found.
  bool follow(Vertex start, Halfedge h, std::vector<Vertex>& chain) {
    for (;;) {
      const Vertex next = m_.to(h);
      if (next == start) return false;
      chain.push_back(next);
      if (!may_go(next)) return true;
      is_seen_[next.index] = true;
      const Halfedge out = m_.halfedge(next);
      h = out == twin(h) ? m_.counter_clockwise(out) : out;
    }
  }

  std::vector<Vertex> turned_to_first(std::vector<Vertex> loop) const {
    const auto place = [&](Vertex v) {
      const glm::dvec3& p = m_.position(v);
      return std::tuple(p.x, p.y, p.z, v);
    };
    std::rotate(loop.begin(),
                std::min_element(loop.begin(), loop.end(), [&](Vertex v, Vertex w) { return place(v) < place(w); }),
                loop.end());
    loop.push_back(loop.front());
    return loop;
  }

  struct Range {
    std::size_t first, last;
    int depth;
  };

  // Divides at the vertex farthest from the line, or in the middle after too many divisions.
  void choose(const std::vector<Vertex>& chain) {
    constexpr int deep = 64;
    std::vector<Range> waiting{{0, chain.size() - 1, 0}};
    while (!waiting.empty()) {
      const Range range = waiting.back();
      waiting.pop_back();
      if (range.last - range.first < 2) continue;
      const std::size_t far = farthest(chain, range);
      if (far == 0) {
        chosen_.insert(chosen_.end(), chain.begin() + static_cast<std::ptrdiff_t>(range.first) + 1,
                       chain.begin() + static_cast<std::ptrdiff_t>(range.last));
        continue;
      }
      const std::size_t at = range.depth < deep ? far : (range.first + range.last) / 2;
      waiting.push_back({range.first, at, range.depth + 1});
      waiting.push_back({at, range.last, range.depth + 1});
    }
  }

  // The vertex between the ends that is farthest from the line of the ends; 0 where all between may go.
  std::size_t farthest(const std::vector<Vertex>& chain, const Range& range) const {
    const Vertex a = chain[range.first], b = chain[range.last];
    const glm::dvec3 &from = m_.position(a), &to = m_.position(b);
    const Primitive line = Primitive::segment(a.index, b.index, 0);
    std::size_t far = range.first + 1;
    double most = -1;
    bool is_straight = from != to;
    for (std::size_t i = range.first + 1; i <= range.last; ++i) {
      const glm::dvec3 &before = m_.position(chain[i - 1]), &p = m_.position(chain[i]);
      is_straight = is_straight && leads_along(before, p, from, to);
      if (i == range.last) break;
      const double distance = nearest_place(m_.positions(), line, p).distance;
      is_straight = is_straight && (are_collinear(from, to, p) || distance <= options_.distance);
      if (distance > most) {
        most = distance;
        far = i;
      }
    }
    return is_straight ? 0 : far;
  }

  bool leads_along(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& from, const glm::dvec3& to) const {
    const glm::dvec3 part = b - a, way = to - from;
    const double along = glm::dot(part, way);
    return along > 0 && ((are_collinear(from, to, a) && are_collinear(from, to, b)) ||
                         along >= std::cos(std::min(options_.angle_rad, 1.5)) * glm::length(part) * glm::length(way));
  }

  // Where it does not lie exactly between its neighbours.
  bool makes_flat(Vertex v) const {
    const Halfedge out = m_.halfedge(v), other = m_.counter_clockwise(out);
    const glm::dvec3 &a = m_.position(m_.to(out)), &b = m_.position(m_.to(other));
    if (are_collinear(a, b, m_.position(v))) return false;
    const auto place = [&](Vertex w) { return w == v ? a : m_.position(w); };
    for (const Face f : {m_.face(out), m_.face(other)})
      if (f && is_flat_at(m_, f, place)) return true;
    return false;
  }

  Edit& edit_;
  const Mesh& m_;
  PlanarOptions options_;
  std::vector<bool> is_seen_;
  std::vector<Vertex> chosen_;
};

}  // namespace

United unite_planar(Edit& edit, const PlanarOptions& options, Progress& progress) {
  return RegionUniter(edit, options).run(progress);
}

std::size_t drop_straight_corners(Edit& edit, const PlanarOptions& options, Progress& progress) {
  return StraightCorners(edit, options).drop(progress);
}

}  // namespace ryosen::remesh
