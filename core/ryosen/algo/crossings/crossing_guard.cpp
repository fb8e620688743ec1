#include "ryosen/algo/crossings/crossing_guard.h"

#include "ryosen/analysis/overlap_tree.h"
#include "ryosen/geometry/box.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

bool is_flat(const NumberedTriangle& t) { return are_collinear(t.places[0], t.places[1], t.places[2]); }

}  // namespace

const MetPlaces& CrossingGuard::nowhere() {
  static const MetPlaces none;
  return none;
}

// A face that a split has made is of the part of those beside it.
void CrossingGuard::follow(Vertex kept) {
  faces_.follow(kept);
  if (parts_.size() >= mesh_.face_slots() || parts_.empty()) return;
  std::uint32_t part = 0;
  for (const Face f : faces_around(mesh_, kept))
    if (f && f.index < parts_.size()) part = parts_[f.index];
  parts_.resize(mesh_.face_slots(), part);
}

bool CrossingGuard::meet(const Changed& a, const Changed& b) const {
  if (!meet_elsewhere(a.triangle, b.triangle)) return false;
  return parts_.empty() || !met_.have_met(parts_[a.face.index], parts_[b.face.index]) ||
         !met_.hold(a.triangle.places, b.triangle.places);
}

void CrossingGuard::Step::begin(std::uint32_t face_slots) {
  changed.clear();
  gone.clear();
  heirs.clear();
  if (++number == 0) last.clear();  // all numbers were there
  number = std::max(number, 1u);
  last.resize(std::max<std::size_t>(last.size(), face_slots), 0);
}

NumberedTriangle CrossingGuard::triangle(Halfedge h) const {
  NumberedTriangle t{corners_of(mesh_, h), {}};
  std::size_t i = 0;
  for (const Vertex v : {mesh_.from(h), mesh_.to(h), mesh_.from(mesh_.prev(h))}) t.numbers[i++] = point(mesh_, v).index;
  return t;
}

void CrossingGuard::begin() const {
  step_.begin(mesh_.face_slots());
  loses_area_ = false;
}

void CrossingGuard::change(const NumberedTriangle& t, Face f) const {
  if (!is_flat(t)) {
    const Changed changed{f, t};
    if (parts_.empty() || !met_.enclose(changed.box, parts_[f.index])) step_.changed.push_back(changed);
    step_.mark(f);
  } else if (!is_flat(triangle(f))) {
    loses_area_ = true;
  }
}

void CrossingGuard::remove(Halfedge side) const {
  const Face f = mesh_.face(side);
  step_.gone.push_back(f);
  step_.mark(f);
  for (const Halfedge other : {mesh_.next(side), mesh_.prev(side)})
    if (const Face heir = mesh_.face(twin(other))) step_.heirs.push_back({f, heir});
}

bool CrossingGuard::would_meet(Halfedge h, const glm::dvec3& position) const {
  const Vertex gone = mesh_.from(h), kept = mesh_.to(h);
  begin();
  for (const Halfedge side : {h, twin(h)})
    if (!mesh_.is_outside(side)) remove(side);
  for (Halfedge end : {h, twin(h)}) {
    if (end != h && mesh_.position(kept) == position) continue;
    for (const Face f : faces_around(mesh_, mesh_.from(end))) {
      if (!f || f == mesh_.face(h) || f == mesh_.face(twin(h))) continue;
      NumberedTriangle t = triangle(f);
      for (std::size_t i = 0; i < 3; ++i) {
        if (t.numbers[i] != point(mesh_, gone).index && t.numbers[i] != point(mesh_, kept).index) continue;
        t.numbers[i] = point(mesh_, kept).index;
        t.places[i] = position;
      }
      change(t, f);
    }
  }
  return would_meet();
}

bool CrossingGuard::would_meet(Vertex v, const glm::dvec3& position) const {
  begin();
  for (const Face f : faces_around(mesh_, v)) {
    if (!f) continue;
    NumberedTriangle t = triangle(f);
    for (std::size_t i = 0; i < 3; ++i)
      if (t.numbers[i] == point(mesh_, v).index) t.places[i] = position;
    change(t, f);
  }
  return would_meet();
}

bool CrossingGuard::would_meet_swapped(Halfedge h) const {
  begin();
  const NumberedTriangle left = triangle(h), right = triangle(twin(h));  // a b c and b a d
  const auto made = [](const NumberedTriangle& own, const NumberedTriangle& other) {
    return NumberedTriangle{{own.places[2], own.places[0], other.places[2]},
                            {own.numbers[2], own.numbers[0], other.numbers[2]}};
  };
  change(made(left, right), mesh_.face(h));
  change(made(right, left), mesh_.face(twin(h)));
  return would_meet();
}

bool CrossingGuard::would_meet_split(Halfedge h, const glm::dvec3& position) const {
  begin();
  const bool is_cut = is_cut_on_points(mesh_, h);
  for (const Halfedge sheet : is_cut ? sheets_between(mesh_, mesh_.from(h), mesh_.to(h)) : std::vector{h})
    for (const Halfedge side : {sheet, twin(sheet)}) {
      if (mesh_.is_outside(side)) continue;
      for (const std::size_t replaced : {0u, 1u}) {
        NumberedTriangle t = triangle(side);
        t.places[replaced] = position;
        t.numbers[replaced] = mesh_.vertex_slots();
        change(t, mesh_.face(side));
      }
    }
  return would_meet();
}

