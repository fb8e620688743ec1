// The text's listing, step by step: what it writes, and what it does to the kernel's mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ryosen/mesh/names.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/halfedge_table.h"
#include "ryosen/textbook/forms/polygons.h"
#include "ryosen/textbook/forms/source_operators.h"
#include "ryosen/textbook/steps/all.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/played_steps.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/stated_changes.h"
#include "tests/support/core/step_checks.h"

namespace ryosen {
namespace {

using namespace test;
using steps::Sequence;
using steps::Step;

// The listing's writes replayed on the table of table 5, against the listing as it runs in one go.
void expect_listing(const Mesh& mesh, const std::string& id, Halfedge start) {
  const std::string edge = std::to_string(mesh.from(start).index) + "-" + std::to_string(mesh.to(start).index);
  const auto sequence = played(id, mesh, {edge});
  PlayedTables tables;
  for (std::size_t i = 1; i < sequence->size(); ++i) replay(tables, sequence->at(i));
  const std::vector<Halfedge> corners = forms::corner_halfedges(mesh);
  forms::HalfedgeTable table = forms::inner_halfedges(mesh);
  const auto he = static_cast<std::uint32_t>(std::find(corners.begin(), corners.end(), start) - corners.begin());
  const forms::SourceOutcome outcome =
      id == "collapse" ? forms::source_collapse(table, he) : forms::source_swap(table, he);
  const Step last = sequence->at(sequence->size() - 1);
  EXPECT_EQ(last.caption.en.find("has no pair") == std::string::npos, outcome.completed) << edge << last.caption.en;
  if (!outcome.completed) {
    EXPECT_EQ(last.caption.en.find("half done") != std::string::npos, outcome.changed_before) << edge;
  }
  for (const auto& [row, fields] : tables["text_halfedges"]) {
    const auto h = static_cast<std::uint32_t>(std::find(corners.begin(), corners.end(), find_edge(mesh, row).element) -
                                              corners.begin());
    const forms::HalfedgeTable::Record& record = table.halfedges[h];
    if (fields.contains("from")) {
      EXPECT_EQ(fields.at("from"), record.vertex == no_index ? "-" : "v" + std::to_string(record.vertex)) << row;
    }
    if (fields.contains("twin")) {
      EXPECT_EQ(fields.at("twin"), record.pair == no_index ? "-" : slot_name(corners[record.pair])) << row;
    }
  }
  for (const auto& [row, fields] : tables["text_vertices"]) {
    const std::uint32_t h = table.vertex_halfedge[std::stoul(row.substr(1))];
    if (fields.contains("halfedge")) {
      EXPECT_EQ(fields.at("halfedge"), h == no_index ? "-" : slot_name(corners[h])) << id << edge << row;
    }
  }
  expect_plays(*sequence);
}

TEST(listing_steps, are_the_listing_of_the_text) {
  for (const char* const name : {"torus.off", "fan.obj", "tetrahedron.off"}) {
    const Mesh mesh = asset_mesh(name);
    std::size_t done = 0;
    for (const Halfedge h : forms::corner_halfedges(mesh)) {
      if (++done % 7 != 0 && mesh.live().faces > 20) continue;
      for (const char* const id : {"collapse", "swap"}) expect_listing(mesh, id, h);
    }
  }
}

TEST(listing_steps, label_ten_halfedges_and_agree_with_the_kernel_where_that_is_legal) {
  const Mesh mesh = asset_mesh("torus.off");
  for (const char* const id : {"collapse", "swap"}) {
    const auto sequence = played(id, mesh, {"0-1"});
    for (std::size_t i = 1; i < sequence->size(); ++i) {
      std::map<std::string_view, std::set<Element>> labels;
      for (const steps::Mark& mark : sequence->at(i).marks)
        if (steps::row_of(mark.role).is_label) labels[steps::row_of(mark.role).id].insert(mark.element);
      EXPECT_EQ(labels.size(), 10u) << "while the code runs, " << i;
      for (const auto& [label, elements] : labels) EXPECT_EQ(elements.size(), 1u) << label << ", " << i;
    }
    const Step kernel = sequence->at(sequence->size());
    ASSERT_TRUE(kernel.delta);
    EXPECT_EQ(kernel.delta->v, id == std::string("collapse") ? -1 : 0);
    EXPECT_NE(kernel.caption.en.find("gives the same faces"), std::string::npos) << kernel.caption.en;
  }
  const auto refused = played("collapse", asset_mesh("tetrahedron.off"), {"0-1"});
  const Step kernel = refused->at(refused->size());
  EXPECT_FALSE(kernel.delta);
  EXPECT_NE(kernel.caption.en.find("refused"), std::string::npos);
  EXPECT_NE(kernel.caption.en.find("does it all the same"), std::string::npos);
}

// What a player does to the kernel's mesh changes the terms as the header of the operator promises. The edits it made.
int expect_promised(Sequence& sequence, std::string_view op_id, Halfedge h) {
  int edits = 0;
  for (std::size_t i = 1; i <= sequence.size(); ++i) {
    const Step step = sequence.at(i);
    if (!step.delta) continue;
    const Mesh before = sequence.mesh_at(i - 1);
    const Change change{step.delta->v,
                        step.delta->e,
                        step.delta->f,
                        step.delta->h,
                        step.delta->s,
                        step.delta->g.value_or(0),
                        *step.delta->b + step.delta->w + step.delta->i};
    const std::vector<Change> stated = law_of(Stated{before}, op_at(before, op_id, {h, 0.5}));
    EXPECT_TRUE(std::count(stated.begin(), stated.end(), change)) << op_id << ": " << step.caption.en;
    ++edits;
  }
  return edits;
}

TEST(listing_steps, change_the_terms_as_their_operators_promise) {
  int edits = 0;
  for (const char* const name : {"torus.off", "fan.obj", "figures/000-12.obj", "figures/000-13.obj"}) {
    const Mesh mesh = asset_mesh(name);
    const std::vector<Halfedge> corners = forms::corner_halfedges(mesh);
    for (std::size_t c = 0; c < corners.size(); c += 1 + corners.size() / 12) {
      const Halfedge h = corners[c];
      const std::string edge_name = std::to_string(mesh.from(h).index) + "-" + std::to_string(mesh.to(h).index);
      for (const char* const id : {"collapse", "swap"}) edits += expect_promised(*played(id, mesh, {edge_name}), id, h);
      EXPECT_EQ(expect_promised(*played("split3", mesh, {std::to_string(c)}), "split", h), 1);
    }
  }
  EXPECT_GT(edits, 40);
}

// The lines of program code 4 as it is printed, blank lines included, counted by hand.
TEST(listing_steps, cite_the_lines_of_the_printed_listing) {
  const Mesh mesh = asset_mesh("figures/000-12.obj");
  const std::vector<std::pair<const char*, std::vector<int>>> cited{
      {"collapse", {34, 35, 36, 37, 40, 46, 47, 48, 52, 54, 55, 59, 60, 63, 64, 65}},
      {"swap", {69, 70, 71, 72, 75, 76, 77, 78, 81, 82, 83, 84, 85, 86, 89, 90, 91, 92}}};
  for (const auto& [id, lines] : cited) {
    const auto sequence = played(id, mesh, {"0-1"});
    std::set<int> found;
    for (std::size_t i = 1; i <= sequence->size(); ++i)
      if (const auto source = sequence->at(i).source; source && source->line > 0) {
        EXPECT_EQ(source->text, "000");
        EXPECT_EQ(source->listing_en, "program code 4");
        found.insert(source->line);
      }
    EXPECT_EQ(std::vector<int>(found.begin(), found.end()), lines) << id;
  }
}

// Two triangles, 0 1 2 and 1 0 3, with more of them around. The pair that was never set is followed where he1 is
// written to (54), where heRT and heLT or heLB and heRB are joined (59, 60), where he->pair leads on (36, 71), or where
// a vertex is read from beyond (81 to 86).
TEST(listing_steps, end_in_the_line_that_follows_a_link_never_set) {
  struct Gap {
    const char* id;
    Polygons faces;
    int line;
  };
  const Polygons::value_type left_top{0, 2, 4}, left_bottom{3, 0, 5}, right_top{2, 1, 6}, right_bottom{1, 3, 7};
  const Gap gaps[] = {
      {"collapse", {{0, 1, 2}}, 36},
      {"swap", {{0, 1, 2}}, 71},
      {"collapse", {{0, 1, 2}, {1, 0, 3}}, 54},
      {"collapse", {{0, 1, 2}, {1, 0, 3}, right_top, right_bottom}, 54},
      {"collapse", {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {0, 4, 3}}, 59},
      {"collapse", {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {0, 4, 3}, right_top}, 60},
      {"swap", {{0, 1, 2}, {1, 0, 3}}, 81},
      {"swap", {{0, 1, 2}, {1, 0, 3}, left_bottom}, 82},
      {"swap", {{0, 1, 2}, {1, 0, 3}, left_bottom, right_top}, 83},
      {"swap", {{0, 1, 2}, {1, 0, 3}, left_bottom, right_top, left_top}, 86},
  };
  for (const Gap& gap : gaps) {
    const auto sequence = played(gap.id, make_mesh(gap.faces), {"0-1"});
    const Step last = sequence->at(sequence->size() - 1);
    EXPECT_NE(last.caption.en.find("has no pair"), std::string::npos) << gap.line << ": " << last.caption.en;
    ASSERT_TRUE(last.source) << gap.line;
    EXPECT_EQ(last.source->line, gap.line) << gap.id << ": " << last.caption.en;
  }
}

}  // namespace
}  // namespace ryosen
