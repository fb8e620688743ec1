// The incremental hull of the source text on its DCEL, a point at a time, each step as data: what a player shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/hull/convex_hull.h"
#include "ryosen/hull/insertion_order.h"
#include "ryosen/textbook/forms/dcel.h"

namespace ryosen {

namespace hull {
class StepBuilder;
}

// One field of a record, before and after: what a step writes into the records of a DCEL, so that it can be taken back.
// Links are row numbers, no_index for none.
struct DcelChange {
  enum class Table : std::uint8_t { vertex, half_edge, face };
  enum class Field : std::uint8_t { incident_edge, origin, twin, next, prev, face, outer_component };
  Table table;
  std::uint32_t row;
  Field field;
  std::uint32_t old_value, new_value;

  friend bool operator==(const DcelChange&, const DcelChange&) = default;
};
std::string_view id_of(DcelChange::Table table);
std::string_view id_of(DcelChange::Field field);  // as the text names it

// Where the change is; the row is made where it is a new one.
std::uint32_t& cell(forms::DcelRecords& records, const DcelChange& change);

// In space its elements are faces; in a plane they are the half-edges of the one face, whose twins have no face.
struct HullStep {
  enum class Kind : std::uint8_t {
    begin,    // the first four points, which span space; in a plane the first three, which span it
    extend,   // the point lies outside
    inside,   // it lies strictly inside
    on_face,  // it lies in the plane of a face, in a plane on the line of an edge, and not outside
    equal,    // a vertex of the hull lies at the same place
  };
  Kind kind = Kind::begin;
  bool is_planar = false;
  std::uint32_t point = no_index;          // the one taken in; with `begin` the last of the first ones
  std::vector<std::uint32_t> points = {};  // with `begin`: all of these
  std::vector<std::uint32_t> seen = {};    // elements from whose planes the point lies strictly outside; they go
  // In space half-edges of faces that stay, whose twins belonged to seen ones: around the seen region counter-clockwise
  // seen from outside, by the twins. In a plane the half-edges before and behind the seen ones.
  std::vector<std::uint32_t> horizon = {};
  std::vector<std::uint32_t> made = {};  // elements: in space one for each edge of the horizon, in a plane two
  // A made element and the one beside it, which stays or is made too, where they lie in one plane, or line: one facet,
  // or edge, of the hull.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> united = {};
  std::uint32_t witness = no_index;               // the element a point lies on, or the vertex it equals
  std::vector<DcelChange> changes = {};           // in the order in which they were written
  std::size_t half_edge_rows = 0, face_rows = 0;  // how many rows these tables had before it
};

// "Point 12 sees 3 faces: they go, and each of the 5 edges of the horizon makes a face with it."
// `witness`: how the element or the vertex is called; else by its row in the records.
Text caption(const HullStep& step, const std::string& witness = {});

// Writes the changes of a step into a copy of the records before it, or takes them back from those behind it.
void apply(const HullStep& step, forms::DcelRecords& records);
void take_back(const HullStep& step, forms::DcelRecords& records);

// Builds the hull point by point. Each point outside is kept with one element that it sees; when that goes it is handed
// to a new one that it sees, or lies inside. In space that is the one towards which it lies from a point inside
// (fan_sectors.h), so in random order the elements that are made and the hand-overs are O(n log n) expected for n
// points, each of them O(log k) exact signs among k new faces [Clarkson89]. Vertices of the DCEL are the points by
// number; rows of half-edges and faces that are gone are used again, and have no origin and no outer component in
// between. Points must outlive it.
class HullSteps {
 public:
  // Skips points that are not finite. `seed` sets the random order.
  HullSteps(std::span<const glm::dvec3> points, HullOrder order, std::uint64_t seed = 0);
  ~HullSteps();
  HullSteps(HullSteps&&) noexcept;
  HullSteps& operator=(HullSteps&&) noexcept;
  // A second builder at the same state. Cost: O(points).
  HullSteps copy() const;

  // The dimension of all points; below 2 there are no steps.
  int dimension() const;
  // One for the first points and one for each further one.
  std::size_t step_count() const;
  std::size_t steps_done() const;
  // The next step; none behind the last. What it refers to stays until the next call. Unless it tells why, a point that
  // changes nothing is `inside`; to tell costs O(elements).
  const HullStep* next(bool tells_why = true);
  // As they are behind the last step.
  const forms::DcelRecords& records() const;
  // How many elements all steps made so far.
  std::size_t made_so_far() const;
  // The hull of the points taken in so far; of all, behind the last step, that of convex_hull().
  ConvexHull hull() const;

 private:
  HullSteps() = default;
  std::unique_ptr<hull::StepBuilder> builder_;  // none below dimension 2
  std::span<const glm::dvec3> points_;
  int dimension_ = -1;
};

}  // namespace ryosen