bool CrossingGuard::would_meet() const {
  if (loses_area_) return true;
  if (step_.changed.empty()) return false;
  if (allowed_ == Allowed::inherited) return !inherits();
  return meetings(step_.changed, 1) > 0 && (allowed_ == Allowed::none || adds());
}

// A face without area meets none; so it is not among those that are asked.
std::vector<CrossingGuard::Changed> CrossingGuard::before() const {
  std::vector<Changed> before;
  for (const Changed& one : step_.changed)  // of a split both halves
    if (before.empty() || before.back().face != one.face) before.push_back({one.face, triangle(one.face)});
  for (const Face f : step_.gone) before.push_back({f, triangle(f)});
  std::erase_if(before, [](const Changed& one) { return is_flat(one.triangle); });
  return before;
}

bool CrossingGuard::adds() const {
  const std::vector<Changed> before = this->before();
  const std::size_t now = meetings(before, most_compared);
  return now == 0 || meetings(step_.changed, now + 1) > now;
}

bool CrossingGuard::inherits() const {
  std::size_t count = 0;
  const bool is_all = visit_meetings(step_.changed, [&](const Changed& a, const Changed& b) {
    return ++count <= most_compared && is_inherited(a.face, b.face);
  });
  return is_all && (count == 0 || meetings(before(), count) == count);
}

bool CrossingGuard::is_inherited(Face a, Face b) const {
  const auto do_meet = [&](Face x, Face y) {
    if (x == y) return false;
    const NumberedTriangle first = triangle(x), second = triangle(y);
    return !is_flat(first) && !is_flat(second) && meet_elsewhere(first, second);
  };
  const auto any_of = [&](Face f, const auto& is) {
    return is(f) || std::any_of(step_.heirs.begin(), step_.heirs.end(),
                                [&](const Heir& one) { return one.heir == f && is(one.gone); });
  };
  return any_of(a, [&](Face x) { return any_of(b, [&](Face y) { return do_meet(x, y); }); });
}

// Where one is enough it is mostly found between neighbours around the vertex.
std::size_t CrossingGuard::meetings(const std::vector<Changed>& faces, std::size_t most) const {
  for (std::size_t i = 1; most == 1 && faces.size() > few && i < faces.size(); ++i)
    if (meet(faces[i - 1], faces[i])) return 1;
  std::size_t found = 0;
  visit_meetings(faces, [&](const Changed&, const Changed&) { return ++found < most; });
  return found;
}

template <class Visit>
bool CrossingGuard::visit_meetings(const std::vector<Changed>& faces, const Visit& visit) const {
  constexpr std::size_t many_pairs = 1 << 14;
  find_near(faces);
  if (faces.size() * (faces.size() / 2 + near_.size()) > many_pairs && faces.size() > few)
    return visit_meetings_by_tree(faces, visit);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = i + 1; k < faces.size(); ++k)
      if (meet(faces[i], faces[k]) && !visit(faces[i], faces[k])) return false;
    const TriangleSlabs slabs(faces[i].triangle.places);
    for (const Changed& other : near_)
      if (faces[i].box.overlaps(other.box) && !slabs.separate(other.triangle.places) && meet(faces[i], other) &&
          !visit(faces[i], other))
        return false;
  }
  return true;
}

template <class Visit>
bool CrossingGuard::visit_meetings_by_tree(const std::vector<Changed>& faces, const Visit& visit) const {
  std::vector<glm::dvec3> places;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::unordered_map<std::uint32_t, std::uint32_t> place_of;  // by number
  for (const std::vector<Changed>* part : {&faces, &std::as_const(near_)})
    for (const Changed& one : *part) {
      std::array<std::uint32_t, 3>& own = triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [at, is_new] = place_of.try_emplace(one.triangle.numbers[k], places.size());
        if (is_new) places.push_back(one.triangle.places[k]);
        own[k] = at->second;
      }
    }
  const NumberedSurface surface(std::move(places), std::move(triangles));
  const OverlapTree tree(surface, 1);
  const auto is_of_step = [&](std::uint32_t a, std::uint32_t b) { return a < faces.size() || b < faces.size(); };
  const auto visit_slots = [&](std::uint32_t a, std::uint32_t b) {
    const auto one = [&](std::uint32_t i) -> const Changed& {
      return i < faces.size() ? faces[i] : near_[i - faces.size()];
    };
    return !meet(one(a), one(b)) || visit(one(a), one(b));
  };
  for (std::uint32_t node = 0; node < tree.node_count(); ++node)
    if (!tree.visit_pairs(node, is_of_step, visit_slots)) return false;
  return true;
}

// The faces near these that the step leaves as they are.
void CrossingGuard::find_near(const std::vector<Changed>& faces) const {
  near_.clear();
  asked_.clear();
  found_.clear();
  for (const Changed& one : faces) asked_.push_back(one.triangle);
  faces_.find(asked_, found_);
  looks_ += found_.size();
  for (const Face f : found_) {
    if (step_.concerns(f)) continue;
    const NumberedTriangle other = triangle(f);
    if (!is_flat(other)) near_.push_back({f, other});
  }
}

}  // namespace ryosen
