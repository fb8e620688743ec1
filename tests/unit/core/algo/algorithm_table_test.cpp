// Every row of the table of algorithms, and one that the program does not have.
#include "ryosen/algo/algorithm_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "ryosen/base/number_text.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/scatter_algorithm.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/sound_value.h"

namespace ryosen::test {
namespace {

ReadValues read(const AlgorithmRow& row, std::string_view line) {
  return read_values(row.parameters, split_words(line));
}

// Texts that no parameter of the kind takes.
std::vector<std::string> malformed_values(const ParameterRow& row) {
  std::vector<std::string> texts{"", "?", "1e999", "nan", "1,,2"};
  if (row.kind == ParameterKind::count) texts.insert(texts.end(), {"1.5", "-1", "3%"});
  if (row.kind == ParameterKind::length) texts.insert(texts.end(), {"-1", "-1%", "%"});
  if (row.kind == ParameterKind::ratio) texts.insert(texts.end(), {"-0.1", "1.1", "50%"});
  if (row.kind == ParameterKind::angle) texts.insert(texts.end(), {"-1", "181"});
  if (row.kind == ParameterKind::place)
    texts.insert(texts.end(), {"1", "1,2", "1,2,3,4", "1,2,x", "1,2,1e999", "1%,2,3"});
  if (row.smallest) texts.push_back(format_double(*row.smallest - 1));
  if (row.smallest && row.excludes_smallest) texts.push_back(format_double(*row.smallest));
  if (row.largest) texts.push_back(format_double(*row.largest + 1));
  return texts;
}

std::string sound_line(const AlgorithmRow& row, bool only_required = false) {
  std::string line;
  for (const ParameterRow& parameter : row.parameters)
    if (must_be_given(row.parameters, parameter) || !only_required)
      line.append(line.empty() ? "" : " ").append(parameter.id).append("=").append(sound_value(parameter));
  return line;
}

class Algorithms : public testing::Test {
  const ScopedAlgorithm scatter_{scatter_row()};
};

TEST_F(Algorithms, rows_are_whole) {
  std::set<std::string_view> ids;
  for (const AlgorithmRow& row : algorithm_table()) {
    EXPECT_EQ(find_algorithm(row.id), &row);
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_FALSE(row.name_en.empty() || row.name_ja.empty() || row.help_en.empty() || row.help_ja.empty()) << row.id;
    EXPECT_NE(row.run, nullptr) << row.id;
    std::set<std::string_view> names;
    for (const ParameterRow& parameter : row.parameters) {
      EXPECT_TRUE(names.insert(parameter.id).second) << parameter.id;
      EXPECT_FALSE(parameter.name_en.empty() || parameter.name_ja.empty()) << parameter.id;
      EXPECT_FALSE(parameter.help_en.empty() || parameter.help_ja.empty()) << parameter.id;
      EXPECT_EQ(parameter.kind == ParameterKind::choice, parameter.choices.size() > 1) << parameter.id;
      EXPECT_FALSE((parameter.is_required || !parameter.one_of.empty()) && !parameter.initial.empty()) << parameter.id;
      EXPECT_FALSE(parameter.is_required && !parameter.one_of.empty()) << parameter.id;
      if (!parameter.one_of.empty()) {
        std::string alternatives;
        for (const ParameterRow& other : row.parameters)
          if (other.one_of == parameter.one_of) alternatives.append(alternatives.empty() ? "" : ", ").append(other.id);
        EXPECT_EQ(alternatives, parameter.one_of) << row.id;
      }
      ParameterValues values(row.parameters);
      EXPECT_EQ(values.has(parameter.id), !parameter.initial.empty()) << "the initial value is out of range";
      // What `ryosen repair` does unasked cannot ask for a value.
      EXPECT_FALSE(row.keeps_geometry && row.is_repair() && parameter.is_required) << row.id;
      // `ryosen repair --kinds` has one value for each.
      EXPECT_FALSE(row.is_repair() && parameter.is_required && &parameter != &row.parameters[0]) << row.id;
    }
  }
  EXPECT_EQ(find_algorithm("no_such"), nullptr);
  EXPECT_TRUE(find_algorithm("scatter"));
}

TEST_F(Algorithms, values_are_read_back_as_they_are_written) {
  for (const AlgorithmRow& row : algorithm_table()) {
    const ReadValues values = read(row, sound_line(row));
    ASSERT_TRUE(values.values) << row.id << ": " << values.sentence.en;
    EXPECT_EQ(values.values->line(), sound_line(row));
    EXPECT_EQ(read(row, values.values->line()).values->line(), sound_line(row));
  }
}

TEST_F(Algorithms, malformed_values_are_refused_and_what_is_expected_is_said) {
  for (const AlgorithmRow& row : algorithm_table()) {
    for (const ParameterRow& parameter : row.parameters) {
      const Text expected = expected_value(parameter);
      EXPECT_NE(expected.en, expected.ja);
      EXPECT_EQ(expected.en.find("e+"), std::string::npos) << row.id << ": " << expected.en;
      for (const std::string& text : malformed_values(parameter)) {
        ParameterValues values(row.parameters);
        const auto fault = values.set(parameter.id, text, "--it");
        ASSERT_TRUE(fault) << parameter.id << "=" << text;
        EXPECT_EQ(fault->en, "--it is " + expected.en + ", not '" + text + "'");
        EXPECT_NE(fault->ja.find(expected.ja), std::string::npos) << fault->ja;
      }
      if (must_be_given(row.parameters, parameter)) {
        EXPECT_FALSE(read(row, "").values) << row.id;
      }
    }
    for (const char* line : {"nonsense=1", "nonsense"}) EXPECT_FALSE(read(row, line).values) << row.id << " " << line;
  }
}

TEST_F(Algorithms, say_range_and_unit_of_a_value) {
  const AlgorithmRow& row = *find_algorithm("scatter");
  const auto expected = [&](std::size_t i) { return expected_value(row.parameters[i]); };
  EXPECT_EQ(expected(0).en, "a length from 0 up, in units of the mesh or with % of its diagonal");
  EXPECT_EQ(expected(0).ja, "長さ（0 以上、メッシュの単位、% を付けると対角線に対する割合）");
  EXPECT_EQ(expected(1).en, "a number above -5 to 5");
  EXPECT_EQ(expected(1).ja, "数（-5 より大きく 5 以下）");
  EXPECT_EQ(expected(2).en, "a whole number from 1 up, vertices");
  EXPECT_EQ(expected(3).en, "a ratio from 0 to 1");
  EXPECT_EQ(expected(4).en, "an angle from 0 to 180, in degrees");
  EXPECT_EQ(expected(5).en, "a place X,Y,Z, in units of the mesh");
  EXPECT_EQ(expected(5).ja, "座標 X,Y,Z（メッシュの単位）");
  EXPECT_EQ(expected(6).en, "one of up, down");
  EXPECT_EQ(expected(7).en, "on or off");
  EXPECT_EQ(described(row.parameters[3]).en, "a ratio from 0 to 1; else 0.5");
  EXPECT_EQ(
      syntax_of(row.parameters),
      "distance=LENGTH [x=NUMBER] [copies=COUNT] [share=RATIO] [angle=ANGLE] [by=X,Y,Z] [way=up|down] [mirror=on|off] "
      "at=NAME,...");
  EXPECT_EQ(read(row, "distance=1 distance=2").sentence.en, "distance is given twice");
  EXPECT_EQ(read(row, "1 at=f0").values->text("distance"), "1") << "the first may go without its name";
  EXPECT_FALSE(read(row, "distance=1 f0").values) << "no other may";
}

TEST_F(Algorithms, lengths_and_elements_are_those_of_the_mesh) {
  const AlgorithmRow& row = *find_algorithm("scatter");
  IndexedMesh source = indexed({{0, 1, 2}});
  source.positions = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};  // a diagonal of 5
  Mesh mesh = from_indexed(source);
  const ParameterValues given = *read(row, "distance=10% angle=180 way=down share=1 by=1,-2,0.5 at=v1,f0,0-2").values;
  EXPECT_EQ(given.text("distance"), "10%");
  const ReadValues found = given.on(mesh);
  ASSERT_TRUE(found.values) << found.sentence.en;
  EXPECT_DOUBLE_EQ(found.values->length("distance"), 0.5);
  ASSERT_EQ(found.values->elements("at").size(), 3u);
  EXPECT_EQ(found.values->elements("at")[1], Element(Face(0)));
  Progress unheard;
  Edit edit(mesh, nullptr);
  EXPECT_EQ(row.run(edit, {*found.values, {}, 0}, unheard).changed, 1u);
  edit.commit();
  EXPECT_EQ(mesh.position(Vertex(3)), glm::dvec3(1, -1.5, 4));
  const ReadValues missing = read(row, "distance=1 at=v1,v9").values->on(mesh);
  EXPECT_FALSE(missing.values);
  EXPECT_EQ(missing.error, NameError::never_existed);
  EXPECT_EQ(missing.name, "v9");
}

// Something for every row: a sheet with a hole, three faces on an edge, a face twice, a face turned against its
// neighbour, corners on a line, an edge torn open, a point on an edge, points next to each other, vertices without a
// face, and a solid.
Mesh mesh_of_all_defects() {
  IndexedMesh source;
  const auto add = [&](const std::vector<glm::dvec3>& places, const Polygons& faces) {
    const auto first = static_cast<std::uint32_t>(source.positions.size());
    source.positions.insert(source.positions.end(), places.begin(), places.end());
    for (const std::vector<std::uint32_t>& face : faces) {
      for (const std::uint32_t corner : face) source.corners.push_back(first + corner);
      source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
    }
  };
  std::vector<glm::dvec3> grid;
  Polygons squares;
  for (std::uint32_t y = 0; y < 6; ++y)
    for (std::uint32_t x = 0; x < 6; ++x) {
      grid.emplace_back(3 * x, 3 * y, 0);
      if (x < 5 && y < 5 && (x != 2 || y != 2))
        squares.push_back({6 * y + x, 6 * y + x + 1, 6 * y + x + 7, 6 * y + x + 6});
    }
  add(grid, squares);
  add({{0, 0, 40}, {9, 0, 40}, {0, 9, 40}, {0, -9, 40}, {0, 0, 49}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  add({{0, 0, 60}, {9, 0, 60}, {0, 9, 60}}, {{0, 1, 2}, {0, 1, 2}});
  add({{0, 0, 80}, {9, 0, 80}, {0, 9, 80}, {9, 9, 80}}, {{0, 1, 2}, {1, 2, 3}});
  add({{0, 0, 100}, {9, 0, 100}, {4, 0, 100}, {4, 9, 100}}, {{0, 1, 2}, {0, 3, 1}});
  add({{0, 0, 120}, {9, 0, 120}, {0, 9, 120}, {0, 0, 120}, {9, 0, 120}, {0, -9, 120}}, {{0, 1, 2}, {4, 3, 5}});
  add({{0, 0, 140}, {9, 0, 140}, {0, 9, 140}, {4, 0, 140}, {0, -9, 140}}, {{0, 1, 2}, {3, 0, 4}, {1, 3, 4}});
  add({{0, 0, 140}, {9, 0, 140}, {0, 9, 140}, {0, -0.5, 140}, {9, -0.5, 140}, {0, -9, 140}}, {{0, 1, 2}, {4, 3, 5}});
  add({{0, 0, 160}, {9, 0, 160}}, {});
  add({{0, 0, 180}, {9, 0, 180}, {0, 9, 180}, {0, 0, 189}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  return from_indexed(source);
}

TEST_F(Algorithms, undo_is_exact_and_cancelling_leaves_no_trace) {
  constexpr std::size_t most_reports = 20;
  for (const AlgorithmRow& row : algorithm_table()) {
    Mesh mesh = mesh_of_all_defects();
    if (std::find(row.solves.begin(), row.solves.end(), ProblemKind::nonfinite_vertex) != row.solves.end()) {
      Edit edit(mesh, nullptr);  // with which not every other one has something to do
      edit.set_position(Vertex(7), glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
      edit.commit();
    }
    const ReadValues given = read(row, sound_line(row, true));
    const AlgorithmInput input{*given.values->on(mesh).values, {}, 1};
    const MeshColumns before = mesh.columns();
    Journal journal;
    // Cancelled at the first report, at the second, and so on until it comes to its end.
    bool is_cancelled = true;
    for (std::size_t reports = 0; is_cancelled && reports < most_reports; ++reports) {
      std::size_t heard = 0;
      Progress progress([&](double) { return heard++ < reports; }, Progress::Clock::duration::zero());
      {
        Edit edit(mesh, &journal);
        row.run(edit, input, progress);
      }
      is_cancelled = progress.is_cancelled();
      EXPECT_EQ(mesh.columns(), before) << row.id << " " << reports;
      EXPECT_FALSE(journal.can_undo()) << row.id;
    }
    {
      Progress unheard;
      Edit edit(mesh, &journal);
      const AlgorithmResult result = row.run(edit, input, unheard);
      EXPECT_GT(result.changed, 0u) << row.id;
      EXPECT_FALSE(result.text.en.empty() || result.text.ja.empty()) << row.id;
      EXPECT_TRUE(mesh.columns() != before || result.drops_quarantined) << row.id;
      edit.commit();
    }
    const MeshColumns after = mesh.columns();
    journal.undo(mesh);
    EXPECT_EQ(mesh.columns(), before) << row.id;
    journal.redo(mesh);
    EXPECT_EQ(mesh.columns(), after) << row.id;
  }
}

}  // namespace
}  // namespace ryosen::test
