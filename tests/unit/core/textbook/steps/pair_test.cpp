// Sides joined step by step: the pairs at the end are those of the kernel, and the comparisons those of the text.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ryosen/mesh/names.h"
#include "ryosen/ops/all.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/pairing.h"
#include "ryosen/textbook/forms/polygons.h"
#include "ryosen/textbook/steps/all.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/played_steps.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/step_checks.h"

namespace ryosen {
namespace {

using namespace test;
using steps::Sequence;
using steps::Step;

// The pairs that the steps leave, by corner.
SidePartners partners_of(Sequence& sequence, const Mesh& mesh) {
  PlayedTables tables;
  for (std::size_t i = 1; i <= sequence.size(); ++i) replay(tables, sequence.at(i));
  std::map<std::string, std::uint32_t> corner_of;
  const std::vector<Halfedge> corners = forms::corner_halfedges(mesh);
  for (std::uint32_t c = 0; c < corners.size(); ++c) corner_of[slot_name(corners[c])] = c;
  SidePartners partners(corners.size(), no_index);
  for (const auto& [row, fields] : tables["pairs"])
    if (fields.at("pair") != "-") partners[corner_of.at(row)] = corner_of.at(fields.at("pair"));
  return partners;
}

SidePartners pairing_of_kernel(const Mesh& mesh) {
  std::vector<std::uint32_t> corner_of(mesh.halfedge_slots(), no_index);
  const std::vector<Halfedge> corners = forms::corner_halfedges(mesh);
  for (std::uint32_t c = 0; c < corners.size(); ++c) corner_of[corners[c].index] = c;
  SidePartners partners;
  for (const Halfedge h : corners) partners.push_back(corner_of[twin(h).index]);
  return partners;
}

TEST(pair_steps, end_with_the_pairing_of_the_kernel) {
  std::vector<Mesh> meshes;
  for (const char* const name : {"tetrahedron.off", "fan.obj", "cube.obj", "three_tri_edge.off", "misoriented.obj",
                                 "moebius.off", "torus.off", "duplicate_face.obj", "bow_tie.obj"})
    meshes.push_back(asset_mesh(name));
  meshes.push_back(make_mesh(two_tetrahedra_on_an_edge()));
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    Mesh mesh = make_mesh(random.faces, random.points);
    if (mesh.live().faces > 0 && !mesh.has_rings()) meshes.push_back(std::move(mesh));
  }
  for (const Mesh& mesh : meshes)
    for (const char* const method : {"brute_force", "vertex_lists", "hash_16", "hash", "sparse_matrix"})
      EXPECT_EQ(partners_of(*played("pair", mesh, {method}), mesh), pairing_of_kernel(mesh)) << method;
}

// Each tetrahedron keeps the pairs of its own sides, which the text gives away.
TEST(pair_steps, say_which_sides_of_a_cut_edge_stay_joined) {
  const Mesh mesh = make_mesh(two_tetrahedra_on_an_edge());
  const auto sequence = played("pair", mesh, {"hash"});
  const std::string last = sequence->at(sequence->size()).caption.en;
  EXPECT_NE(last.find("4 sides"), std::string::npos) << last;
  std::size_t joined = 0;
  for (std::size_t at = last.find("stay joined"); at != last.npos; at = last.find("stay joined", at + 1)) ++joined;
  EXPECT_EQ(joined, 2u) << last;
}

// The face that makes an edge one of three lies behind those that are played.
TEST(pair_steps, know_that_an_edge_is_cut_by_faces_that_are_not_played) {
  Polygons faces{{0, 1, 2}, {1, 0, 3}};
  for (std::uint32_t f = 0; f < 1000; ++f) faces.push_back({5 + 3 * f, 6 + 3 * f, 7 + 3 * f});
  faces.push_back({0, 1, 4});
  const auto sequence = played("pair", make_mesh(faces), {"hash"});
  const Step last = sequence->at(sequence->size());
  EXPECT_NE(last.caption.en.find("0-1 is cut in the mesh"), std::string::npos) << last.caption.en;
  EXPECT_EQ(last.rows.size(), 2u);
}

// Rings are loops of their faces: their sides are paired as all others, by each method, and in the building too.
TEST(pair_steps, pair_the_sides_of_rings) {
  for (const char* const name : {"figures/000-4b.obj", "figures/000-4c.obj"}) {
    const Mesh mesh = asset_mesh(name);
    ASSERT_TRUE(mesh.has_rings());
    for (const char* const method : {"brute_force", "vertex_lists", "hash_16", "hash", "sparse_matrix"}) {
      const auto sequence = played("pair", mesh, {method});
      EXPECT_NE(sequence->remark().en.find("inner components"), std::string::npos);
      PlayedTables tables;
      for (std::size_t i = 1; i <= sequence->size(); ++i) replay(tables, sequence->at(i));
      for (std::uint32_t h = 0; h < mesh.halfedge_slots(); ++h)
        EXPECT_EQ(tables["pairs"].at(slot_name(Halfedge(h))).at("pair"), slot_name(twin(Halfedge(h)))) << method;
    }
    const auto build = played("build", mesh, {});
    expect_plays(*build);
    PlayedTables tables;
    for (std::size_t i = 1; i <= build->size(); ++i) replay(tables, build->at(i));
    for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
      const Halfedge h(i);
      const auto& row = tables["halfedges"].at(slot_name(h));
      EXPECT_EQ(row.at("next"), slot_name(mesh.next(h)));
      EXPECT_EQ(row.at("prev"), slot_name(mesh.prev(h)));
      EXPECT_EQ(row.at("face"), slot_name(mesh.face(h)));
      EXPECT_EQ(row.at("twin"), slot_name(twin(h)));
    }
    std::size_t inner = 0;
    for (const auto& [face, fields] : tables["faces"]) {
      if (!fields.contains("inner")) continue;
      for (const std::string_view start : split_words(fields.at("inner"))) {
        EXPECT_EQ(slot_name(mesh.face(find_edge(mesh, start).element)), face);
        ++inner;
      }
    }
    EXPECT_EQ(inner, mesh.live().rings);
  }
}

