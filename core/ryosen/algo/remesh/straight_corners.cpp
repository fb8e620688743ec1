#include "ryosen/algo/remesh/straight_corners.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <vector>

#include "ryosen/algo/repair/sound_changes.h"
#include "ryosen/geometry/trees/primitive.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/surgery.h"
#include "ryosen/ops/unite_series.h"

namespace ryosen::remesh {

namespace {

class StraightCorners {
 public:
  StraightCorners(Edit& edit, const StraightOptions& options)
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
  StraightOptions options_;
  std::vector<bool> is_seen_;
  std::vector<Vertex> chosen_;
};

}  // namespace

std::size_t drop_straight_corners(Edit& edit, const StraightOptions& options, Progress& progress) {
  return StraightCorners(edit, options).drop(progress);
}

}  // namespace ryosen::remesh
