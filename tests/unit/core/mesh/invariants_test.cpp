// Injected corruption: random wrong links are found and named, without a crash or an endless walk.
#include "ryosen/mesh/invariants.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "ryosen/indexed/from_indexed.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// Sets one link of one element to a random number and returns whether it differs from before.
bool corrupt(MeshColumns& c, std::mt19937& random) {
  const auto halfedges = static_cast<std::uint32_t>(c.halfedges.size());
  const auto any = [&](std::size_t range) { return static_cast<std::uint32_t>(random() % (range + range / 4 + 2)); };
  HalfedgeLinks& links = c.halfedges[random() % halfedges];
  const MeshColumns before = c;
  switch (random() % 6) {
    case 0:
      links.from = Vertex(any(c.vertex_halfedge.size()));
      break;
    case 1:
      links.next = Halfedge(any(halfedges));
      break;
    case 2:
      links.prev = Halfedge(any(halfedges));
      break;
    case 3:
      links.face = random() % 4 == 0 ? Face() : Face(any(c.face_halfedge.size()));
      break;
    case 4:
      c.vertex_halfedge[random() % c.vertex_halfedge.size()] = Halfedge(any(halfedges));
      break;
    default:
      c.face_halfedge[random() % c.face_halfedge.size()] = Halfedge(any(halfedges));
      break;
  }
  return !(c == before);
}

TEST(check_invariants, finds_injected_corruption) {
  std::mt19937 random(11);
  std::size_t injected = 0, found = 0, valid_all_the_same = 0;
  for (const Polygons& faces : {tetrahedron(), cube(), torus_grid(5, 4), two_quads(), closed_fan(6), bow_tie(), fin(),
                                moebius_strip(), two_tetrahedra_on_an_edge()}) {
    const Mesh sound = make_mesh(faces);
    ASSERT_FALSE(check_invariants(sound));
    for (int i = 0; i < 3000; ++i) {
      MeshColumns columns = sound.columns();
      if (!corrupt(columns, random)) continue;
      ++injected;
      // Another first halfedge of a face, or another outgoing one of an inner vertex, is another valid mesh.
      MeshColumns neutral = columns;
      neutral.face_halfedge = sound.columns().face_halfedge;
      neutral.vertex_halfedge = sound.columns().vertex_halfedge;
      const auto broken = check_invariants(Mesh(std::move(columns)));
      if (broken) {
        ++found;
        EXPECT_FALSE(broken->element.empty() && broken->sentence.empty());
      } else if (neutral == sound.columns()) {
        ++valid_all_the_same;
      }
    }
  }
  std::cout << "injected " << injected << ", found " << found << ", valid all the same " << valid_all_the_same << "\n";
  EXPECT_EQ(found + valid_all_the_same, injected);
  EXPECT_GT(found, injected / 2);
}

TEST(check_invariants, names_the_element) {
  MeshColumns columns = make_mesh(cube()).columns();
  columns.halfedges[5].next = Halfedge(5);
  const auto broken = check_invariants(Mesh(std::move(columns)));
  ASSERT_TRUE(broken);
  EXPECT_EQ(broken->element.substr(0, 1), "h");
}

TEST(check_invariants, survives_many_wrong_links_at_once) {
  std::mt19937 random(12);
  for (int i = 0; i < 2000; ++i) {
    MeshColumns columns = make_mesh(torus_grid(4, 4)).columns();
    for (int k = 0; k < 30; ++k) corrupt(columns, random);
    EXPECT_TRUE(check_invariants(Mesh(std::move(columns))));
  }
}

}  // namespace
}  // namespace ryosen
