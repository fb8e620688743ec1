// The text's split of a side, step by step.
#include <gtest/gtest.h>

#include <string>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/opposite_map.h"
#include "ryosen/textbook/forms/source_operators.h"
#include "ryosen/textbook/forms/split_3ij.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/played_steps.h"
#include "tests/support/core/step_checks.h"

namespace ryosen {
namespace {

using namespace test;
using steps::Step;

// The text's hexagon: six faces (i, i + 1, centre 0).
Mesh hexagon_fan() { return asset_mesh("fan.obj"); }

TEST(split3_steps, give_the_numbers_that_the_text_reports_of_its_hexagon) {
  IndexedMesh list;
  list.positions = {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}};
  list.corners = {1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 6, 0, 6, 1, 0};
  list.face_offsets = {0, 3, 6, 9, 12, 15, 18};
  const Mesh mesh = from_indexed(std::move(list));
  forms::OppositeMap by_form(mesh);
  forms::split_edge_3ij(by_form, 1);
  forms::split_edge_3ij(by_form, 4);
  const auto sequence = played("split3", mesh, {"1,4"});
  PlayedTables tables;
  std::string last_dead;
  for (std::size_t i = 1; i <= sequence->size(); ++i) {
    const Step step = sequence->at(i);
    replay(tables, step);
    if (step.caption.en.find("dead keys") != std::string::npos) last_dead = step.caption.en;
  }
  const auto value = [&](std::uint32_t h) {
    const std::string key = std::to_string(by_form.from(h)) + "," + std::to_string(by_form.from(by_form.next(h)));
    const auto row = tables["opps"].find(key);
    return row == tables["opps"].end() ? std::string("as it was") : row->second.at("value");
  };
  EXPECT_EQ(value(1), "3");
  EXPECT_EQ(value(24), "-25");
  for (std::uint32_t h = 0; h < 3 * by_form.face_count(); ++h)
    if (const std::string is = value(h); is != "as it was") {
      EXPECT_EQ(is, std::to_string(by_form.coded_opposite(h))) << h;
    }
  for (const char* const key : {"(0,2)", "(2,0)", "(3,7)", "(7,3)"})
    EXPECT_NE(last_dead.find(key), std::string::npos) << last_dead;
  expect_plays(*sequence);
  EXPECT_EQ(sequence->mesh_at(sequence->size()).live().faces, by_form.face_count());
}

TEST(split3_steps, split_a_boundary_side) {
  const Mesh mesh = hexagon_fan();
  forms::OppositeMap by_form(mesh);
  const auto sequence = played("split3", mesh, {"1"});
  std::uint32_t boundary = no_index;
  for (std::uint32_t h = 0; h < 18 && boundary == no_index; ++h)
    if (by_form.opposite(h) == no_index) boundary = h;
  const auto split = played("split3", mesh, {std::to_string(boundary)});
  forms::split_edge_3ij(by_form, boundary);
  PlayedTables tables;
  for (std::size_t i = 1; i <= split->size(); ++i) replay(tables, split->at(i));
  for (std::uint32_t h = 0; h < 3 * by_form.face_count(); ++h) {
    const auto row =
        tables["opps"].find(std::to_string(by_form.from(h)) + "," + std::to_string(by_form.from(by_form.next(h))));
    if (row != tables["opps"].end()) {
      EXPECT_EQ(row->second.at("value"), std::to_string(by_form.coded_opposite(h))) << h;
    }
  }
  EXPECT_EQ(split->at(split->size()).delta->f, 1);
  expect_plays(*split);
}

std::vector<int> cited_lines(const Mesh& mesh, const std::string& number) {
  const auto sequence = played("split3", mesh, {number});
  std::vector<int> lines;
  for (std::size_t i = 1; i < sequence->size(); ++i) {
    const steps::Source source = *sequence->at(i).source;
    EXPECT_EQ(source.text, "003");
    EXPECT_NE(source.listing_en.find("whole source code"), std::string_view::npos) << "not the two halves before it";
    lines.push_back(source.line);
  }
  return lines;
}

// Of the whole source code as it is printed, blank lines included, counted by hand: at a boundary first.
TEST(split3_steps, cite_the_lines_of_the_printed_source_code) {
  EXPECT_EQ(cited_lines(asset_mesh("figures/003-image36.obj"), "0"),
            (std::vector{154, 158, 163, 169, 173, 178, 182, 183, 184, 187, 188, 189, 192, 195, 198}));
  EXPECT_EQ(cited_lines(asset_mesh("figures/003-image32.obj"), "0"),
            (std::vector{206, 212, 218, 225, 229, 234, 239, 242, 246, 247, 248, 251, 252,
                         253, 256, 257, 258, 261, 262, 263, 266, 270, 274, 278, 281}));
}

}  // namespace
}  // namespace ryosen
