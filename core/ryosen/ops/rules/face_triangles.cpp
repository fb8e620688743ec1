#include "ryosen/ops/rules/face_triangles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>

#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

constexpr std::size_t most_corners_searched = 400;
constexpr std::size_t most_repairs = 16;
// Bounds the search to hover latency.
constexpr std::size_t most_steps = 12'000'000;

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// Substitute positions for a non-finite face: concentric circles, rings inside the outer loop.
std::vector<glm::dvec3> round_places(const FacePolygon& face) {
  std::vector<glm::dvec3> places;
  const auto rings = static_cast<double>(face.loop_ends().size() - 1);
  std::uint32_t begin = 0;
  for (std::size_t l = 0; l < face.loop_ends().size(); ++l) {
    const std::uint32_t end = face.loop_ends()[l];
    const double turn = 2 * std::numbers::pi / static_cast<double>(end - begin), at = static_cast<double>(l);
    const double place = 2 * std::numbers::pi * at / std::max(rings, 1.0);
    const glm::dvec3 centre = l == 0 ? glm::dvec3() : glm::dvec3(0.2 * std::cos(place), 0.2 * std::sin(place), 0);
    const double radius = l == 0 ? 1 : 0.1 / rings;
    for (std::uint32_t i = begin; i < end; ++i) {
      const double angle = (l == 0 ? turn : -turn) * static_cast<double>(i - begin);
      places.push_back(centre + radius * glm::dvec3(std::cos(angle), std::sin(angle), 0));
    }
    begin = end;
  }
  return places;
}

// The search for one face. Corners are given by number; a list of them may repeat corners.
class Search {
 public:
  Search(const Mesh& mesh, const FacePolygon& face)
      : mesh_(mesh), face_(face), places_(face.is_finite() ? face.places() : round_places(face)) {
    for (Halfedge h : face.corners()) {
      points_.push_back(point(mesh, mesh.from(h)).index);
      joined_.push_back(joined_to(mesh.from(h)));
    }
    normal_ = polygon_normal(face.is_finite() ? face.keyhole_walk() : places_);
    for (const glm::dvec3& p : places_) extent_ = std::max(extent_, glm::length(p - places_[0]));
    if (!(extent_ > 0) || !std::isfinite(extent_)) extent_ = 1;
  }

  std::size_t steps_of_attempt() const { return points_.size() * points_.size() * points_.size() + 1; }

