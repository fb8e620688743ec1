// The halfedges of a mesh built step by step are those of table 5 and the map of text 003.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/names.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/opposite_map.h"
#include "ryosen/textbook/forms/polygons.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/played_steps.h"

namespace ryosen {
namespace {

using namespace test;
using steps::Step;

TEST(build_steps, end_with_the_halfedges_of_table_5_and_the_map_of_text_003) {
  for (const char* const name : {"tetrahedron.off", "fan.obj", "torus.off", "cube.obj", "two_quads.obj"}) {
    const Mesh mesh = asset_mesh(name);
    const auto sequence = played("build", mesh, {});
    PlayedTables tables;
    std::set<std::string> numbers;
    for (std::size_t i = 1; i <= sequence->size(); ++i) {
      const Step step = sequence->at(i);
      replay(tables, step);
      if (step.caption.en.starts_with("(")) numbers.insert(step.caption.en.substr(0, step.caption.en.find(')') + 1));
    }
    EXPECT_EQ(numbers.size(), 10u) << "the steps (1) to (10)";
    const auto name_or_none = [](auto handle) { return handle ? slot_name(handle) : std::string("-"); };
    for (const Halfedge h : forms::corner_halfedges(mesh)) {
      const auto& row = tables["halfedges"].at(slot_name(h));
      EXPECT_EQ(row.at("from"), slot_name(mesh.from(h)));
      EXPECT_EQ(row.at("next"), slot_name(mesh.next(h)));
      EXPECT_EQ(row.at("prev"), slot_name(mesh.prev(h)));
      EXPECT_EQ(row.at("face"), slot_name(mesh.face(h)));
      const Halfedge pair = mesh.is_outside(twin(h)) ? Halfedge() : twin(h);
      EXPECT_EQ(row.contains("twin") ? row.at("twin") : "-", name_or_none(pair)) << name;
    }
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
      const Named<Halfedge> first = find_edge(mesh, tables["vertices"].at("v" + std::to_string(v)).at("halfedge"));
      ASSERT_TRUE(first.ok());
      EXPECT_EQ(mesh.from(first.element), Vertex(v));
    }
    if (forms::why_unsuitable(mesh, *forms::find_form("opposite_map"))) continue;
    const forms::OppositeMap map(mesh);
    EXPECT_EQ(tables["opps"].size(), map.map_size());
    for (std::uint32_t h = 0; h < 3 * map.face_count(); ++h)
      EXPECT_EQ(
          tables["opps"].at(std::to_string(map.from(h)) + "," + std::to_string(map.from(map.next(h)))).at("value"),
          std::to_string(map.coded_opposite(h)));
  }
}

// The lines of program code 2, and of the listing of text 003 that fills opps, as printed, blank lines included, by
// hand.
TEST(build_steps, cite_the_lines_of_the_printed_listings) {
  const auto sequence = played("build", asset_mesh("figures/003-image22.obj"), {});
  std::map<std::string, std::set<int>> lines;
  for (std::size_t i = 1; i <= sequence->size(); ++i) {
    const Step step = sequence->at(i);
    ASSERT_TRUE(step.source);
    const std::string number = step.caption.en.substr(0, step.caption.en.find(')') + 1);
    lines[step.source->text == "003" ? "map" : number].insert(step.source->line);
    EXPECT_EQ(step.source->listing_en,
              step.source->text == "003" ? "building the halfedges, the listing that fills opps" : "program code 2");
  }
  const std::map<std::string, std::set<int>> by_hand{{"(1)", {111}}, {"(2)", {112}}, {"(3)", {113}},   {"(4)", {120}},
                                                     {"(5)", {78}},  {"(6)", {82}},  {"(7)", {86}},    {"(8)", {87}},
                                                     {"(9)", {88}},  {"(10)", {63}}, {"map", {11, 16}}};
  EXPECT_EQ(lines, by_hand);
}

}  // namespace
}  // namespace ryosen
