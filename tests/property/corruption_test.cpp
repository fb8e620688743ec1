// Every link of meshes with rings, copies, wires and fans set to random wrong values: found and named, unless the
// columns describe a valid mesh all the same.
#include <gtest/gtest.h>

#include <iostream>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

class Corruption {
 public:
  Corruption(MeshColumns& columns, Dice& dice) : c_(columns), dice_(dice) {}

  // Sets one link to a random number, sometimes past the end or none. The kinds take turns.
  void inject(int kind) {
    const std::size_t h = any_of(c_.halfedges), v = any_of(c_.vertex_halfedge), f = any_of(c_.face_halfedge);
    if (kind == 0) c_.halfedges[h].from = Vertex(number(c_.vertex_halfedge.size()));
    if (kind == 1) c_.halfedges[h].next = Halfedge(number(c_.halfedges.size()));
    if (kind == 2) c_.halfedges[h].prev = Halfedge(number(c_.halfedges.size()));
    if (kind == 3) c_.halfedges[h].face = Face(number(c_.face_halfedge.size()));
    if (kind == 4) c_.vertex_halfedge[v] = Halfedge(number(c_.halfedges.size()));
    if (kind == 5) c_.face_halfedge[f] = Halfedge(number(c_.halfedges.size()));
    if (kind == 6 && !c_.first_ring.empty()) c_.first_ring[f] = number(c_.rings.size());
    if (kind == 7 && !c_.rings.empty()) c_.rings[any_of(c_.rings)].next = number(c_.rings.size());
    if (kind == 8 && !c_.rings.empty()) c_.rings[any_of(c_.rings)].halfedge = Halfedge(number(c_.halfedges.size()));
    if (kind == 9 && !c_.next_copy.empty()) c_.next_copy[v] = Vertex(number(c_.next_copy.size()));
    if (kind == 10 && !c_.copy_point.empty()) c_.copy_point[v] = Vertex(number(c_.copy_point.size()));
  }
  static constexpr int kinds = 11;

 private:
  template <class Column>
  std::size_t any_of(const Column& column) {
    return static_cast<std::size_t>(dice_.below(static_cast<int>(column.size() == 0 ? 1 : column.size())));
  }
  std::uint32_t number(std::size_t range) {
    if (dice_.one_in(8)) return no_index;
    return static_cast<std::uint32_t>(dice_.below(static_cast<int>(range + range / 8 + 2)));
  }

  MeshColumns& c_;
  Dice& dice_;
};

std::vector<Mesh> twenty_meshes() {
  std::vector<Mesh> meshes;
  for (const Polygons& faces :
       {tetrahedron(), torus_grid(5, 4), two_quads(), bow_tie(), fin(), moebius_strip(), two_tetrahedra_on_an_edge()})
    meshes.push_back(make_mesh(faces));
  for (std::uint64_t seed = 0; meshes.size() < 20; ++seed) {
    Mesh mesh = random_complex(seed);
    if (mesh.has_rings() && mesh.live().edges > 0) meshes.push_back(std::move(mesh));
  }
  return meshes;
}

TEST(corruption, of_every_link_is_found) {
  const std::uint64_t tries = seed_count(4000);  // on each mesh
  Dice dice(5);
  std::size_t injected = 0, found = 0, valid = 0, by_kind[Corruption::kinds] = {};
  for (const Mesh& sound : twenty_meshes()) {
    ASSERT_FALSE(check_invariants(sound));
    const oracle::Shape shape = shape_of(complex_of(sound));
    for (std::uint64_t i = 0; i < tries; ++i) {
      const int kind = static_cast<int>(i % Corruption::kinds);
      MeshColumns columns = sound.columns();
      Corruption(columns, dice).inject(kind);
      if (columns == sound.columns()) continue;
      ++injected;
      const Mesh broken(std::move(columns));
      if (const auto rule = check_invariants(broken)) {
        ++found;
        ++by_kind[kind];
        EXPECT_FALSE(rule->sentence.empty());
      } else if (shape_of(complex_of(broken)) == shape) {
        ++valid;  // another start of a loop or a vertex, a link of a dead element, or points put together otherwise
      }
    }
  }
  std::cout << "injected " << injected << ", found " << found << ", valid all the same " << valid << "\n";
  EXPECT_GE(1000 * found, 999 * (injected - valid));
  for (std::size_t count : by_kind) EXPECT_GT(count, tries / 40);
}

TEST(corruption, of_many_links_at_once_ends) {
  Dice dice(6);
  for (const Mesh& sound : twenty_meshes())
    for (int i = 0; i < 150; ++i) {
      MeshColumns columns = sound.columns();
      for (int k = 0; k < 30; ++k) Corruption(columns, dice).inject(dice.below(Corruption::kinds));
      EXPECT_TRUE(check_invariants(Mesh(std::move(columns))));
    }
}

}  // namespace
}  // namespace ryosen
