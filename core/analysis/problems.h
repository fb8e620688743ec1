// The list of what is wrong with a mesh, or worth knowing, as reports and panels show it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/problem_sets.h"
#include "core/analysis/self_intersections.h"
#include "core/base/element.h"
#include "core/indexed/indexed.h"

namespace ryosen {

// All findings of one kind; the row of the kind has its id, names and severity.
struct Problem {
  ProblemKind kind;
  // One per finding, ascending. A boundary loop is named by its lowest edge, an edge with several sheets and a point
  // with copies by the lowest, a hanging pair and a duplicate by the higher face, a quarantined face by its number,
  // a ring by its face, which comes as often as it has rings.
  std::vector<Element> elements;
  SelfIntersections intersections;  // of that kind, whose elements are the faces of the pairs
  std::optional<glm::dvec3> where;  // a place at the first element; none where it has no finite one
  std::uint64_t line = 0;           // of the file, from 1, at the first element; 0 where unknown
  Text text;

  std::size_t count() const { return elements.size(); }
  const ProblemRow& row() const { return row_of(kind); }
};

// What came with the file. Views; each may be empty.
struct FileFaces {
  std::span<const QuarantinedFace> quarantine;  // ascending by face
  std::span<const std::uint32_t> lines;         // per face of the file
  const LineRuns* vertex_lines = nullptr;
};

// Kinds with at least one finding, in the order of the table. `sets` are those of the mesh as it is; `intersections` what
// find_self_intersections found where it was asked.
std::vector<Problem> find_problems(const Mesh& mesh, const ProblemSets& sets, const FileFaces& file,
                                   SelfIntersections intersections = {});

// A place at a vertex, edge or face: the mean of its points. For a quarantined face (a dead number) of those of its
// corners that are live.
std::optional<glm::dvec3> place_of(const Mesh& mesh, Element element, const FileFaces& file);
// The line of the file at which an element becomes a problem: that of the face itself, of the vertex itself where it is
// isolated or not finite, else of the last face on the edge or at the vertex, which is the one that makes it three on an
// edge or a bow-tie. 0 where there is none.
std::uint64_t line_of(const Mesh& mesh, ProblemKind kind, Element element, const FileFaces& file);
// The element's name on points, as reports list it: v7, f3, 12-88; an edge with several sheets is one.
std::string name_on_points(const Mesh& mesh, Element element);

}  // namespace ryosen
