// What the hull point by point has in common in space and in a plane: the order of the points, which of them still lie
// outside and what they see, and writing the records.
#pragma once

#include <array>
#include <memory>
#include <queue>
#include <span>
#include <vector>

#include "ryosen/hull/unite_facets.h"
#include "ryosen/textbook/steps/hull/hull_steps.h"

namespace ryosen::hull {

// The first points of an order that span what all span, as far as there are.
struct FirstPoints {
  int dimension = -1;
  std::array<std::uint32_t, 4> numbers{};
};
FirstPoints first_points(std::span<const glm::dvec3> points, std::span<const std::uint32_t> order);

class StepBuilder {
 public:
  using Index = std::uint32_t;

  // `numbers`: of the finite points, in their order.
  StepBuilder(std::span<const glm::dvec3> points, HullOrder order, std::vector<Index> numbers,
              const FirstPoints& first);
  virtual ~StepBuilder() = default;
  virtual std::unique_ptr<StepBuilder> copy() const = 0;

  std::size_t step_count() const { return numbers_.size() - first_.size() + 1; }
  std::size_t steps_done() const { return steps_done_; }
  const forms::DcelRecords& records() const { return records_; }
  std::size_t made_so_far() const { return made_so_far_; }
  const HullStep* next(bool tells_why);
  ConvexHull hull() const;

 protected:
  StepBuilder(const StepBuilder&) = default;
  StepBuilder& operator=(const StepBuilder&) = default;

  // The elements of the first points.
  virtual void begin() = 0;
  // A point that sees an element: finds all that it sees, takes them away and makes new ones.
  virtual void extend(Index p, Index seen) = 0;
  // The element among those just made to which a point goes that saw one which is gone; none where it lies inside.
  virtual Index new_element_of(Index p) const = 0;
  // That the point lies in the plane of an element, or at the place of a vertex.
  virtual void tell_why_not(Index p) = 0;
  virtual bool sees(Index p, Index element) const = 0;
  virtual double distance(Index element, Index p) const = 0;
  // The facets of the hull as it is.
  virtual FacetList facets() const = 0;

  std::span<const glm::dvec3> points() const { return points_; }
  const glm::dvec3& place(Index p) const { return points_[p]; }
  std::span<const Index> first() const { return first_; }
  HullStep& step() { return step_; }
  const HullStep& step() const { return step_; }

  // Writing the records; what is written is noted in the step.
  void set(DcelChange::Table table, Index row, DcelChange::Field field, Index value);
  void set_half_edge(Index h, DcelChange::Field field, Index value) {
    set(DcelChange::Table::half_edge, h, field, value);
  }
  void join(Index h, Index k);
  void pair(Index h, Index k);
  Index new_half_edge();
  Index new_face();
  // All its fields become none, as that of its origin which leads to it. Its row may be used again from the next step
  // on.
  void remove_half_edge(Index h);
  void note_made(Index element);

  Index origin(Index h) const { return records_.half_edges[h].origin; }
  Index next_of(Index h) const { return records_.half_edges[h].next; }
  Index twin(Index h) const { return records_.half_edges[h].twin; }
  Index face_of(Index h) const { return records_.half_edges[h].face; }
  void free_face(Index f) { freed_faces_.push_back(f); }

 private:
  struct Outside {
    Index first = no_index, farthest = no_index;
    double distance = 0;
  };
  struct Candidate {
    double distance;
    Index point;
    bool operator<(const Candidate& other) const {
      return distance != other.distance ? distance < other.distance : point > other.point;
    }
  };

  void keep_outside(Index p, Index element);
  void announce(Index element);
  Index next_point();
  void take(Index p, bool tells_why);
  void hand_on(Index p);
  void reuse_rows();

  std::span<const glm::dvec3> points_;
  HullOrder order_;
  std::vector<Index> numbers_, first_;
  bool is_planar_;
  std::size_t next_number_ = 0, steps_done_ = 0, made_so_far_ = 0;
  forms::DcelRecords records_;
  HullStep step_;
  std::vector<Index> free_half_edges_, free_faces_, freed_half_edges_, freed_faces_;
  std::vector<Index> list_, seen_element_;  // of each point
  std::vector<bool> is_taken_;
  std::vector<Outside> outside_;  // of each element
  std::priority_queue<Candidate> heap_;
};

// The steps in a plane: one face, whose half-edges are what points see.
std::unique_ptr<StepBuilder> planar_steps(std::span<const glm::dvec3> points, HullOrder order,
                                          std::vector<std::uint32_t> numbers, const FirstPoints& first);
// The steps in space: faces are triangles.
std::unique_ptr<StepBuilder> solid_steps(std::span<const glm::dvec3> points, HullOrder order,
                                         std::vector<std::uint32_t> numbers, const FirstPoints& first);

}  // namespace ryosen::hull
