#include "ryosen/textbook/forms/pairing.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

// The definition, over a map of point pairs.
SidePartners expected_partners(const IndexedMesh& mesh) {
  struct Side {
    std::uint32_t corner;
    bool forward;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Side>> between;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
      between[std::minmax(a, b)].push_back({mesh.face_offsets[f] + static_cast<std::uint32_t>(i), a < b});
    }
  }
  SidePartners partners(mesh.corners.size(), no_index);
  for (const auto& [points, sides] : between) {
    if (sides.size() != 2 || sides[0].forward == sides[1].forward) continue;
    partners[sides[0].corner] = sides[1].corner;
    partners[sides[1].corner] = sides[0].corner;
  }
  return partners;
}

void expect_all_agree(const IndexedMesh& mesh, const std::string& name) {
  const SidePartners expected = expected_partners(mesh);
  for (const PairingMethod& method : pairing_methods())
    EXPECT_EQ(method.pair(mesh), expected) << method.id << " on " << name;
}

TEST(pairing, methods_agree_on_shapes) {
  for (const Polygons& faces : {tetrahedron(), cube(), torus_grid(5, 7), two_quads(), closed_fan(9), bow_tie(), fin(),
                                moebius_strip(), two_tetrahedra_on_an_edge(), Polygons{}})
    expect_all_agree(indexed(faces), "a shape");
}

TEST(pairing, methods_agree_on_random_meshes) {
  std::size_t cut = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    const IndexedMesh mesh = indexed(random.faces, random.points);
    expect_all_agree(mesh, "seed " + std::to_string(seed));
    cut += make_mesh(random.faces, random.points).has_copies();
  }
  EXPECT_GT(cut, 20u);
}

// Points whose numbers differ by multiples of 65,536 have equal keys, yet their sides must not be joined.
TEST(pairing, equal_keys_are_not_equal_sides) {
  const std::uint32_t far = 1u << 16u;
  ASSERT_EQ(sixteen_bit_key(1, 2), sixteen_bit_key(1, 2 + far));
  const IndexedMesh mesh = indexed({{1, 2, 3}, {2, 1, 4}, {1, 2 + far, 5}, {2 + far, 1, 6}, {1 + far, 2, 7}});
  expect_all_agree(mesh, "points that are 65,536 apart");
  EXPECT_EQ(pairing_methods()[1].pair(mesh)[0], 3u);
}

TEST(pairing, key_of_the_texts_is_unique_for_few_points) {
  std::map<std::uint32_t, int> keys;
  for (std::uint32_t a = 65000; a < 65200; ++a)
    for (std::uint32_t b = a + 1; b < 65200; ++b) ++keys[sixteen_bit_key(b, a)];
  EXPECT_EQ(keys.size(), 200u * 199u / 2);
}

TEST(pairing, first_faces_keep_their_numbers) {
  const IndexedMesh whole = indexed(cube());
  const IndexedMesh part = first_faces(whole, 2);
  ASSERT_EQ(part.face_count(), 2u);
  EXPECT_EQ(part.positions.size(), whole.positions.size());
  for (std::size_t f = 0; f < 2; ++f)
    EXPECT_TRUE(std::equal(part.face(f).begin(), part.face(f).end(), whole.face(f).begin(), whole.face(f).end()));
  EXPECT_EQ(first_faces(whole, 0).face_count(), 0u);
}

TEST(pairing, steps_grow_with_the_square_for_brute_force_alone) {
  const IndexedMesh small = indexed(torus_grid(10, 10)), large = indexed(torus_grid(20, 20));
  for (const PairingMethod& method : pairing_methods()) {
    const double growth = method.steps(large) / method.steps(small);
    EXPECT_NEAR(growth, method.id == "brute_force" ? 16.0 : 4.0, 1e-9) << method.id;
  }
  const IndexedMesh fan = indexed(closed_fan(1000));
  for (const PairingMethod& method : pairing_methods())
    if (method.id == "vertex_lists") {
      EXPECT_GT(method.steps(fan), 1e6);
    }
}

}  // namespace
}  // namespace ryosen::test
