#include "ryosen/ops/orient.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "ryosen/io/formats.h"
#include "ryosen/ops/rules/turn_faces.h"
#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/oracle/figures.h"
#include "tests/support/core/oracle/orienting.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// Orients as often as it is legal, which must be once at most. Returns whether it was.
bool orient_and_prove(const Mesh& start) {
  Mesh mesh = start;
  const bool legal = check(mesh, Orient{}).legal();
  if (legal) apply_and_prove(mesh, Orient{});
  const oracle::PolygonList before = list_of(start, true), after = list_of(mesh, true);
  EXPECT_EQ(legal, before.faces != after.faces) << to_text(before);
  EXPECT_EQ(wrong_orienting(before, after), "") << to_text(before);
  EXPECT_TRUE(check(mesh, Orient{}).has(Rule::oriented)) << to_text(before);
  return legal;
}

int misoriented_edges(const Mesh& mesh) { return oracle::figures_of(list_of(mesh, true)).misoriented_edges; }

// Quads around a tube whose ends are joined after a turn over.
Polygons klein_grid(std::uint32_t along, std::uint32_t around) {
  Polygons faces;
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return i < along ? i * around + j % around : (2 * around - j) % around;
  };
  for (std::uint32_t i = 0; i < along; ++i)
    for (std::uint32_t j = 0; j < around; ++j)
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return faces;
}

// Six vertices, every two of them joined: the projective plane.
Polygons projective_plane() {
  return {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
}

Polygons turned_at_random(Polygons faces, Dice& dice, int one_in) {
  for (auto& face : faces)
    if (dice.one_in(one_in)) std::reverse(face.begin() + 1, face.end());
  return faces;
}

TEST(orient, a_seam_that_is_as_short_as_turning_makes_it_is_left_alone) {
  for (const auto& [along, around] : {std::pair(5u, 3u), {6u, 6u}, {10u, 6u}, {4u, 9u}}) {
    const Mesh mesh = make_mesh(klein_grid(along, around));
    ASSERT_EQ(misoriented_edges(mesh), static_cast<int>(around));
    EXPECT_FALSE(orient_and_prove(mesh));
  }
}

TEST(orient, a_face_and_a_patch_against_their_neighbours_turn_where_no_orientation_is) {
  Polygons faces = klein_grid(10, 6);
  for (std::size_t f : {27, 30, 31, 36, 37}) std::reverse(faces[f].begin() + 1, faces[f].end());
  Mesh mesh = make_mesh(faces);
  ASSERT_GT(misoriented_edges(mesh), 6);
  apply_and_prove(mesh, Orient{});
  EXPECT_EQ(misoriented_edges(mesh), 6);
  EXPECT_EQ(list_of(mesh, true).faces, list_of(make_mesh(klein_grid(10, 6)), true).faces);
}

TEST(orient, shapes_and_random_meshes_end_as_the_oracle_wants) {
  Dice dice(5);
  std::size_t turned = 0;
  for (const Polygons& faces : {tetrahedron(), cube(), torus_grid(4, 5), bow_tie(), fin(), moebius_strip(),
                                two_tetrahedra_on_an_edge(), klein_grid(5, 4), klein_grid(3, 8), projective_plane()}) {
    orient_and_prove(make_mesh(faces));
    for (int i = 0; i < 12; ++i) turned += orient_and_prove(make_mesh(turned_at_random(faces, dice, 2 + i % 5)));
  }
  EXPECT_GT(turned, 80u);
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SeededMesh random = seeded_mesh(seed);
    orient_and_prove(make_mesh(turned_at_random(random.faces, dice, 3), random.points));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(orient, faces_without_area_give_way) {
  // One triangle, and on two of its sides two that lie on a line and are turned against it.
  IndexedMesh list = indexed({{0, 1, 3}, {0, 1, 2}, {3, 0, 4}}, 5);
  list.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 2, 0}};
  Mesh mesh = from_indexed(list);
  ASSERT_EQ(misoriented_edges(mesh), 2);
  apply_and_prove(mesh, Orient{});
  EXPECT_EQ(misoriented_edges(mesh), 0);
  EXPECT_EQ(list_of(mesh, true).faces[0], (oracle::Corners{0, 1, 3}));
}

TEST(orient, components_are_judged_each_for_itself) {
  // A Klein bottle whose seam stays, and a torus with a turned face, which is put right.
  Polygons faces = klein_grid(6, 5), torus = torus_grid(3, 4);
  std::reverse(torus[7].begin() + 1, torus[7].end());
  for (std::vector<std::uint32_t> face : torus) {
    for (std::uint32_t& v : face) v += 30;
    faces.push_back(face);
  }
  Mesh mesh = make_mesh(faces);
  EXPECT_EQ(misoriented_edges(mesh), 8);
  EXPECT_TRUE(orient_and_prove(mesh));
  apply_and_prove(mesh, Orient{});
  EXPECT_EQ(misoriented_edges(mesh), 5);
}

TEST(orient, surfaces_of_files_keep_or_shorten_their_seams) {
  for (const std::string& path :
       {std::string(RYOSEN_SOURCE_DIR "/assets/klein_bottle.off"), std::string(RYOSEN_SOURCE_DIR "/assets/moebius.off"),
        std::string(RYOSEN_SOURCE_DIR "/assets/projective_plane.off"),
        std::string(RYOSEN_SHARED_DIR "/meshes/known/klein.off"),
        std::string(RYOSEN_SHARED_DIR "/meshes/known/rp2.off")}) {
    if (!std::filesystem::exists(path)) continue;
    Result<MeshFile> file = read_mesh_file(path);
    ASSERT_TRUE(file) << path;
    const Mesh mesh = from_indexed(std::move(file->mesh));
    orient_and_prove(mesh);
    std::vector<bool> some(mesh.face_slots());
    for (std::size_t f = 0; f < some.size(); ++f) some[f] = f % 3 == 0;
    orient_and_prove(Mesh(turn_faces(mesh, some).columns));
  }
}

}  // namespace
}  // namespace ryosen
