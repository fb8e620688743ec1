// Every algorithm of the table on every kind of mesh of a table: what it makes is whole, and what it gives up leaves no
// trace.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/sound_value.h"

namespace ryosen::test {
namespace {

struct KindOfInput {
  const char* name;
  Mesh mesh;
};

Mesh scaled(const Mesh& mesh, double size) {
  MeshColumns columns = mesh.columns();
  for (glm::dvec3& p : columns.positions) p *= size;
  return Mesh(std::move(columns));
}

// A square with a square hole, as one face with a ring.
Mesh holed_face() {
  Polygons faces;
  for (std::uint32_t y = 0; y < 5; ++y)
    for (std::uint32_t x = 0; x < 5; ++x)
      if (const std::uint32_t a = 6 * y + x; x != 2 || y != 2) faces.push_back({a, a + 1, a + 7, a + 6});
  IndexedMesh list = indexed(faces, 36);
  for (std::uint32_t i = 0; i < 36; ++i) list.positions[i] = {i % 6, i / 6, 0};
  Mesh mesh = from_indexed(list);
  Journal journal;
  EXPECT_EQ(run_algorithm(mesh, journal, "unite_planar").changed, 1u);
  EXPECT_EQ(mesh.live().rings, 1u);
  return mesh;
}

Mesh not_finite() {
  MeshColumns columns = made_by("cube").columns();
  columns.positions[3].y = std::numeric_limits<double>::quiet_NaN();
  columns.positions[5].x = std::numeric_limits<double>::infinity();
  return Mesh(std::move(columns));
}

// Of deleted elements among living ones.
Mesh with_gaps() {
  Mesh mesh = made_by("sphere");
  Journal journal;
  for (const std::uint32_t f : {3u, 9u, 40u}) EXPECT_TRUE(try_apply(mesh, &journal, Delete{Face(f)}));
  return mesh;
}

std::vector<KindOfInput> kinds() {
  return {{"empty", Mesh()},
          {"single triangle", make_mesh({{0, 1, 2}})},
          {"single pentagon", make_mesh({{0, 1, 2, 3, 4}})},
          {"a triangle without area", from_indexed([] {
             IndexedMesh list = indexed({{0, 1, 2}});
             list.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
             return list;
           }())},
          {"points alone", make_mesh({}, 3)},
          {"three faces at an edge", make_mesh(fin())},
          {"two cones at a point", make_mesh(bow_tie())},
          {"two solids at an edge", make_mesh(two_tetrahedra_on_an_edge())},
          {"a face twice", make_mesh({{0, 1, 2}, {0, 1, 2}})},
          {"one-sided", make_mesh(moebius_strip())},
          {"closed", made_by("cube")},
          {"with a hole", holed_face()},
          {"of genus 1", made_by("torus")},
          {"with deleted elements", with_gaps()},
          {"huge", scaled(made_by("sphere"), 1e300)},
          {"tiny", scaled(made_by("sphere"), 1e-300)},
          {"far away",
           [] {
             MeshColumns columns = made_by("sphere").columns();
             for (glm::dvec3& p : columns.positions) p += glm::dvec3(1e12);
             return Mesh(std::move(columns));
           }()},
          {"not finite", not_finite()}};
}

std::string usual_line(const AlgorithmRow& row) {
  std::string line;
  for (const ParameterRow& parameter : row.parameters)
    if (must_be_given(row.parameters, parameter))
      line.append(line.empty() ? "" : " ").append(parameter.id).append("=").append(sound_value(parameter));
  return line;
}

std::size_t not_finite_places(const Mesh& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.positions().begin(), mesh.positions().end(),
                                                [](const glm::dvec3& p) { return !is_finite(p); }));
}

