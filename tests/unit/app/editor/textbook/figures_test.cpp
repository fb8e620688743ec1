// The figures of the texts: what the texts say of each.
#include "app/editor/textbook/figures.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "app/editor/session/session.h"
#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/all.h"
#include "ryosen/textbook/forms/opposite_map.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

Mesh mesh_of(std::string_view id) {
  Result<MeshFile> file = mesh_of_figure(*find_figure(id));
  EXPECT_TRUE(file) << id;
  return from_indexed(std::move(file->mesh));
}

std::string file_of(std::string_view id) {
  return test::asset("figures/" + std::string(id) + (id == "000-11" ? ".txt" : ".obj"));
}

TEST(figures, are_the_files_each_with_a_row_and_a_line_in_the_readme) {
  std::set<std::string> files, rows;
  for (const auto& entry : std::filesystem::directory_iterator(test::asset("figures")))
    files.insert(entry.path().stem().string());
  const std::string readme = test::read_file(test::asset("README.md"));
  for (const Figure& figure : figures()) {
    EXPECT_TRUE(rows.insert(std::string(figure.id)).second);
    EXPECT_NE(readme.find("`" + std::filesystem::path(file_of(figure.id)).filename().string() + "`"), readme.npos);
    EXPECT_NE(readme.find(figure.found_en), readme.npos) << figure.id;
    for (const std::string_view text : {figure.name_en, figure.name_ja, figure.found_en, figure.found_ja})
      EXPECT_FALSE(text.empty()) << figure.id;
  }
  EXPECT_EQ(files, rows);
  EXPECT_EQ(figure_files().size(), rows.size());
}

TEST(figures, come_into_the_empty_mesh_as_their_files_are_read_and_go_by_undo) {
  for (const Figure& figure : figures()) {
    Session session(std::make_unique<Document>());
    const std::string line = "figure " + std::string(figure.id);
    const std::uint64_t empty = session.mesh().hash();
    ASSERT_TRUE(session.run(line).done()) << line;
    auto read = read_mesh_file(file_of(figure.id));
    ASSERT_TRUE(read) << line;
    EXPECT_EQ(session.mesh().hash(), from_indexed(std::move(read->mesh)).hash()) << line;
    EXPECT_EQ(session.log().back(), line);
    EXPECT_EQ(session.run(line).exit_code, ExitCode::refused) << "not into a mesh";
    ASSERT_TRUE(session.run("undo").done());
    EXPECT_EQ(session.mesh().live().faces, 0u) << empty;
  }
  Session session(std::make_unique<Document>());
  EXPECT_EQ(session.run("figure 9").exit_code, ExitCode::usage);
}

struct Counts {
  const char* id;
  std::int64_t v, e, f, h, g;
};

TEST(figures, have_the_counts_of_the_text) {
  for (const Counts& expected : {Counts{"000-3", 4, 6, 4, 0, 0},
                                 {"000-4a", 8, 12, 6, 0, 0},
                                 {"000-4b", 16, 24, 10, 2, 1},
                                 {"000-4c", 24, 36, 14, 4, 2},
                                 {"000-11", 448, 1344, 896, 0, 1}}) {
    const Mesh mesh = mesh_of(expected.id);
    EXPECT_EQ(mesh.live().vertices, expected.v) << expected.id;
    EXPECT_EQ(mesh.live().edges, expected.e) << expected.id;
    EXPECT_EQ(mesh.live().faces, expected.f) << expected.id;
    // V - E + F - H = 2 (1 - g)
    EXPECT_EQ(expected.v - expected.e + expected.f - expected.h, 2 * (1 - expected.g)) << expected.id;
  }
  const Mesh fan = mesh_of("003-image22");
  EXPECT_EQ(fan.live().edges, 5u);
  EXPECT_EQ(fan.live().faces, 2u);
}

TEST(figures, begin_with_the_lines_that_the_text_prints) {
  const std::string torus = test::read_file(file_of("000-11"));
  EXPECT_TRUE(
      torus.starts_with("448 896\n-40.000000 0.000000 0.000000\n-42.283615 11.480503 0.000000\n"
                        "-48.786797 21.213203 0.000000\n"));
  EXPECT_NE(torus.find("\n2 18 17\n2 17 1\n3 19 18\n"), torus.npos);
  const Mesh sample = mesh_of("002-sample");
  EXPECT_EQ(sample.position(Vertex(0)), glm::dvec3(0, 10, 0));
  EXPECT_EQ(sample.position(Vertex(1)), glm::dvec3(-10, -10, 0));
  EXPECT_EQ(sample.position(Vertex(2)), glm::dvec3(10, -10, 0));
}

// All points of figure 11 lie at a distance of 30 from the circle of radius 70 about the Y axis, as floats print them.
TEST(figures, torus_has_the_radii_of_the_text) {
  const Mesh torus = mesh_of("000-11");
  for (std::uint32_t i = 0; i < torus.vertex_slots(); ++i) {
    const glm::dvec3 p = torus.position(Vertex(i));
    EXPECT_NEAR(std::hypot(std::hypot(p.x, p.z) - 70, p.y), 30, 1e-5) << i;
  }
}

Verdict verdict(const Mesh& mesh, const std::string& line) {
  const ParsedOp op = parse_line(mesh, line);
  EXPECT_TRUE(op.op) << line;
  return check(mesh, *op.op);
}

TEST(figures, allow_and_refuse_what_the_text_does) {
  EXPECT_TRUE(verdict(mesh_of("000-12"), "collapse 0-1").legal());
  EXPECT_TRUE(verdict(mesh_of("000-13"), "swap 0-1").legal());
  EXPECT_TRUE(verdict(mesh_of("000-14"), "collapse 0-1").has(Rule::common_neighbour));
  EXPECT_TRUE(verdict(mesh_of("000-15"), "swap 0-1").has(Rule::edge_exists));
}

TEST(figures, have_the_opposites_of_the_text) {
  EXPECT_EQ(forms::OppositeMap(mesh_of("003-image24")).coded_opposite(11), 21);
  const forms::OppositeMap first(mesh_of("003-image42")), second(mesh_of("003-image43"));
  EXPECT_NE(first.coded_opposite(2), forms::OppositeMap(mesh_of("003-image41")).coded_opposite(2));
  EXPECT_NE(first.coded_opposite(8), forms::OppositeMap(mesh_of("003-image41")).coded_opposite(8));
  EXPECT_EQ(second.coded_opposite(1), 3);
  EXPECT_EQ(second.coded_opposite(24), -25);
}

}  // namespace
}  // namespace ryosen
