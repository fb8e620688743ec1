// What a collapse or a swap would do to the shapes of the faces around it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/algo/simplify/collapse_surface.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/rings.h"

namespace ryosen {

// A face without area may turn as it likes; one with area may not lose it.
bool CollapseSurface::turns_too_far(const glm::dvec3& before, const glm::dvec3& after) const {
  const double square = glm::dot(before, before);
  if (!(square > 0)) return false;
  const double product = glm::dot(before, after);
  return !(product > 0) || product * product < turn_cosine_ * turn_cosine_ * square * glm::dot(after, after);
}

namespace {

// Whether the angle between the two has more than this cosine, which is above 0.
bool looks_along(const glm::dvec3& normal, const glm::dvec3& direction, double cosine) {
  const double product = glm::dot(normal, direction);
  return product > 0 && product * product > cosine * cosine * glm::dot(normal, normal) * glm::dot(direction, direction);
}

// Squares of twice an area, scaled: of sides shorter than about a millionth.
constexpr double small_square = 1e-24;

}  // namespace

// The normal of a triangle of that height over the opposite side turns by an angle whose sine is at most the move by
// the height.
double CollapseSurface::safe_move(Vertex v) const {
  constexpr double share = 0.9;  // what is left of an area is not small, and rounding does not matter
  const double sine = std::sqrt(std::max(0.0, 1 - turn_cosine_ * turn_cosine_));
  double least = std::numeric_limits<double>::infinity();
  for (Halfedge corner : outgoing(mesh_, v)) {
    ++looked_at_;
    const Face f = mesh_.face(corner);
    if (!f) continue;
    const Halfedge next = mesh_.next(corner), prev = mesh_.prev(corner);
    if (mesh_.next(next) != prev || mesh_.has_rings(f)) return 0;
    const glm::dvec3 &p = place(v), &x = place(mesh_.from(next)), &y = place(mesh_.from(prev)), side = y - x;
    const glm::dvec3 twice_area = glm::cross(side, p - x);
    const double square = glm::dot(twice_area, twice_area);
    if (!((1 - share) * (1 - share) * square > 2 * small_square)) return 0;
    least = std::min(least, std::sqrt(square / glm::dot(side, side)));
  }
  return share * sine * least;
}

CollapseSurface::HubFacts* CollapseSurface::facts_of_hub(Vertex v) const {
  if (!is_still_) return nullptr;
  const auto [found, is_new] = hubs_.try_emplace(v);
  if (is_new) found->second.safe_move = safe_move(v);
  return &found->second;
}

template <class Look, class FactsOf>
bool CollapseSurface::any_changed_corner(Halfedge h, const glm::dvec3& place, Look look, FactsOf facts_of) const {
  constexpr int many = 64;
  const auto is_vanishing = [&](Halfedge side) {
    return !mesh_.is_outside(side) && !mesh_.has_rings(mesh_.face(side)) &&
           mesh_.next(mesh_.next(side)) == mesh_.prev(side);
  };
  const Face left = is_vanishing(h) ? mesh_.face(h) : Face(),
             right = is_vanishing(twin(h)) ? mesh_.face(twin(h)) : Face();
  const auto is_it = [&](Halfedge corner) {
    ++looked_at_;
    const Face f = mesh_.face(corner);
    return f && f != left && f != right && look(corner);
  };
  for (Halfedge end : {h, twin(h)}) {
    const glm::dvec3& from = states_[mesh_.from(end).index].place;
    if (from == place) continue;
    Halfedge corner = end;
    HubFacts* facts = nullptr;
    int looked = 0;
    do {
      if (looked++ == many) {
        facts = facts_of(mesh_.from(end));
        if (facts && glm::distance(from, place) <= facts->safe_move) break;
        if (facts && std::any_of(facts->turned.begin(), facts->turned.end(),
                                 [&](Halfedge other) { return other && is_it(other); }))
          return true;
      }
      if (is_it(corner)) {
        if (facts) facts->turned[facts->turns++ % facts->turned.size()] = corner;
        return true;
      }
      corner = mesh_.counter_clockwise(corner);
    } while (corner != end);
  }
  return false;
}

// Scaled without moving the middle of the mesh, which may take the digits of small faces far from it.
bool CollapseSurface::turns_small_face(Halfedge corner, const glm::dvec3& position) const {
  const auto at = [&](const glm::dvec3& p) { return scale_.scaled_alone(p); };
  const glm::dvec3 x = at(mesh_.position(mesh_.to(corner))), y = at(mesh_.position(mesh_.from(mesh_.prev(corner)))),
                   p = at(mesh_.position(mesh_.from(corner)));
  const glm::dvec3 side = y - x;
  const double longest = std::max({glm::length(side), glm::length(p - x), glm::length(p - y)});
  if (!(longest > 0)) return false;
  // So that products of what is tiny are not lost.
  const double larger = 1 / longest;
  return turns_too_far(glm::cross(larger * side, larger * (p - x)),
                       glm::cross(larger * side, larger * (at(position) - x)));
}

bool CollapseSurface::turns_face(Halfedge h, const Placing& placing, Minds minds) const {
  const glm::dvec3& place = placing.place;
  const Vertex a = mesh_.from(h), b = mesh_.to(h);
  const glm::vec3 together = states_[a.index].normal + states_[b.index].normal;
  // A face between points of one line, as those of a boundary, is thin where the surface lies, or stands in a wall
  // above it: it is to look clearly along what its corners stand for, not only not against it. So is one with two such
  // points, from which such a face may come. Between points that are locked this is a rule: nothing after it could mend
  // such a face.
  // Weighed seams are no lines: what they hold here, dearer collapses would go before.
  const unsigned seams = holds_seams() ? 0 : on_feature | seam_end | seam_tip;
  const unsigned line_flags = minds == Minds::input ? 0xff & ~seams : fixed | on_locked_boundary;
  const auto is_on_line = [&](Vertex v) {
    return (minds != Minds::nothing && mesh_.is_boundary(v)) || (states_[v.index].flags & line_flags) != 0;
  };
  const bool ends_on_line = is_on_line(a) || is_on_line(b);
  const auto turns = [&](Halfedge corner) {
    const Face f = mesh_.face(corner);
    const Halfedge next = mesh_.next(corner), prev = mesh_.prev(corner);
    if (mesh_.next(next) != prev || mesh_.has_rings(f))
      return turns_too_far(area_vector(f), area_vector(f, a, b, place));
    const State &p = states_[mesh_.from(corner).index], &x = states_[mesh_.from(next).index],
                &y = states_[mesh_.from(prev).index];
    const glm::dvec3 side = y.place - x.place;
    const glm::dvec3 before = glm::cross(side, p.place - x.place), after = glm::cross(side, place - x.place);
    if (glm::dot(before, before) < small_square || glm::dot(after, after) < small_square)
      return turns_small_face(corner, position_of(placing));
    if (turns_too_far(before, after)) return true;
    const glm::dvec3 others = glm::dvec3(x.normal) + glm::dvec3(y.normal), now = others + glm::dvec3(together),
                     then = others + glm::dvec3(p.normal);
    const int on_line = ends_on_line + is_on_line(mesh_.from(next)) + is_on_line(mesh_.from(prev));
    const double clear_cosine = minds == Minds::input && on_line == 3 ? 0.5 : 0.3;
    if (looks_along(after, now, clear_cosine)) return false;
    if (minds == Minds::input && !(glm::dot(after, now) > 0) && glm::dot(before, then) > 0) return true;
    return on_line >= 2 && looks_along(before, then, clear_cosine);
  };
  return any_changed_corner(h, place, turns,
                            [&](Vertex v) { return minds == Minds::input ? nullptr : facts_of_hub(v); });
}

namespace {

// The largest cosine at the corners of a triangle; 1 where two of them meet.
double largest_cosine(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto at = [](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
    const double product = glm::dot(q - p, q - p) * glm::dot(r - p, r - p);
    return product > 0 ? glm::dot(q - p, r - p) / std::sqrt(product) : 1;
  };
  return std::max({at(a, b, c), at(b, c, a), at(c, a, b)});
}

}  // namespace

bool CollapseSurface::narrows_face(Halfedge h, const glm::dvec3& place) const {
  if (angle_cosine_ > 1) return false;
  const auto narrows = [&](Halfedge corner) {
    const Halfedge next = mesh_.next(corner), prev = mesh_.prev(corner);
    if (mesh_.next(next) != prev) return false;  // angles are those of triangles
    const glm::dvec3 &p = states_[mesh_.from(corner).index].place, &x = states_[mesh_.from(next).index].place,
                     &y = states_[mesh_.from(prev).index].place;
    const double after = largest_cosine(place, x, y);
    return after > angle_cosine_ && after > largest_cosine(p, x, y);
  };
  return any_changed_corner(h, place, narrows, [](Vertex) -> HubFacts* { return nullptr; });
}

bool CollapseSurface::swap_spoils_face(Halfedge h) const {
  const Halfedge o = twin(h);
  const glm::dvec3 &a = place(mesh_.from(h)), &b = place(mesh_.to(h)), &c = place(mesh_.from(mesh_.prev(h))),
                   &d = place(mesh_.from(mesh_.prev(o)));
  for (const glm::dvec3& before : {glm::cross(b - a, c - a), glm::cross(a - b, d - b)})
    for (const glm::dvec3& after : {glm::cross(a - c, d - c), glm::cross(b - d, c - d)})
      if (!(glm::dot(after, after) > 0) || turns_too_far(before, after)) return true;
  if (angle_cosine_ > 1) return false;
  const double after = std::max(largest_cosine(c, a, d), largest_cosine(d, b, c));
  return after > angle_cosine_ && after > std::max(largest_cosine(a, b, c), largest_cosine(b, a, d));
}

bool CollapseSurface::may_look_against_input(Face f) const {
  // Of the normals that a vertex stands for, the length of their sum is this share of the sum of their lengths or less
  // where it is folded; and what looks clearly along a normal has at least this cosine, a narrow face more.
  constexpr double folded = 0.6, narrow = 0.1;
  const Halfedge h = mesh_.halfedge(f);
  const std::array<const State*, 3> corners{&states_[mesh_.from(h).index], &states_[mesh_.to(h).index],
                                            &states_[mesh_.from(mesh_.prev(h)).index]};
  const glm::dvec3 u = corners[1]->place - corners[0]->place, v = corners[2]->place - corners[0]->place, w = v - u;
  const glm::dvec3 own = glm::cross(u, v);
  const double length = glm::length(own), longest = std::max({glm::dot(u, u), glm::dot(v, v), glm::dot(w, w)});
  const double clear_cosine = length > narrow * longest ? 0.1 : 0.5;
  return std::any_of(corners.begin(), corners.end(), [&](const State* corner) {
    const glm::dvec3 normal = corner->normal;
    const double sum = glm::length(normal);
    return !(sum > folded * corner->quadric.weight) || !(glm::dot(own, normal) > clear_cosine * length * sum);
  });
}

double CollapseSurface::error_of_move(Vertex v, const glm::dvec3& position) const {
  const Quadric& quadric = states_[v.index].quadric;
  return quadric.weight > 0 ? std::sqrt(quadric.at(scale_.scaled(position)) / quadric.weight) : 0;
}

bool CollapseSurface::move_spoils_face(Vertex v, const glm::dvec3& position, Face mended) const {
  const glm::dvec3 p = place(v), q = scale_.scaled(position);
  for (Halfedge corner : outgoing(mesh_, v)) {
    if (mesh_.is_outside(corner)) continue;
    const glm::dvec3 &x = place(mesh_.to(corner)), &y = place(mesh_.from(mesh_.prev(corner)));
    const glm::dvec3 after = glm::cross(x - q, y - q);
    if (!(glm::dot(after, after) > 0)) return true;
    if (mesh_.face(corner) != mended && turns_too_far(glm::cross(x - p, y - p), after)) return true;
    const double narrowest = angle_cosine_ > 1 ? 0 : largest_cosine(q, x, y);
    if (narrowest > angle_cosine_ && narrowest > largest_cosine(p, x, y)) return true;
  }
  return false;
}

bool CollapseSurface::move_tilts_face(Vertex v, const glm::dvec3& position) const {
  constexpr double clear_cosine = 0.3;
  const glm::dvec3 p = place(v), q = scale_.scaled(position);
  const auto cosine = [](const glm::dvec3& normal, const glm::dvec3& along) {
    const double product = glm::dot(normal, normal) * glm::dot(along, along);
    return product > 0 ? glm::dot(normal, along) / std::sqrt(product) : -1;
  };
  for (const Halfedge corner : outgoing(mesh_, v)) {
    if (mesh_.is_outside(corner)) continue;
    const State &x = states_[mesh_.to(corner).index], &y = states_[mesh_.from(mesh_.prev(corner)).index];
    const glm::dvec3 all = glm::dvec3(states_[v.index].normal) + glm::dvec3(x.normal) + glm::dvec3(y.normal);
    const double after = cosine(glm::cross(x.place - q, y.place - q), all);
    if (after < clear_cosine && after < cosine(glm::cross(x.place - p, y.place - p), all)) return true;
  }
  return false;
}

// The areas of faces of many corners are kept while edges collapse, since summing them anew for each of their edges
// would cost the square of their corners.
void CollapseSurface::find_large_faces() {
  constexpr std::size_t least_corners = 32;
  for (const Face f : live_faces(mesh_)) {
    if (is_triangle(mesh_, mesh_.halfedge(f))) continue;
    const std::size_t corners = corner_count(mesh_, f);
    if (corners >= least_corners)
      large_faces_.emplace(f, LargeFace{summed_area_vector(f, Vertex(), Vertex(), {}), corners});
  }
}

glm::dvec3 CollapseSurface::area_vector(Face f) const {
  if (!large_faces_.empty())
    if (const auto found = large_faces_.find(f); found != large_faces_.end()) return found->second.area_vector;
  return summed_area_vector(f, Vertex(), Vertex(), {});
}

// Of a large face only the sides at the corners that move are summed, as they were and as they come to be.
glm::dvec3 CollapseSurface::area_vector(Face f, Vertex a, Vertex b, const glm::dvec3& place) const {
  const auto found = large_faces_.empty() ? large_faces_.end() : large_faces_.find(f);
  if (found == large_faces_.end()) {
    looked_at_ += corner_count(mesh_, f);
    return summed_area_vector(f, a, b, place);
  }
  const glm::dvec3 origin = states_[a.index].place;
  const auto before = [&](Vertex v) { return states_[v.index].place - origin; };
  const auto after = [&](Vertex v) { return (v == a || v == b ? place : states_[v.index].place) - origin; };
  glm::dvec3 sum = found->second.area_vector;
  const auto add_side = [&](Halfedge h) {
    const Vertex u = mesh_.from(h), v = mesh_.to(h);
    sum += glm::cross(after(u), after(v)) - glm::cross(before(u), before(v));
  };
  for (Vertex end : {a, b})
    for (Halfedge h : outgoing(mesh_, end)) {
      ++looked_at_;
      if (mesh_.face(h) != f) continue;
      add_side(h);
      if (const Vertex u = mesh_.from(mesh_.prev(h)); u != a && u != b) add_side(mesh_.prev(h));
    }
  return sum;
}

void CollapseSurface::follow_large_faces(Halfedge h, const Placing& placing) {
  if (large_faces_.empty()) return;
  const glm::dvec3 place = scale_.scaled(position_of(placing));
  const Vertex a = mesh_.from(h), b = mesh_.to(h);
  std::vector<Face> faces;
  for (Vertex end : {a, b})
    for (Halfedge corner : outgoing(mesh_, end))
      if (const Face f = mesh_.face(corner); f && large_faces_.contains(f)) faces.push_back(f);
  sort_unique(faces);
  for (Face f : faces) {
    LargeFace& large = large_faces_.at(f);
    // Summed anew from time to time, so that rounding does not add up.
    const bool is_worn = ++large.changes > large.corners;
    large.area_vector = is_worn ? summed_area_vector(f, a, b, place) : area_vector(f, a, b, place);
    if (!is_worn) continue;
    looked_at_ += large.corners;
    large.changes = 0;
  }
}

}  // namespace ryosen
