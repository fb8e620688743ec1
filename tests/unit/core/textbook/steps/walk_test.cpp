// Walks around a vertex and along a loop, step by step, on every form.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/textbook/forms/all.h"
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
using steps::Step;

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
  const auto at_boundary = played("walk", asset_mesh("fan.obj"), {"v1"});
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
        EXPECT_EQ(play_or_refuse("walk", mesh, {"v0", std::string(form.id)}).failure().exit_code, ExitCode::refused);
        continue;
      }
      if (!form.stores_vertices) continue;
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
  EXPECT_EQ(walked.size(), forms::all_forms().size() - 2) << "all but the soup and the polygon set";
  EXPECT_EQ(looped, walked);
  EXPECT_EQ(play_or_refuse("walk", asset_mesh("fan.obj"), {"v0", "x"}).failure().exit_code, ExitCode::usage);
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
  for (const char* const form : {"indexed_face_set", "opposite_map"})
    EXPECT_EQ(records(form), mesh.live().faces) << form;
  EXPECT_EQ(records("face_adjacency"), 7u) << "the vertex and its six faces";
  EXPECT_EQ(records("winged_edge"), 7u) << "the vertex and its six edges";
  EXPECT_LE(records("halfedge"), 19u) << "the vertex and the halfedges of six faces";
}

// The places of a face are all that a soup or a polygon set has of it; a vertex it has not.
TEST(walk_steps, on_places_alone_go_round_no_vertex_and_name_places) {
  const Mesh mesh = asset_mesh("tetrahedron.off");
  for (const char* const form : {"triangle_soup", "polygon_set"}) {
    const auto walk = play_or_refuse("walk", mesh, {"v0", form});
    ASSERT_FALSE(walk.ok()) << form;
    EXPECT_EQ(walk.failure().exit_code, ExitCode::refused);
    const auto sequence = played("loop", mesh, {"f1", form});
    ASSERT_EQ(sequence->size(), 2u);
    EXPECT_EQ(sequence->at(1).caption.en, "positions(f1) = 0,0,0 1,0,0 0,0,1") << form;
    EXPECT_EQ(sequence->at(2).caption.en, "3 places; 1 record was read") << form;
    for (std::size_t i = 1; i <= 2; ++i)
      for (const steps::Mark& mark : sequence->at(i).marks) EXPECT_EQ(mark.element, Element(Face(1))) << form;
    for (const auto& choice : steps::find_steps("walk")->choices(mesh, {}))
      EXPECT_TRUE(choice.size() < 2 || choice[1] != form);
  }
}

TEST(walk_steps, refuse_to_show_a_search_through_many_faces) {
  const Mesh mesh = make_mesh(torus_grid(30, 30));
  EXPECT_EQ(play_or_refuse("walk", mesh, {"v0", "indexed_face_set"}).failure().exit_code, ExitCode::refused);
  EXPECT_TRUE(play_or_refuse("walk", mesh, {"v0", "face_adjacency"}).ok());
}

}  // namespace
}  // namespace ryosen
