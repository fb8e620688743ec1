// The list of problems and remarks about a mesh, as shown in reports and panels.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ryosen/analysis/problem_sets.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/base/element.h"
#include "ryosen/indexed/indexed.h"

namespace ryosen {

// All findings of one kind; the row of the kind has its id, names and severity.
struct Problem {
  ProblemKind kind;
  // One per finding, ascending. A boundary loop is named by its lowest edge, an edge with several sheets and a point
  // with copies by the lowest, a hanging pair and a duplicate by the higher face, a quarantined face by its number,
  // a ring by its face, which comes as often as it has rings.
  std::vector<Element> elements;
  SelfIntersections intersections;  // for that kind; `elements` are the faces of the pairs
  std::optional<glm::dvec3> where;  // a position on the first element; none if not finite
  std::uint64_t line = 0;           // of the file, from 1, at the first element; 0 where unknown
  Text text;

  std::size_t count() const { return elements.size(); }
  const ProblemRow& row() const { return row_of(kind); }
};

// Per-face data of the file. Views; each may be empty.
struct FileFaces {
  std::span<const QuarantinedFace> quarantine;  // ascending by face
  std::span<const std::uint32_t> lines;         // per face of the file
  const LineRuns* vertex_lines = nullptr;
};

// Kinds with at least one finding, in the order of the table. `sets` must be up to date with the mesh; `intersections`
// is the result of find_self_intersections, if it was run.
std::vector<Problem> find_problems(const Mesh& mesh, const ProblemSets& sets, const FileFaces& file,
                                   SelfIntersections intersections = {});

// A position on a vertex, edge or face: the mean of its points. For a quarantined face (a dead slot) over its live
// corners.
std::optional<glm::dvec3> place_of(const Mesh& mesh, Element element, const FileFaces& file);
// The line of the file at which an element becomes a problem: that of the face itself, of the vertex itself if it is
// isolated or not finite, else of the last face at the edge or vertex, the one that makes it non-manifold. 0 if
// unknown.
std::uint64_t line_of(const Mesh& mesh, ProblemKind kind, Element element, const FileFaces& file);
// The element's name on points, as in reports: v7, f3, 12-88; all sheets of an edge have the same name.
std::string name_on_points(const Mesh& mesh, Element element);

}  // namespace ryosen
