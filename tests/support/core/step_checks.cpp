#include "tests/support/core/step_checks.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/mesh/names.h"
#include "tests/support/core/kernel_sum.h"

namespace ryosen::test {

namespace {

using Cell = std::tuple<std::string, std::string, std::string>;
using Tables = std::map<Cell, std::string>;

std::string or_none(const std::optional<std::string>& value) { return value.value_or("-"); }

// All cells of the kernel's tables, read through the mesh's own accessors.
Tables tables_of(const Mesh& mesh) {
  Tables all;
  const auto link = [](auto handle) { return handle ? slot_name(handle) : std::string("-"); };
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (mesh.is_alive(Vertex(i)))
      all[{"vertices", "v" + std::to_string(i), "halfedge"}] = link(mesh.halfedge(Vertex(i)));
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    if (!mesh.is_alive(Halfedge(i))) continue;
    const std::string row = "h" + std::to_string(i);
    all[{"halfedges", row, "from"}] = link(mesh.from(Halfedge(i)));
    all[{"halfedges", row, "next"}] = link(mesh.next(Halfedge(i)));
    all[{"halfedges", row, "prev"}] = link(mesh.prev(Halfedge(i)));
    all[{"halfedges", row, "face"}] = link(mesh.face(Halfedge(i)));
  }
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i)
    if (mesh.is_alive(Face(i))) all[{"faces", "f" + std::to_string(i), "outer"}] = link(mesh.halfedge(Face(i)));
  return all;
}

bool is_kernel_cell(const Tables& was, const Tables& is, const Cell& cell) {
  return was.contains(cell) || is.contains(cell);
}

void expect_rows_are_the_difference(const steps::Step& step, const Tables& was, const Tables& is) {
  std::set<Cell> told;
  for (const steps::RowChange& row : step.rows) {
    const Cell cell{row.table, row.row, row.field};
    if (row.field == "inner") {
      EXPECT_NE(row.old_value, row.new_value) << row.row << " " << step.caption.en;
    }
    if (!is_kernel_cell(was, is, cell)) continue;
    told.insert(cell);
    EXPECT_EQ(or_none(row.old_value), was.contains(cell) ? was.at(cell) : "-") << step.caption.en;
    EXPECT_EQ(or_none(row.new_value), is.contains(cell) ? is.at(cell) : "-") << step.caption.en;
  }
  for (const Tables* const side : {&was, &is})
    for (const auto& [cell, value] : *side) {
      const auto value_in = [&cell = cell](const Tables& tables) {
        return tables.contains(cell) ? tables.at(cell) : std::string("-");
      };
      const bool differs = value_in(was) != value_in(is);
      EXPECT_EQ(told.contains(cell), differs)
          << std::get<1>(cell) << "." << std::get<2>(cell) << " " << step.caption.en;
    }
}

void expect_whole(const steps::Step& step) {
  EXPECT_NE(step.caption.en, "");
  EXPECT_NE(step.caption.ja, "");
  if (step.source) {
    EXPECT_EQ(step.source->text.size(), 3u);
    EXPECT_NE(step.source->listing_en, "");
    EXPECT_NE(step.source->listing_ja, "");
  }
  for (const steps::RowChange& row : step.rows) {
    EXPECT_NE(row.table, "");
    EXPECT_NE(row.row, "");
    EXPECT_NE(row.field, "");
  }
  for (const steps::Mark& mark : step.marks) EXPECT_NE(mark.element.index, no_index) << step.caption.en;
}

// B, W and I of a delta are what `expect` asks for.
void expect_outside_terms(const steps::Step& step, const Mesh& before, const Mesh& after) {
  const EulerPoincare was = euler_poincare(before), is = euler_poincare(after);
  for (const EulerTerm& term : euler_letters()) {
    if (std::string_view("BWI").find(term.letter) == std::string_view::npos) continue;
    const std::int64_t by = term.letter == 'B' ? *step.delta->b : term.letter == 'W' ? step.delta->w : step.delta->i;
    EXPECT_EQ(*term.value(was) + by, *term.value(is)) << term.letter << ": " << step.caption.en;
  }
}

bool are_equal(const steps::Step& a, const steps::Step& b) {
  return a.caption.en == b.caption.en && a.caption.ja == b.caption.ja && a.marks == b.marks && a.rows == b.rows &&
         a.delta == b.delta;
}

}  // namespace

void expect_plays(steps::Sequence& sequence) {
  ASSERT_GT(sequence.size(), 0u);
  std::vector<std::uint64_t> hashes;
  std::vector<steps::Step> forward;
  for (std::size_t i = 0; i <= sequence.size(); ++i) hashes.push_back(sequence.mesh_at(i).hash());
  for (std::size_t i = 1; i <= sequence.size(); ++i) {
    forward.push_back(sequence.at(i));
    const steps::Step& step = forward.back();
    expect_whole(step);
    const Mesh before = sequence.mesh_at(i - 1), after = sequence.mesh_at(i);
    EXPECT_FALSE(check_invariants(after)) << step.caption.en;
    if (!step.delta) {
      EXPECT_EQ(before.hash(), after.hash()) << step.caption.en;
      continue;
    }
    expect_rows_are_the_difference(step, tables_of(before), tables_of(after));
    if (before.has_copies() || after.has_copies()) continue;
    const KernelSum was = kernel_sum(before), is = kernel_sum(after);
    const steps::Delta& delta = *step.delta;
    const std::array stated{is.vertices - was.vertices,    is.edges - was.edges,           is.faces - was.faces,
                            is.rings - was.rings,          is.components - was.components, is.genus - was.genus,
                            is.boundaries - was.boundaries};
    ASSERT_TRUE(delta.b && delta.g) << step.caption.en;
    const std::array told{delta.v, delta.e, delta.f, delta.h, delta.s, *delta.g, *delta.b + delta.w + delta.i};
    EXPECT_EQ(told, stated) << step.caption.en;
    expect_outside_terms(step, before, after);
  }
  for (std::size_t i = sequence.size(); i > 0; --i) {
    EXPECT_TRUE(are_equal(sequence.at(i), forward[i - 1])) << i;
    EXPECT_EQ(sequence.mesh_at(i - 1).hash(), hashes[i - 1]) << i;
  }
  EXPECT_EQ(sequence.mesh_at(sequence.size()).hash(), hashes.back());
}

}  // namespace ryosen::test
