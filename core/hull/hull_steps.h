// The incremental hull of the source text on its DCEL, a point at a time, each step as data: what a player shows.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/forms/dcel_records.h"
#include "core/hull/convex_hull.h"
#include "core/hull/insertion_order.h"

namespace ryosen {

// One field of a record, before and after. Links are row numbers, no_index for none.
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

struct HullStep {
  enum class Kind : std::uint8_t {
    begin,    // the first four points, which span space
    extend,   // the point lies outside
    inside,   // it lies strictly inside
    on_face,  // it lies in the plane of a face, and not outside
    equal,    // a vertex of the hull lies at the same place
  };
  Kind kind = Kind::begin;
  std::uint32_t point = no_index;          // the one taken in; with `begin` the last of the four
  std::vector<std::uint32_t> points = {};  // with `begin`: all four
  std::vector<std::uint32_t> seen = {};    // faces from whose planes the point lies strictly outside; they go
  // Half-edges of faces that stay, whose twins belonged to seen ones: around the seen region counter-clockwise seen from
  // outside, by the twins.
  std::vector<std::uint32_t> horizon = {};
  std::vector<std::uint32_t> made = {};  // faces, one for each edge of the horizon
  // A made face and the one beyond its edge of the horizon where they lie in one plane: one facet of the hull.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> united = {};
  std::uint32_t witness = no_index;               // of on_face the face, of equal the vertex
  std::vector<DcelChange> changes = {};           // in the order in which they were written
  std::size_t half_edge_rows = 0, face_rows = 0;  // how many rows these tables had before it
};

// "Point 12 sees 3 faces; its horizon has 5 edges, and 5 faces are made."
Text caption(const HullStep& step);

// Writes the changes of a step into a copy of the records before it, or takes them back from those behind it.
void apply(const HullStep& step, forms::DcelRecords& records);
void take_back(const HullStep& step, forms::DcelRecords& records);

// Builds the hull point by point. Each point outside is kept with one face that it sees; when that goes it is handed to a
// new face that it sees, or lies inside. So n points in random order cost O(n log n) expected, where steps make few faces. Vertices of the DCEL are
// the points by number; rows of half-edges and faces that are gone are used again, and have no origin and no outer
// component in between. Points must outlive it.
class HullSteps {
 public:
  // Not finite points are left out. `seed`: of the random order.
  HullSteps(std::span<const glm::dvec3> points, HullOrder order, std::uint64_t seed = 0);
  ~HullSteps();
  HullSteps(const HullSteps&) = delete;
  HullSteps& operator=(const HullSteps&) = delete;

  // Of all points; below 3 there is no step.
  int dimension() const;
  // One for the first four points and one for each further one.
  std::size_t step_count() const;
  // The next step; none behind the last. What it refers to stays until the next call.
  const HullStep* next();
  // As they are behind the last step.
  const forms::DcelRecords& records() const;
  // How many faces all steps made so far.
  std::size_t faces_made() const;
  // The hull of the points taken in so far; of all, behind the last step, that of convex_hull().
  ConvexHull hull() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

// The records without rows that are gone, for a Dcel; vertices without an edge stay.
forms::DcelRecords in_use(const forms::DcelRecords& records);

}  // namespace ryosen
