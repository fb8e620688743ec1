// The steps of the hull in space: faces are triangles.
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "ryosen/hull/fan_sectors.h"
#include "ryosen/textbook/steps/hull/step_builder.h"

namespace ryosen::hull {

namespace {

using Index = std::uint32_t;
using Table = DcelChange::Table;
using Field = DcelChange::Field;

class SolidSteps : public StepBuilder {
 public:
  using StepBuilder::StepBuilder;
  std::unique_ptr<StepBuilder> copy() const override { return std::make_unique<SolidSteps>(*this); }

 private:
  void begin() override {
    std::array<Index, 4> b{first()[0], first()[1], first()[2], first()[3]};
    inside_.emplace(std::array{place(b[0]), place(b[1]), place(b[2]), place(b[3])});
    if (orient3d(place(b[0]), place(b[1]), place(b[2]), place(b[3])) > 0) std::swap(b[1], b[2]);
    const std::array<std::array<Index, 3>, 4> corners{
        {{b[0], b[1], b[2]}, {b[1], b[0], b[3]}, {b[2], b[1], b[3]}, {b[0], b[2], b[3]}}};
    std::vector<Index> all;
    for (const auto& c : corners) {
      const Index h = add_face(c[0], c[1], c[2]);
      for (const Index k : {h, next_of(h), next_of(next_of(h))}) all.push_back(k);
    }
    for (const Index h : all)
      for (const Index k : all)
        if (h < k && origin(h) == origin(next_of(k)) && origin(k) == origin(next_of(h))) pair(h, k);
  }
  void extend(Index p, Index seen) override {
    find_horizon(p, seen);
    remove_seen();
    make_faces(p);
  }
  Index new_element_of(Index p) const override {
    const FanSectors sectors(points(), *inside_, place(step().point), horizon_corners_);
    const Index face = step().made[sectors.sector_of(place(p))];
    return sees(p, face) ? face : no_index;
  }
  void tell_why_not(Index p) override {
    HullStep& step = this->step();
    for (Index f = 0; f < records().faces.size(); ++f) {
      if (!is_there(f) || side(f, p) != 0) continue;
      if (step.kind == HullStep::Kind::inside) {
        step.kind = HullStep::Kind::on_face;
        step.witness = f;
      }
      for (const Index corner : corners_of(f))
        if (place(corner) == place(p)) {
          step.kind = HullStep::Kind::equal;
          step.witness = corner;
          return;
        }
    }
  }
  bool sees(Index p, Index face) const override { return side(face, p) > 0; }
  double distance(Index face, Index p) const override {
    const std::array<Index, 3> c = corners_of(face);
    const glm::dvec3 normal = glm::cross(place(c[1]) - place(c[0]), place(c[2]) - place(c[0]));
    const double height = glm::dot(normal, place(p) - place(c[0])) / glm::length(normal);
    return std::isfinite(height) ? height : 0;
  }
  FacetList facets() const override {
    std::vector<Index> number(records().faces.size(), no_index);
    std::vector<HullTriangle> triangles;
    for (Index f = 0; f < number.size(); ++f)
      if (is_there(f)) {
        number[f] = static_cast<Index>(triangles.size());
        triangles.push_back({corners_of(f), {}});
      }
    for (Index f = 0; f < number.size(); ++f) {
      if (number[f] == no_index) continue;
      Index h = records().faces[f].outer_component;
      for (Index& beside : triangles[number[f]].beside) {
        beside = number[face_of(twin(h))];
        h = next_of(h);
      }
    }
    return unite_facets(points(), triangles);
  }

  // Half-edges from a, b, c in turn; their twins are left to the caller. The half-edge from a.
  Index add_face(Index a, Index b, Index c) {
    const Index f = new_face();
    std::array<Index, 3> h{};
    const std::array<Index, 3> corners{a, b, c};
    for (std::size_t k = 0; k < 3; ++k) {
      h[k] = new_half_edge();
      set_half_edge(h[k], Field::origin, corners[k]);
      set_half_edge(h[k], Field::face, f);
      set(Table::vertex, corners[k], Field::incident_edge, h[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) join(h[k], h[(k + 1) % 3]);
    set(Table::face, f, Field::outer_component, h[0]);
    note_made(f);
    return h[0];
  }
  bool is_there(Index face) const { return records().faces[face].outer_component != no_index; }
  std::array<Index, 3> corners_of(Index face) const {
    const Index h = records().faces[face].outer_component;
    return {origin(h), origin(next_of(h)), origin(next_of(next_of(h)))};
  }
  int side(Index face, Index p) const {
    const std::array<Index, 3> c = corners_of(face);
    return orient3d(place(c[0]), place(c[1]), place(c[2]), place(p));
  }
  // The seen faces by a search over neighbours; then the edges between them and the others, end to end: from one, turn
  // about its end through seen faces until the next.
  void find_horizon(Index p, Index seen) {
    ++round_;
    mark_.resize(records().faces.size(), 0);
    HullStep& step = this->step();
    step.seen.assign(1, seen);
    mark_[seen] = round_;
    Index start = no_index;
    for (std::size_t at = 0; at < step.seen.size(); ++at) {
      Index h = records().faces[step.seen[at]].outer_component;
      for (int k = 0; k < 3; ++k, h = next_of(h)) {
        const Index beyond = face_of(twin(h));
        if (mark_[beyond] == round_) continue;
        if (sees(p, beyond)) {
          mark_[beyond] = round_;
          step.seen.push_back(beyond);
        } else {
          start = h;
        }
      }
    }
    Index h = start;
    do {
      step.horizon.push_back(twin(h));
      h = next_of(h);
      while (mark_[face_of(twin(h))] == round_) h = next_of(twin(h));
    } while (h != start);
  }
  void remove_seen() {
    std::vector<Index> dying;
    for (const Index f : step().seen) {
      const Index first = records().faces[f].outer_component;
      for (const Index h : {first, next_of(first), next_of(next_of(first))}) dying.push_back(h);
      set(Table::face, f, Field::outer_component, no_index);
      free_face(f);
    }
    for (const Index h : dying) remove_half_edge(h);
  }
  void make_faces(Index p) {
    const std::vector<Index> horizon = step().horizon;
    const std::size_t count = horizon.size();
    // The ends of an edge of the horizon, as a made face runs along it: against the half-edge that stays.
    std::vector<Index> along(count);
    horizon_corners_.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      const Index a = origin(next_of(horizon[k])), b = origin(horizon[k]);
      along[k] = add_face(a, b, p);
      horizon_corners_[k] = a;
      pair(along[k], horizon[k]);
    }
    for (std::size_t k = 0; k < count; ++k) pair(next_of(along[k]), next_of(next_of(along[(k + 1) % count])));
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t after = (k + 1) % count;
      if (side(step().made[k], origin(next_of(next_of(horizon[k])))) == 0)
        step().united.emplace_back(step().made[k], face_of(horizon[k]));
      if (side(step().made[k], origin(next_of(along[after]))) == 0)
        step().united.emplace_back(step().made[k], step().made[after]);
    }
  }

  std::optional<InsidePoint> inside_;
  std::vector<Index> mark_;             // of each face the round in which it was seen
  std::vector<Index> horizon_corners_;  // of the last step, as the made faces have them
  Index round_ = 0;
};

}  // namespace

std::unique_ptr<StepBuilder> solid_steps(std::span<const glm::dvec3> points, HullOrder order,
                                         std::vector<std::uint32_t> numbers, const FirstPoints& first) {
  return std::make_unique<SolidSteps>(points, order, std::move(numbers), first);
}

}  // namespace ryosen::hull
