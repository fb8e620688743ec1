// What is played on a mesh: the structures at the end are those that other code makes, and every row plays on the small
// meshes.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/forms/all.h"
#include "core/forms/opposite_map.h"
#include "core/forms/pairing.h"
#include "core/forms/polygons.h"
#include "core/forms/source_operators.h"
#include "core/forms/split_3ij.h"
#include "core/indexed/from_indexed.h"
#include "core/io/formats.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/mesh/names.h"
#include "core/ops/all.h"
#include "core/steps/all.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/stated_changes.h"
#include "tests/support/core/step_checks.h"

namespace ryosen {
namespace {

using namespace test;
using steps::Sequence;
using steps::Step;
using Arguments = std::vector<std::string>;

Result<std::unique_ptr<Sequence>> play(std::string_view id, const Mesh& mesh, const Arguments& arguments) {
  return steps::find_steps(id)->make(mesh, arguments);
}

std::unique_ptr<Sequence> played(std::string_view id, const Mesh& mesh, const Arguments& arguments) {
  auto sequence = play(id, mesh, arguments);
  EXPECT_TRUE(sequence.ok()) << id << ": " << sequence.failure().message.text.en;
  return std::move(sequence).value();
}

Mesh asset_mesh(const std::string& name) {
  auto file = read_mesh_file(RYOSEN_SOURCE_DIR "/assets/" + name);
  EXPECT_TRUE(file.ok()) << name;
  return from_indexed(std::move(file->mesh));
}

// Table, row, field: value. What a row says was there is what the tables hold.
using Tables = std::map<std::string, std::map<std::string, std::map<std::string, std::string>>>;
void replay(Tables& tables, const Step& step) {
  for (const steps::RowChange& row : step.rows) {
    auto& fields = tables[row.table][row.row];
    const auto known = fields.find(row.field);
    if (known != fields.end()) {
      EXPECT_EQ(known->second, row.old_value.value_or("-")) << step.caption.en;
    }
    fields[row.field] = row.new_value.value_or("-");
  }
}

TEST(steps, every_row_plays_on_the_small_meshes) {
  std::map<std::string, int> count;
  for (const char* const name :
       {"tetrahedron.off", "fan.obj", "cube.obj", "two_quads.obj", "three_tri_edge.off", "bow_tie.obj", "moebius.off",
        "isolated_vertex.obj", "hanging_pair.obj", "torus.off", "misoriented.obj", "collinear.obj",
        "figures/000-4b.obj", "figures/000-5b.obj", "figures/000-14.obj", "figures/000-15.obj",
        "figures/003-image24.obj", "projective_plane.off"}) {
    const Mesh mesh = asset_mesh(name);
    for (const steps::StepsRow& row : steps::all_steps()) {
      for (const std::vector<std::string>& arguments : row.choices(mesh, {})) {
        SCOPED_TRACE(std::string(name) + " " + std::string(row.id) + (arguments.empty() ? "" : " " + arguments[0]));
        const auto sequence = row.make(mesh, arguments);
        ASSERT_TRUE(sequence.ok()) << sequence.failure().message.text.en;
        expect_plays(**sequence);
        EXPECT_TRUE((*sequence)->edits() || (*sequence)->mesh_at(0).hash() == mesh.hash());
        ++count[std::string(row.id)];
      }
    }
  }
  for (const steps::StepsRow& row : steps::all_steps())
    EXPECT_GE(count[std::string(row.id)], row.plays_script ? 0 : 4) << row.id;
}

TEST(steps, arguments_that_do_not_fit_are_usage_in_both_languages) {
  const Mesh mesh = make_mesh(tetrahedron());
  const std::vector<std::pair<std::string, Arguments>> wrong = {{"build", {"x"}},
                                                                {"pair", {}},
                                                                {"pair", {"sort"}},
                                                                {"pair", {"nonsense"}},
                                                                {"collapse", {}},
                                                                {"collapse", {"0-9"}},
                                                                {"swap", {"x"}},
                                                                {"split3", {}},
                                                                {"split3", {"x"}},
                                                                {"split3", {"12"}},
                                                                {"split3", {"1,"}},
                                                                {"walk", {}},
                                                                {"walk", {"v9"}},
                                                                {"loop", {"f9"}},
                                                                {"loop", {"f0", "f1"}},
                                                                {"relation", {"vertex_faces"}},
                                                                {"relation", {"x", "v0"}},
                                                                {"relation", {"edge_faces", "v0"}},
                                                                {"relation", {"vertex_faces", "f0"}},
                                                                {"hull", {"x"}},
                                                                {"hull", {"random", "x"}},
                                                                {"hull", {"farthest", "1"}},
                                                                {"hull", {"project=w"}},
                                                                {"hull", {"project=x", "random"}}};
  for (const auto& [id, arguments] : wrong) {
    const auto sequence = play(id, mesh, arguments);
    ASSERT_FALSE(sequence.ok()) << id;
    EXPECT_EQ(sequence.failure().exit_code, ExitCode::usage) << id;
    EXPECT_NE(sequence.failure().message.text.en, sequence.failure().message.text.ja) << id;
  }
  for (const auto& [id, arguments] :
       std::vector<std::pair<std::string, Arguments>>{{"collapse", {"0-1"}}, {"swap", {"0-1"}}, {"split3", {"1"}}}) {
    const auto sequence = play(id, make_mesh(cube()), arguments);
    ASSERT_FALSE(sequence.ok()) << id;
    EXPECT_EQ(sequence.failure().exit_code, ExitCode::refused) << id;
  }
  EXPECT_EQ(play("build", Mesh(), {}).failure().exit_code, ExitCode::refused);
}

// The pairs that the steps leave, by corner.
SidePartners partners_of(Sequence& sequence, const Mesh& mesh) {
  Tables tables;
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
      Tables tables;
      for (std::size_t i = 1; i <= sequence->size(); ++i) replay(tables, sequence->at(i));
      for (std::uint32_t h = 0; h < mesh.halfedge_slots(); ++h)
        EXPECT_EQ(tables["pairs"].at(slot_name(Halfedge(h))).at("pair"), slot_name(twin(Halfedge(h)))) << method;
    }
    const auto build = played("build", mesh, {});
    expect_plays(*build);
    Tables tables;
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

TEST(pair_steps, play_the_first_faces_of_a_large_mesh) {
  const Mesh mesh = make_mesh(torus_grid(40, 40));
  const auto sequence = played("pair", mesh, {"hash"});
  EXPECT_NE(sequence->remark().en.find("first 1000 of 3200 faces"), std::string::npos) << sequence->remark().en;
  EXPECT_EQ(sequence->size(), 1000u * 4);
  EXPECT_EQ(played("pair", make_mesh(cube()), {"hash"})->remark().en, "");
}

TEST(build_steps, end_with_the_halfedges_of_table_5_and_the_map_of_text_003) {
  for (const char* const name : {"tetrahedron.off", "fan.obj", "torus.off", "cube.obj", "two_quads.obj"}) {
    const Mesh mesh = asset_mesh(name);
    const auto sequence = played("build", mesh, {});
    Tables tables;
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
  Tables tables;
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
  Tables tables;
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

// The listing's writes replayed on the table of table 5, against the listing as it runs in one go.
void expect_listing(const Mesh& mesh, const std::string& id, Halfedge start) {
  const std::string edge = std::to_string(mesh.from(start).index) + "-" + std::to_string(mesh.to(start).index);
  const auto sequence = played(id, mesh, {edge});
  Tables tables;
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
    const Change change{step.delta->v, step.delta->e, step.delta->f,
                        step.delta->h, step.delta->s, step.delta->g.value_or(0),
                        step.delta->b};
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

TEST(walk_steps, visit_the_one_ring_and_the_loop) {
  for (const char* const name : {"fan.obj", "torus.off", "cube.obj", "three_tri_edge.off", "bow_tie.obj"}) {
    const Mesh mesh = asset_mesh(name);
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
      const auto sequence = played("walk", mesh, {"v" + std::to_string(v)});
      std::set<Element> expected, found;
      for_each_copy(mesh, Vertex(v), [&](Vertex copy) {
        for (const Vertex w : neighbours(mesh, copy)) expected.insert(mesh.copy_point(w));
      });
      for (const steps::Mark& mark : sequence->at(sequence->size()).marks)
        if (mark.role == steps::Role::answer) found.insert(mark.element);
      EXPECT_EQ(found, expected) << name << " v" << v;
    }
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
      const auto sequence = played("loop", mesh, {"f" + std::to_string(f)});
      std::vector<Element> expected, found;
      for (const Vertex w : vertices_around(mesh, Face(f))) expected.push_back(w);
      for (const steps::Mark& mark : sequence->at(sequence->size()).marks)
        if (mark.role == steps::Role::answer) found.push_back(mark.element);
      EXPECT_EQ(found, expected) << name << " f" << f;
    }
  }
  const auto at_boundary = played("walk", hexagon_fan(), {"v1"});
  std::string all;
  for (std::size_t i = 1; i <= at_boundary->size(); ++i) all += at_boundary->at(i).caption.en;
  EXPECT_NE(all.find("here is the boundary"), std::string::npos) << all;
}

std::vector<Element> answers_of(const Step& step) {
  std::vector<Element> found;
  for (const steps::Mark& mark : step.marks)
    if (mark.role == steps::Role::answer) found.push_back(mark.element);
  return found;
}

TEST(walk_steps, visit_the_same_on_every_form) {
  std::set<std::string_view> walked, looped;
  for (const char* const name : {"fan.obj", "torus.off", "cube.obj", "two_quads.obj", "bow_tie.obj", "moebius.off",
                                 "figures/000-4b.obj", "figures/003-image43.obj"}) {
    const Mesh mesh = asset_mesh(name);
    for (const forms::FormRow& form : forms::all_forms()) {
      if (forms::why_unsuitable(mesh, form)) {
        EXPECT_EQ(play("walk", mesh, {"v0", std::string(form.id)}).failure().exit_code, ExitCode::refused);
        continue;
      }
      SCOPED_TRACE(std::string(name) + " " + std::string(form.id));
      for (std::uint32_t v = 0; v < mesh.vertex_slots(); v += 1 + mesh.vertex_slots() / 16) {
        const auto sequence = played("walk", mesh, {"v" + std::to_string(v), std::string(form.id)});
        const std::vector<Element> found = answers_of(sequence->at(sequence->size()));
        // The rings of all copies are one, by points.
        std::set<Element> expected;
        for_each_copy(mesh, Vertex(v), [&](Vertex copy) {
          for (const Vertex w : neighbours(mesh, copy)) expected.insert(mesh.copy_point(w));
        });
        EXPECT_EQ(std::set<Element>(found.begin(), found.end()), expected) << v;
        EXPECT_EQ(found.size(), expected.size()) << "each once";
        walked.insert(form.id);
        if (v == 0) expect_plays(*sequence);
      }
      for (std::uint32_t f = 0; f < mesh.face_slots(); f += 1 + mesh.face_slots() / 16) {
        const auto sequence = played("loop", mesh, {"f" + std::to_string(f), std::string(form.id)});
        std::vector<Element> expected;
        for (const Vertex w : vertices_around(mesh, Face(f)))
          expected.push_back(form.holds_copies ? w : mesh.copy_point(w));
        const std::vector<Element> found = answers_of(sequence->at(sequence->size()));
        EXPECT_EQ(std::multiset<Element>(found.begin(), found.end()),
                  std::multiset<Element>(expected.begin(), expected.end()))
            << f;
        looped.insert(form.id);
        if (f == 0) expect_plays(*sequence);
      }
    }
  }
  EXPECT_EQ(walked.size(), forms::all_forms().size());
  EXPECT_EQ(looped.size(), forms::all_forms().size());
  EXPECT_EQ(play("walk", asset_mesh("fan.obj"), {"v0", "x"}).failure().exit_code, ExitCode::usage);
}

// A point with copies has the ring of all of them, and one without an edge has none.
TEST(walk_steps, count_what_there_is) {
  const auto last_of = [](const Mesh& mesh, const char* vertex) {
    const auto sequence = played("walk", mesh, {vertex});
    return sequence->at(sequence->size()).caption;
  };
  Polygons cones;
  for (std::uint32_t i = 0; i < 6; ++i) {
    cones.push_back({0, 1 + i, 1 + (i + 1) % 6});
    cones.push_back({0, 7 + i, 7 + (i + 1) % 6});
  }
  const Text around = last_of(make_mesh(cones), "v0");
  EXPECT_EQ(around.en.substr(0, around.en.find(':')), "12 neighbours");
  EXPECT_EQ(last_of(make_mesh({}, 3), "v0").en, "no neighbour; 1 record was read");
  EXPECT_EQ(last_of(make_mesh({}, 3), "v0").ja, "隣接頂点なし。読んだデータは 1 個");
}

// Lists of faces are read whole, and what is linked is not.
TEST(walk_steps, say_how_many_records_they_read) {
  const Mesh mesh = asset_mesh("torus.off");
  const auto records = [&](const char* form) {
    const auto sequence = played("walk", mesh, {"v0", form});
    return std::stoul(sequence->at(sequence->size()).rows.back().new_value.value());
  };
  for (const char* const form : {"triangle_soup", "polygon_set", "indexed_face_set", "opposite_map"})
    EXPECT_EQ(records(form), mesh.live().faces) << form;
  EXPECT_EQ(records("face_adjacency"), 7u) << "the vertex and its six faces";
  EXPECT_EQ(records("winged_edge"), 7u) << "the vertex and its six edges";
  EXPECT_LE(records("halfedge"), 19u) << "the vertex and the halfedges of six faces";
}

TEST(walk_steps, refuse_to_show_a_search_through_many_faces) {
  const Mesh mesh = make_mesh(torus_grid(30, 30));
  EXPECT_EQ(play("walk", mesh, {"v0", "indexed_face_set"}).failure().exit_code, ExitCode::refused);
  EXPECT_TRUE(play("walk", mesh, {"v0", "face_adjacency"}).ok());
}

// A form's own answer in slots of the mesh. Only for meshes without gaps and copies.
std::set<Element> own_answer(const Mesh& mesh, const forms::FormRow& row, const forms::RelationRow& relation,
                             Element element, bool& is_told) {
  const std::unique_ptr<forms::Form> form = row.make(mesh);
  std::uint32_t number = element.index;
  if (relation.asks == forms::ElementOf::edge)
    number = form->find_edge(mesh.from(halfedge(element.edge())).index, mesh.to(halfedge(element.edge())).index);
  forms::Answer answer;
  is_told = form->answer(relation.relation, number, answer);
  std::set<Element> all;
  const std::string_view id = relation.id;
  for (const std::uint32_t n : answer.numbers)
    all.insert(id.ends_with("faces") ? Element(Face(n)) : Element(Vertex(n)));
  for (const forms::EdgeEnds& ends : answer.edges)
    all.insert(edge(find_halfedge(mesh, Vertex(ends.a), Vertex(ends.b))));
  return all;
}

void expect_relations(const Mesh& mesh) {
  for (const forms::RelationRow& relation : forms::relations()) {
    const std::uint32_t count = relation.asks == forms::ElementOf::vertex ? mesh.vertex_slots()
                                : relation.asks == forms::ElementOf::edge ? mesh.edge_slots()
                                                                          : mesh.face_slots();
    for (std::uint32_t i = 0; i < count; i += 3) {
      const Element element = relation.asks == forms::ElementOf::vertex ? Element(Vertex(i))
                              : relation.asks == forms::ElementOf::edge ? Element(Edge(i))
                                                                        : Element(Face(i));
      const auto sequence = played("relation", mesh, {std::string(relation.id), slot_name(element)});
      ASSERT_EQ(sequence->size(), forms::all_forms().size());
      for (std::size_t form = 0; form < sequence->size(); ++form) {
        const forms::FormRow& row = forms::all_forms()[form];
        if (forms::why_unsuitable(mesh, row) || !row.keeps_numbers) continue;
        bool is_told = false;
        const std::set<Element> expected = own_answer(mesh, row, relation, element, is_told);
        std::set<Element> found;
        const Step step = sequence->at(form + 1);
        EXPECT_EQ(step.rows.empty(), !is_told) << row.id << " " << relation.id;
        for (const steps::Mark& mark : step.marks)
          if (mark.role == steps::Role::answer) found.insert(mark.element);
        if (relation.relation == forms::Relation::valence) {
          EXPECT_EQ(std::to_string(found.size()), is_told ? step.rows[1].new_value : "0") << row.id;
        } else if (is_told) {
          EXPECT_EQ(found, expected) << row.id << " " << relation.id << " " << slot_name(element);
        }
      }
    }
  }
}

TEST(relation_steps, find_what_each_form_answers_itself) {
  for (const char* const name : {"tetrahedron.off", "fan.obj", "two_quads.obj", "cube.obj"})
    expect_relations(asset_mesh(name));
}

TEST(relation_steps, every_form_finds_the_same_also_by_places_and_at_copies) {
  for (const char* const name : {"fan.obj", "torus.off", "three_tri_edge.off", "bow_tie.obj", "fin.obj"}) {
    const Mesh mesh = asset_mesh(name);
    for (const forms::RelationRow& relation : forms::relations()) {
      const char* const element = relation.asks == forms::ElementOf::vertex ? "v0"
                                  : relation.asks == forms::ElementOf::edge ? "e0"
                                                                            : "f0";
      const auto sequence = played("relation", mesh, {std::string(relation.id), element});
      std::set<std::set<Element>> answers;
      for (std::size_t i = 1; i <= sequence->size(); ++i) {
        const Step step = sequence->at(i);
        std::set<Element> found;
        for (const steps::Mark& mark : step.marks)
          if (mark.role == steps::Role::answer) found.insert(mark.element);
        if (!step.rows.empty()) answers.insert(found);
      }
      EXPECT_EQ(answers.size(), 1u) << name << " " << relation.id;
    }
  }
}

TEST(relation_steps, table_2_reads_all_faces_and_table_3_those_around) {
  const Mesh mesh = asset_mesh("torus.off");
  const auto sequence = played("relation", mesh, {"vertex_faces", "v0"});
  std::map<std::string, std::size_t> records;
  for (std::size_t i = 1; i <= sequence->size(); ++i)
    for (const steps::RowChange& row : sequence->at(i).rows)
      if (row.table == "records_read") records[row.row] = std::stoul(*row.new_value);
  EXPECT_EQ(records.at("indexed_face_set"), mesh.live().faces);
  std::size_t around = 0;
  for ([[maybe_unused]] const Face f : faces_around(mesh, Vertex(0))) ++around;
  EXPECT_EQ(records.at("face_adjacency"), around + 1) << "the vertex, and its faces";
  EXPECT_EQ(records.at("triangle_soup"), mesh.live().faces);
  EXPECT_LT(records.at("halfedge"), mesh.live().faces / 2);
}

}  // namespace
}  // namespace ryosen