// The comparisons of the text's code, counted by running it: all faces so far, up to the first match.
std::size_t comparisons_by_brute_force(const Mesh& mesh) {
  const std::vector<Halfedge> corners = forms::corner_halfedges(mesh);
  std::size_t count = 0, end = 0;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    while (end < corners.size() && mesh.face(corners[end]).index <= mesh.face(corners[c]).index) ++end;
    for (std::size_t other = 0; other < end; ++other) {
      ++count;
      if (mesh.from(corners[other]) == mesh.to(corners[c]) && mesh.to(corners[other]) == mesh.from(corners[c])) break;
    }
  }
  return count;
}

std::size_t told_comparisons(Sequence& sequence) {
  std::size_t told = 0;
  for (std::size_t i = 1; i <= sequence.size(); ++i)
    for (const steps::RowChange& row : sequence.at(i).rows)
      if (row.table == "comparisons") told = std::stoul(*row.new_value);
  return told;
}

TEST(pair_steps, count_the_comparisons) {
  const Mesh mesh = asset_mesh("torus.off");
  EXPECT_EQ(told_comparisons(*played("pair", mesh, {"brute_force"})), comparisons_by_brute_force(mesh));
  // An element of the matrix has at most one halfedge on a manifold: one comparison per pair, when the second comes.
  EXPECT_EQ(told_comparisons(*played("pair", mesh, {"sparse_matrix"})), mesh.live().edges);
  EXPECT_LT(told_comparisons(*played("pair", mesh, {"hash"})),
            told_comparisons(*played("pair", mesh, {"vertex_lists"})));
}

// The table holds the side that looks for its pair, too: it is not among those that it is compared with.
TEST(pair_steps, tell_what_a_step_is_about_from_what_it_is_compared_with) {
  for (const char* const name : {"tetrahedron.off", "fan.obj", "cube.obj", "moebius.off", "figures/000-3.obj"})
    for (const char* const method : {"brute_force", "vertex_lists", "hash_16", "hash", "sparse_matrix"}) {
      const auto sequence = played("pair", asset_mesh(name), {method});
      for (std::size_t i = 1; i <= sequence->size(); ++i) {
        std::map<Element, std::set<steps::Role>> roles;
        const Step step = sequence->at(i);
        for (const steps::Mark& mark : step.marks) roles[mark.element].insert(mark.role);
        for (const auto& [element, of] : roles) EXPECT_EQ(of.size(), 1u) << name << " " << method << ", step " << i;
      }
    }
  const std::string first = played("pair", asset_mesh("tetrahedron.off"), {"hash"})->at(2).caption.en;
  EXPECT_NE(first.find("is compared with 1, itself among them: "), std::string::npos) << first;
}

// Code 3 packs two numbers of 16 bits into its key, in line 7; a key with both in full is only spoken of.
TEST(pair_steps, cite_code_3_for_its_own_key_alone) {
  const std::map<std::string, std::pair<std::string, int>> cited{
      {"brute_force", {"program code 2", 63}},
      {"vertex_lists", {"section 4, links from vertices", 0}},
      {"hash_16", {"program code 3", 7}},
      {"hash", {"section 4, a hash", 0}},
      {"sparse_matrix", {"section 4, a matrix", 0}}};
  for (const auto& [method, place] : cited) {
    const steps::Source source = *played("pair", asset_mesh("tetrahedron.off"), {method})->at(2).source;
    EXPECT_EQ(source.text, "000");
    EXPECT_EQ(std::pair(std::string(source.listing_en), source.line), place) << method;
  }
}

TEST(pair_steps, play_the_first_faces_of_a_large_mesh) {
  const Mesh mesh = make_mesh(torus_grid(40, 40));
  const auto sequence = played("pair", mesh, {"hash"});
  EXPECT_NE(sequence->remark().en.find("first 1000 of 3200 faces"), std::string::npos) << sequence->remark().en;
  EXPECT_EQ(sequence->size(), 1000u * 4);
  EXPECT_EQ(played("pair", make_mesh(cube()), {"hash"})->remark().en, "");
}

}  // namespace
}  // namespace ryosen
