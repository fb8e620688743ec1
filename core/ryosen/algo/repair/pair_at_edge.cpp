#include "ryosen/algo/repair/pair_at_edge.h"

#include <algorithm>
#include <numeric>

#include "ryosen/geometry/around_edge.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

struct EdgePairer::SideAround {
  Halfedge side;
  Face face;
  bool begins;  // an inside, counter-clockwise around the edge
  std::optional<glm::dvec3> place;
};

namespace {

// The corners of a polygon in an order that depends neither on its start nor on its direction, so that two faces back
// to back have the same triangles.
std::vector<std::uint32_t> canonical_order(const Mesh& mesh, const std::vector<Vertex>& place,
                                           const std::vector<Halfedge>& corners) {
  std::vector<std::uint32_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  const auto number = [&](std::uint32_t i) { return place[mesh.from(corners[i]).index].index; };
  const auto lowest = std::min_element(order.begin(), order.end(),
                                       [&](std::uint32_t a, std::uint32_t b) { return number(a) < number(b); });
  std::rotate(order.begin(), lowest, order.end());
  if (number(order.back()) < number(order[1])) std::reverse(order.begin() + 1, order.end());
  return order;
}

// Orders sides at one angle, given by ascending face: those that end an inside first, the lowest face nearest
// to its inside.
template <class Iterator>
void put_nearest_inside(Iterator begin, Iterator end) {
  std::reverse(std::stable_partition(begin, end, [](const auto& s) { return !s.begins; }), end);
}

}  // namespace

void EdgePairer::triangulate(Face f) {
  if (!triangulated_.insert(f).second) return;
  const FacePolygon polygon(mesh_, f);
  if (!polygon.is_finite()) return;
  const std::vector<Halfedge>& corners = polygon.corners();
  std::vector<std::uint32_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<CornerTriangle> triangles;
  if (polygon.loop_ends().size() == 1) {
    order = canonical_order(mesh_, place_, corners);
    std::vector<glm::dvec3> places;
    for (const std::uint32_t i : order) places.push_back(polygon.places()[i]);
    ryosen::triangulate(places, triangles);
  } else {
    polygon.triangulate(triangles);
  }
  for (const CornerTriangle& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = order[triangle[i]], b = order[triangle[(i + 1) % 3]], c = order[triangle[(i + 2) % 3]];
      if (polygon.is_side(a, b)) apexes_.try_emplace(corners[a], polygon.places()[c]);
      if (polygon.is_side(b, a)) apexes_.try_emplace(corners[b], polygon.places()[c]);
    }
}

// A corner of the face that lies beside the side as seen within the face; none where it is not finite.
std::optional<glm::dvec3> EdgePairer::apex(Halfedge side) {
  if (is_triangle(mesh_, side) && !mesh_.has_rings(mesh_.face(side))) {
    const glm::dvec3 place = mesh_.position(mesh_.from(mesh_.prev(side)));
    return is_finite(place) ? std::optional(place) : std::nullopt;
  }
  triangulate(mesh_.face(side));
  const auto found = apexes_.find(side);
  return found == apexes_.end() ? std::nullopt : std::optional(found->second);
}

// A place off the edge's line in the direction of the face. A face without area there has that of a neighbour across
// it.
std::optional<glm::dvec3> EdgePairer::place_beside(Halfedge side, const glm::dvec3& start, const glm::dvec3& end) {
  constexpr std::size_t most_faces = 16;
  if (!is_finite(start) || !is_finite(end)) return std::nullopt;
  std::vector<Halfedge> entered{side};
  for (std::size_t i = 0; i < entered.size(); ++i) {
    const std::optional<glm::dvec3> place = apex(entered[i]);
    if (place && !are_collinear(start, end, *place)) return place;
    for (const Halfedge h : halfedges_around(mesh_, mesh_.face(entered[i]))) {
      const Halfedge next = across_[h.index];
      if (!next || h == entered[i] || entered.size() >= most_faces) continue;
      if (std::none_of(entered.begin(), entered.end(), [&](Halfedge e) { return mesh_.face(e) == mesh_.face(next); }))
        entered.push_back(next);
    }
  }
  return std::nullopt;
}

void EdgePairer::pair(std::span<const Halfedge> sides) {
  const Vertex from = mesh_.from(sides[0]);
  const glm::dvec3 start = mesh_.position(from), end = mesh_.position(mesh_.to(sides[0]));
  std::vector<SideAround> around;
  for (const Halfedge side : sides)
    around.push_back(
        {side, mesh_.face(side), place_[mesh_.from(side).index] != place_[from.index], place_beside(side, start, end)});
  std::sort(around.begin(), around.end(), [](const SideAround& a, const SideAround& b) {
    return a.face != b.face ? a.face < b.face : a.side < b.side;
  });
  const auto first =
      std::find_if(around.begin(), around.end(), [](const SideAround& s) { return s.place.has_value(); });
  if (first != around.end()) {
    const glm::dvec3 place = *first->place;
    const AroundEdge order(start, end, place);
    std::stable_sort(around.begin(), around.end(), [&](const SideAround& a, const SideAround& b) {
      return order.compare(a.place.value_or(place), b.place.value_or(place)) < 0;
    });
    for (auto begin = around.begin(), next = begin; begin != around.end(); begin = next) {
      next = std::find_if(begin, around.end(), [&](const SideAround& s) {
        return order.compare(begin->place.value_or(place), s.place.value_or(place)) != 0;
      });
      put_nearest_inside(begin, next);
    }
  } else {
    put_nearest_inside(around.begin(), around.end());
  }
  match(around);
}

// As brackets are matched, going on from the end at the beginning.
void EdgePairer::match(std::span<const SideAround> around) {
  std::vector<Halfedge> open, ends;
  const auto join = [&](Halfedge closing) {
    across_[open.back().index] = closing;
    across_[closing.index] = open.back();
    open.pop_back();
  };
  for (const SideAround& s : around) {
    if (s.begins)
      open.push_back(s.side);
    else if (open.empty())
      ends.push_back(s.side);
    else
      join(s.side);
  }
  for (const Halfedge closing : ends) join(closing);
}

}  // namespace ryosen
