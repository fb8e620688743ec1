// Sheets to simplify, and what is expected of any mesh that was simplified.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>

#include "ryosen/algo/edge_rules.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/collapse_edge.h"
#include "tests/support/core/run_algorithm.h"

namespace ryosen::test {

// A sheet of squares cut in two, z = height(x, y).
template <class Height>
Mesh sheet(std::uint32_t side, Height height) {
  IndexedMesh source;
  for (std::uint32_t y = 0; y <= side; ++y)
    for (std::uint32_t x = 0; x <= side; ++x) source.positions.emplace_back(x, y, height(x, y));
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return y * (side + 1) + x; };
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      for (const std::uint32_t corner : {at(x, y), at(x + 1, y), at(x + 1, y + 1)}) source.corners.push_back(corner);
      source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
      for (const std::uint32_t corner : {at(x, y), at(x + 1, y + 1), at(x, y + 1)}) source.corners.push_back(corner);
      source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
    }
  return from_indexed(source);
}

inline double bump(std::uint32_t x, std::uint32_t y) { return 3 * std::sin(0.35 * x) * std::cos(0.25 * y); }
inline double wave(std::uint32_t x, std::uint32_t y) { return 0.25 * ((x * 7 + y * 13) % 5) + 0.02 * x * y; }

inline Mesh triangulated(const char* shape) {
  Mesh mesh = made_by(shape);
  Edit edit(mesh, nullptr);
  Triangulate{}.apply(edit);
  edit.commit();
  return mesh;
}

inline AlgorithmResult simplified(Mesh& mesh, std::string_view values) {
  Journal journal;
  return run_algorithm(mesh, journal, "simplify " + std::string(values));
}

inline std::size_t count_of(const AlgorithmResult& result, EdgeRule rule) {
  return result.goal_report->remaining[static_cast<std::size_t>(rule)];
}

// Whether the kernel refuses the collapse or warns that a face would turn or lose its area.
inline bool is_refused_plainly(const Mesh& mesh, const CollapseEdge& op) {
  if (!op.judge(mesh).legal()) return true;
  for (const Reason& warning : op.warnings(mesh))
    if (warning.rule != Rule::seam) return true;
  return false;
}

// Every edge of a mesh that went as far as it could is refused in both directions at the ends and the middle.
inline void expect_all_refused(const Mesh& mesh, const std::string& name) {
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (!mesh.is_alive(h) || mesh.is_wire(edge(h))) continue;
    // What has no place is left where it is.
    if (!is_finite(mesh.position(mesh.from(h))) || !is_finite(mesh.position(mesh.to(h)))) continue;
    const bool has_copy = has_copies(mesh, mesh.from(h)) || has_copies(mesh, mesh.to(h));
    for (const auto place : {CollapseEdge::Place::start, CollapseEdge::Place::end, CollapseEdge::Place::middle}) {
      // A point with copies stays where it is.
      if (has_copy && place != CollapseEdge::Place::start && place != CollapseEdge::Place::end) continue;
      if (has_copy && has_copies(mesh, mesh.from(h)) != (place == CollapseEdge::Place::start)) continue;
      EXPECT_TRUE(is_refused_plainly(mesh, {h, place})) << name << ": " << command_of(mesh, CollapseEdge{h, place});
    }
  }
}

inline void expect_kept(const Mesh& before, Mesh& mesh, Journal& journal, const std::string& name) {
  const auto broken = check_invariants(mesh);
  ASSERT_FALSE(broken) << name << ": " << broken->sentence;
  const Figures was = compute_figures(before), is = compute_figures(mesh);
  EXPECT_EQ(is[ProblemKind::nonmanifold_edge], was[ProblemKind::nonmanifold_edge]) << name;
  EXPECT_EQ(is[ProblemKind::misoriented_edge], was[ProblemKind::misoriented_edge]) << name;
  EXPECT_EQ(is.components, was.components) << name;
  EXPECT_EQ(is.euler_characteristic, was.euler_characteristic) << name;
  EXPECT_LE(is[ProblemKind::duplicate_face], was[ProblemKind::duplicate_face]) << name;
  if (!journal.can_undo()) return;
  const MeshColumns after = mesh.columns();
  journal.undo(mesh);
  EXPECT_EQ(mesh.columns(), before.columns()) << name;
  journal.redo(mesh);
  EXPECT_EQ(mesh.columns(), after) << name;
}

// To no faces, or as far as it goes.
inline void go_all_the_way(Mesh mesh, const std::string& name, bool verify = true, const std::string& further = "") {
  const Mesh before = mesh;
  Journal journal;
  const AlgorithmResult result = run_algorithm(mesh, journal, "simplify faces=0 force=on" + further);
  if (result.refused) return;
  expect_kept(before, mesh, journal, name);
  EXPECT_EQ(result.goal_report->stopped, Stop::blocked) << name;
  EXPECT_FALSE(result.goal_report->is_reached) << name;
  const std::vector<std::size_t>& remaining = result.goal_report->remaining;
  EXPECT_EQ(std::accumulate(remaining.begin(), remaining.end(), std::size_t{0}), compute_figures(mesh).edges) << name;
  EXPECT_EQ(count_of(result, EdgeRule::free), 0u) << name;
  if (verify) expect_all_refused(mesh, name);
}

}  // namespace ryosen::test
