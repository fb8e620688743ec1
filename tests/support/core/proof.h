// Applies operators by their script lines in tests and proves what holds for every one of them.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/ops/all.h"

namespace ryosen::test {

// The operator that a line says; an expectation fails where it says none.
AnyOp op_of(const Mesh& mesh, const std::string& line);
// The ids of the rules against it, in their order, separated by blanks; empty when legal.
std::string rules_against(const Mesh& mesh, const std::string& line);
NameError parse_error(const Mesh& mesh, const std::string& line);

// By how much the terms of the sum change.
struct Change {
  std::int64_t v = 0, e = 0, f = 0, h = 0, s = 0, g = 0, b = 0;
  friend bool operator==(const Change&, const Change&) = default;
};
std::ostream& operator<<(std::ostream& out, const Change& change);

// That the sum holds on points where it must, and that its terms are the kernel's where no point has copies.
void expect_terms(const Mesh& mesh);

// Applies a legal operator and proves: an edit that is not committed leaves no trace, the columns are sound, the sum
// holds, undo and redo are exact, the line of the operator says it again, the effect tells what was made and deleted
// and which faces have other corners, and, where no face has rings, reading the points of the result gives the same
// fans and edges if it did before. Returns what changed.
Change apply_and_prove(Mesh& mesh, const AnyOp& op);
Change apply_and_prove(Mesh& mesh, const std::string& line);

// The solid that a script of assets/exercises builds.
Mesh mesh_of_exercise(const std::string& name);

// Whether the mesh, each vertex taken as one per fan, has the fans and joined edges that reading its points gives.
// Empty, or what differs.
std::string differs_from_reading(const Mesh& mesh);

// The live faces as corner lists of points, each from its smallest corner, sorted: what does not depend on numbering
// of faces.
std::vector<std::vector<std::uint32_t>> point_polygons(const Mesh& mesh);

}  // namespace ryosen::test