TEST(every_mesh, comes_out_whole_of_every_algorithm_and_back_by_undo) {
  for (const KindOfInput& kind : kinds())
    for (const AlgorithmRow& row : algorithm_table()) {
      SCOPED_TRACE(std::string(row.id) + " on " + kind.name);
      Mesh mesh = kind.mesh;
      const ReadValues values = read_values(row.parameters, split_words(usual_line(row))).values->on(mesh);
      if (!values.values) {  // an element that is not there
        EXPECT_FALSE(values.sentence.en.empty());
        continue;
      }
      const AlgorithmInput input{*values.values};
      Journal journal;
      AlgorithmResult result;
      {
        Progress unheard;
        Edit edit(mesh, &journal);
        result = row.run(edit, input, unheard);
        if (result.changed > 0) edit.commit();
      }
      for (const std::optional<Text>& sentence : {result.fault, result.refused}) {
        if (!sentence) continue;
        EXPECT_FALSE(sentence->en.empty() || sentence->ja.empty());
        EXPECT_EQ(result.changed, 0u);
      }
      const auto broken = check_invariants(mesh);
      EXPECT_FALSE(broken) << broken->sentence;
      EXPECT_TRUE(not_finite_places(kind.mesh) > 0 || not_finite_places(mesh) == 0);
      if (result.changed > 0) journal.undo(mesh);
      EXPECT_EQ(mesh.columns(), kind.mesh.columns());
    }
}

TEST(every_mesh, is_left_to_the_byte_where_an_algorithm_is_cancelled_at_any_moment) {
  Dice dice(5);
  const Mesh mesh_then = made_by("torus");
  for (const AlgorithmRow& row : algorithm_table()) {
    Mesh mesh = mesh_then;
    const AlgorithmInput input{*read_values(row.parameters, split_words(usual_line(row))).values->on(mesh).values};
    std::size_t reports = 0;
    {
      Progress counting([&](double) { return ++reports > 0; }, Progress::Clock::duration::zero());
      Edit edit(mesh, nullptr);
      row.run(edit, input, counting);
    }
    for (int turn = 0; turn < 4 && reports > 0; ++turn) {
      mesh = mesh_then;
      std::size_t left = static_cast<std::size_t>(dice.below(static_cast<int>(reports)));
      Progress progress([&](double) { return left-- > 0; }, Progress::Clock::duration::zero());
      Journal journal;
      {
        Edit edit(mesh, &journal);
        row.run(edit, input, progress);
      }
      EXPECT_TRUE(progress.is_cancelled()) << row.id;
      EXPECT_EQ(mesh.columns(), mesh_then.columns()) << row.id;
    }
  }
}

TEST(every_mesh, has_values_of_no_sense_refused_with_a_sentence_or_done_without_harm) {
  for (const AlgorithmRow& row : algorithm_table())
    for (const ParameterRow& parameter : row.parameters)
      for (const char* text : {"0", "-1", "nan", "inf", "1e300", "-1e300", "999999999", "v999999", ""}) {
        SCOPED_TRACE(std::string(row.id) + " " + std::string(parameter.id) + "=" + text);
        if (row.is_primitive && parameter.kind == ParameterKind::count) continue;  // a shape as large as was asked for
        ParameterValues values = *read_values(row.parameters, split_words(usual_line(row))).values;
        if (const auto fault = values.set(parameter.id, text, parameter.id)) {
          EXPECT_FALSE(fault->en.empty() || fault->ja.empty());
          continue;
        }
        Mesh mesh = made_by("icosahedron");
        const MeshColumns before = mesh.columns();
        const ReadValues found = values.on(mesh);
        if (!found.values) {
          EXPECT_FALSE(found.sentence.en.empty());
          continue;
        }
        Journal journal;
        {
          Progress unheard;
          Edit edit(mesh, &journal);
          const AlgorithmResult result = row.run(edit, {*found.values}, unheard);
          if (result.changed > 0) edit.commit();
          if (result.fault) {
            EXPECT_FALSE(result.fault->en.empty());
          }
        }
        EXPECT_FALSE(check_invariants(mesh));
        if (journal.can_undo()) journal.undo(mesh);
        EXPECT_EQ(mesh.columns(), before);
      }
}

}  // namespace
}  // namespace ryosen::test
