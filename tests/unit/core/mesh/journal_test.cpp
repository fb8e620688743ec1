#include "ryosen/mesh/journal.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

Mesh bunny() {
  Result<MeshFile> file = read_mesh_file(RYOSEN_SOURCE_DIR "/assets/stanford_bunny.obj");
  EXPECT_TRUE(file);
  return file ? from_indexed(std::move(file->mesh)) : Mesh();
}

AnyOp random_op(const Mesh& mesh, int kind, std::mt19937& random) {
  Halfedge h;
  do h = Halfedge(random() % mesh.halfedge_slots());
  while (!mesh.is_alive(h));
  if (kind == 0) return CollapseEdge{h, CollapseEdge::Place::middle};
  if (kind == 1) return SwapEdge{h};
  return SplitEdge{h};
}

TEST(journal, appends_at_most_256_bytes_per_operation) {
  Mesh mesh = bunny();
  const MeshColumns start = mesh.columns();
  Journal journal;
  std::mt19937 random(1);
  constexpr int operations = 10000;
  for (int done = 0; done < operations;) {
    const AnyOp op = random_op(mesh, done % 3, random);
    if (!check(mesh, op).legal()) continue;
    Edit edit(mesh, &journal);
    apply(edit, op);
    edit.commit();
    ++done;
  }
  const double mean = static_cast<double>(journal.bytes()) / operations;
  RecordProperty("bytes_per_operation", std::to_string(mean));
  EXPECT_LE(mean, 256);
  EXPECT_GT(mean, 50);  // that many bytes do change
  const MeshColumns end = mesh.columns();
  while (journal.can_undo()) journal.undo(mesh);
  EXPECT_EQ(mesh.columns(), start);
  while (journal.can_redo()) journal.redo(mesh);
  EXPECT_EQ(mesh.columns(), end);
  EXPECT_EQ(journal.bytes(), static_cast<std::size_t>(mean * operations + 0.5));
}

TEST(journal, names_each_cell_once) {
  Mesh mesh = make_mesh(tetrahedron());
  Journal journal;
  Edit edit(mesh, &journal);
  for (int i = 0; i < 3; ++i) edit.set_position(Vertex(2), glm::dvec3(i + 5));
  edit.set_position(Vertex(1), glm::dvec3(7));
  edit.commit();
  const std::vector<TouchedCell> cells = journal.touched(0);
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(cells[0].column, Column::position);
  EXPECT_EQ(cells[0].index, 2u);
  EXPECT_EQ(cells[1].index, 1u);
}

TEST(journal, exchanges_a_cell_that_was_written_twice) {
  Mesh mesh = make_mesh(tetrahedron());
  const MeshColumns start = mesh.columns();
  Journal journal;
  {
    Edit edit(mesh, &journal);
    edit.set_position(Vertex(2), glm::dvec3(5));
    edit.set_position(Vertex(2), glm::dvec3(6));
    edit.fresh(edit.add_vertex(glm::dvec3(1)));
    edit.commit();
  }
  const MeshColumns end = mesh.columns();
  for (int i = 0; i < 2; ++i) {
    journal.undo(mesh);
    EXPECT_EQ(mesh.columns(), start);
    EXPECT_EQ(journal.lengths_after(mesh, 0).vertices, start.positions.size() + 1);
    journal.redo(mesh);
    EXPECT_EQ(mesh.columns(), end);
    EXPECT_EQ(journal.lengths_after(mesh, 0).vertices, end.positions.size());
    EXPECT_EQ(journal.lengths_before(0).vertices, start.positions.size());
  }
  {
    Edit edit(mesh, &journal);
    edit.set_position(Vertex(2), glm::dvec3(7));
    edit.set_position(Vertex(2), glm::dvec3(8));
  }
  EXPECT_EQ(mesh.columns(), end);
}

// What was undone is dropped by a commit and kept by an edit that is not committed; replaced columns among it.
TEST(journal, drops_what_was_undone) {
  Mesh mesh = make_mesh(cube());
  Journal journal;
  std::vector<MeshColumns> states{mesh.columns()};
  const auto move = [&](double to) {
    Edit edit(mesh, &journal);
    edit.set_position(Vertex(0), glm::dvec3(to));
    edit.fresh(edit.add_vertex(glm::dvec3(to)));
    edit.commit();
    states.push_back(mesh.columns());
  };
  const auto replace = [&] {
    MeshColumns other = mesh.columns();
    other.positions[1] = glm::dvec3(99);
    Edit edit(mesh, &journal);
    edit.replace_by_other(std::move(other));
    edit.commit();
    states.push_back(mesh.columns());
  };
  move(1);
  replace();
  move(2);
  replace();
  EXPECT_FALSE(journal.replaces_everything(0));
  EXPECT_TRUE(journal.replaces_everything(1));
  for (std::size_t i = states.size() - 1; i-- > 1;) {
    journal.undo(mesh);
    EXPECT_EQ(mesh.columns(), states[i]);
  }
  {
    Edit edit(mesh, &journal);
    edit.set_position(Vertex(0), glm::dvec3(50));
  }
  ASSERT_EQ(journal.size(), 4u);
  for (std::size_t i = 2; i < states.size(); ++i) {
    journal.redo(mesh);
    EXPECT_EQ(mesh.columns(), states[i]);
  }
  for (int i = 0; i < 3; ++i) journal.undo(mesh);
  states.resize(2);
  move(3);
  EXPECT_EQ(journal.size(), 2u);
  EXPECT_FALSE(journal.can_redo());
  EXPECT_FALSE(journal.replaces_everything(1));
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    journal.undo(mesh);
    EXPECT_EQ(mesh.columns(), states[i]);
  }
}

TEST(journal, marks_agree_with_a_set) {
  std::mt19937 random(3);
  CellMarks marks;
  for (int round = 0; round < 50; ++round) {
    std::set<std::pair<Column, std::uint32_t>> expected;
    marks.clear();
    for (int i = 0; i < 1 << (round % 12); ++i) {
      const auto column = static_cast<Column>(random() % 9);
      const auto index = static_cast<std::uint32_t>(random() % 300);
      ASSERT_EQ(marks.insert(column, index), expected.emplace(column, index).second);
    }
  }
}

}  // namespace
}  // namespace ryosen