  std::vector<CornerTriangle> run() {
    std::vector<CornerTriangle> triangles = drawn();
    if (!repeated(triangles)) return first_at_corner_0(std::move(triangles));
    if (points_.size() + 2 * face_.loop_ends().size() > most_corners_searched) return {};
    const std::size_t rings = face_.loop_ends().size() - 1;
    const std::size_t attempts = rings == 0 ? 1 : std::clamp<std::size_t>(most_steps / steps_of_attempt(), 1, 48);
    for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
      std::vector<Pair> keyholes;
      const std::vector<std::uint32_t> list = one_list(attempt, keyholes);
      if (list.empty()) continue;
      triangles = cut_list(list, keyholes);
      if (!triangles.empty()) return first_at_corner_0(std::move(triangles));
    }
    return {};
  }

 private:
  std::vector<CornerTriangle> drawn() const {
    std::vector<std::span<const glm::dvec3>> loops;
    std::uint32_t begin = 0;
    for (std::uint32_t end : face_.loop_ends()) {
      loops.push_back(std::span(places_).subspan(begin, end - begin));
      begin = end;
    }
    std::vector<CornerTriangle> triangles;
    triangulate_loops(loops, triangles);
    return triangles;
  }

  // The points that edges lead to, ascending; none where there are very many.
  std::optional<std::vector<std::uint32_t>> joined_to(Vertex corner) const {
    constexpr std::size_t most = 64;
    std::vector<std::uint32_t> joined;
    const bool are_many = any_of_copies(mesh_, corner, [&](Vertex copy) {
      for (const Vertex v : neighbours(mesh_, copy)) {
        if (joined.size() == most) return true;
        joined.push_back(point(mesh_, v).index);
      }
      return false;
    });
    if (are_many) return std::nullopt;
    std::sort(joined.begin(), joined.end());
    return joined;
  }
  bool may_join(std::uint32_t a, std::uint32_t b) const {
    if (points_[a] == points_[b]) return false;
    for (const auto& [at, other] : {Pair(a, b), Pair(b, a)})
      if (joined_[at]) return !std::binary_search(joined_[at]->begin(), joined_[at]->end(), points_[other]);
    const auto [are, is_new] = are_joined_.try_emplace(pair_of(a, b));
    if (is_new) are->second = are_joined(mesh_, Vertex(points_[a]), Vertex(points_[b]));
    return !are->second;
  }
  // The two points of an edge, whichever corners represent them.
  Pair pair_of(std::uint32_t a, std::uint32_t b) const { return std::minmax(points_[a], points_[b]); }

  // A forbidden new edge of the triangles, by its corners: one that exists already or is created twice.
  std::optional<Pair> repeated(const std::vector<CornerTriangle>& triangles) const {
    std::vector<std::pair<Pair, Pair>> made;  // points from and to, and the corners
    for (const CornerTriangle& t : triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3];
        if (face_.is_side(a, b)) continue;
        if (!may_join(a, b)) return Pair(a, b);
        made.push_back({Pair(points_[a], points_[b]), Pair(a, b)});
      }
    }
    std::sort(made.begin(), made.end());
    for (std::size_t i = 1; i < made.size(); ++i)
      if (made[i].first == made[i - 1].first) return made[i].second;
    return std::nullopt;
  }

  // All loops as one list, joined by new edges (keyholes) traversed in both directions; `attempt` selects among the
  // shortest ones. Empty if there are not that many.
  std::vector<std::uint32_t> one_list(std::size_t attempt, std::vector<Pair>& keyholes) const {
    std::vector<std::uint32_t> list(face_.loop_ends()[0]);
    for (std::uint32_t i = 0; i < list.size(); ++i) list[i] = i;
    const std::size_t rings = face_.loop_ends().size() - 1, choices = rings == 1 ? 48 : rings == 2 ? 7 : 3;
    for (std::size_t r = 1; r <= rings; ++r) {
      const std::uint32_t begin = face_.loop_ends()[r - 1], end = face_.loop_ends()[r];
      struct Way {
        double length;
        std::size_t at;
        std::uint32_t corner;
        auto operator<=>(const Way&) const = default;
      };
      std::vector<Way> ways;
      for (std::size_t at = 0; at < list.size(); ++at)
        for (std::uint32_t corner = begin; corner < end; ++corner)
          if (may_join(list[at], corner))
            ways.push_back({glm::length(places_[list[at]] - places_[corner]), at, corner});
      const std::size_t choice = attempt % choices;
      attempt /= choices;
      if (choice >= ways.size()) return {};
      std::sort(ways.begin(), ways.end());
      const Way& way = ways[choice];
      keyholes.push_back(pair_of(list[way.at], way.corner));
      std::vector<std::uint32_t> detour;
      for (std::uint32_t i = 0; i <= end - begin; ++i)
        detour.push_back(begin + (way.corner - begin + i) % (end - begin));
      detour.push_back(list[way.at]);
      list.insert(list.begin() + static_cast<std::ptrdiff_t>(way.at) + 1, detour.begin(), detour.end());
    }
    return list;
  }

  double cost(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const glm::dvec3 p = (places_[a] - places_[c]) / extent_, q = (places_[b] - places_[c]) / extent_;
    const double turned = glm::dot(glm::cross(p, q), normal_) > 0 ? 0 : 1e6;
    return turned + glm::length(p) + glm::length(q);
  }

  // The cheapest triangulation of a list without forbidden edges; empty if there is none.
  std::vector<CornerTriangle> cut_list(const std::vector<std::uint32_t>& list,
                                       const std::vector<Pair>& keyholes) const {
    std::vector<Pair> banned;  // indices into the list
    const std::size_t repairs = std::min(most_repairs, most_steps / steps_of_attempt());
    for (std::size_t repair = 0; repair <= repairs; ++repair) {
      std::vector<std::array<std::size_t, 3>> at = cheapest(list, keyholes, banned);
      std::vector<CornerTriangle> triangles;
      for (const auto& t : at) triangles.push_back({list[t[0]], list[t[1]], list[t[2]]});
      const std::optional<Pair> wrong = repeated(triangles);
      if (triangles.empty() || !wrong) return triangles;
      for (const auto& t : at)
        for (std::size_t i = 0; i < 3; ++i)
          if (Pair(list[t[i]], list[t[(i + 1) % 3]]) == *wrong)
            banned.push_back(std::minmax(static_cast<std::uint32_t>(t[i]), static_cast<std::uint32_t>(t[(i + 1) % 3])));
    }
    return {};
  }

  std::vector<std::array<std::size_t, 3>> cheapest(const std::vector<std::uint32_t>& list,
                                                   const std::vector<Pair>& keyholes,
                                                   const std::vector<Pair>& banned) const {
    const std::size_t n = list.size();
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> best(n * n, never);
    std::vector<std::size_t> middle(n * n, 0);
    const auto allowed = [&](std::size_t i, std::size_t j) {
      if (j == i + 1 || (i == 0 && j == n - 1)) return true;
      const Pair places(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
      return may_join(list[i], list[j]) && std::find(banned.begin(), banned.end(), places) == banned.end() &&
             std::find(keyholes.begin(), keyholes.end(), pair_of(list[i], list[j])) == keyholes.end();
    };
    for (std::size_t i = 0; i + 1 < n; ++i) best[i * n + i + 1] = 0;
    for (std::size_t length = 2; length < n; ++length) {
      for (std::size_t i = 0; i + length < n; ++i) {
        const std::size_t j = i + length;
        if (!allowed(i, j)) continue;
        for (std::size_t k = i + 1; k < j; ++k) {
          const double parts = best[i * n + k] + best[k * n + j];
          if (parts >= best[i * n + j]) continue;
          const double total = parts + cost(list[i], list[k], list[j]);
          if (total >= best[i * n + j]) continue;
          best[i * n + j] = total;
          middle[i * n + j] = k;
        }
      }
    }
    std::vector<std::array<std::size_t, 3>> triangles;
    if (best[n - 1] == never) return triangles;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j - i < 2) continue;
      const std::size_t k = middle[i * n + j];
      triangles.push_back({i, k, j});
      open.push_back({k, j});
      open.push_back({i, k});
    }
    return triangles;
  }

  std::vector<CornerTriangle> first_at_corner_0(std::vector<CornerTriangle> triangles) const {
    const std::uint32_t second = face_.next(0);
    for (CornerTriangle& t : triangles) {
      for (int i = 0; i < 3; ++i) {
        if (t[0] == 0 && t[1] == second) {
          std::swap(t, triangles.front());
          return triangles;
        }
        std::rotate(t.begin(), t.begin() + 1, t.end());
      }
    }
    return triangles;
  }

  const Mesh& mesh_;
  const FacePolygon& face_;
  std::vector<glm::dvec3> places_;
  std::vector<std::uint32_t> points_;
  std::vector<std::optional<std::vector<std::uint32_t>>> joined_;
  mutable std::map<Pair, bool> are_joined_;  // of corners with very many edges
  glm::dvec3 normal_{};
  double extent_ = 0;
};

}  // namespace

std::vector<CornerTriangle> triangles_of_face(const Mesh& mesh, const FacePolygon& face) {
  return Search(mesh, face).run();
}

std::vector<Edge> edges_across(const Mesh& mesh, const FacePolygon& face) {
  std::vector<Vertex> points;
  for (Halfedge h : face.corners()) points.push_back(point(mesh, mesh.from(h)));
  sort_unique(points);
  const Face f = mesh.face(face.corners()[0]);
  std::vector<Edge> found;
  for (Vertex p : points) {
    for_each_copy(mesh, p, [&](Vertex copy) {
      for (Halfedge h : outgoing(mesh, copy))
        if (mesh.face(h) != f && mesh.face(twin(h)) != f &&
            std::binary_search(points.begin(), points.end(), point(mesh, mesh.to(h))))
          found.push_back(edge(h));
    });
  }
  sort_unique(found);
  return found;
}

}  // namespace ryosen
