#include "ryosen/analysis/mesh_kind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>

#include "ryosen/analysis/shells.h"
#include "ryosen/indexed/to_indexed.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/boxes.h"
#include "tests/support/core/pairs_by_asking_all.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

std::string id_of(const Mesh& mesh) {
  const KindOfMesh kind = find_kind(mesh, ProblemSets(mesh));
  EXPECT_FALSE(kind.reason.en.empty() || kind.reason.ja.empty());
  return std::string(row_of(kind.kind).id);
}
std::string reason_of(const Mesh& mesh) { return find_kind(mesh, ProblemSets(mesh)).reason.en; }

TEST(mesh_kind, each_kind_has_a_mesh_and_names_its_element) {
  EXPECT_EQ(id_of(make_mesh(fin())), "non_manifold");
  EXPECT_EQ(reason_of(make_mesh(fin())), "Edge 0-1 carries 3 faces.");
  EXPECT_EQ(id_of(make_mesh(bow_tie())), "non_manifold");
  EXPECT_EQ(reason_of(make_mesh(bow_tie())), "The faces at v0 form 2 fans.");
  for (const char* one_sided : {"moebius.off", "klein_bottle.off", "projective_plane.off"})
    EXPECT_EQ(id_of(asset_mesh(one_sided)), "one_sided") << one_sided;
  EXPECT_EQ(id_of(asset_mesh("misoriented.obj")), "misoriented");
  EXPECT_EQ(id_of(make_mesh(two_quads())), "surface");
  EXPECT_EQ(reason_of(make_mesh(two_quads())), "Edge 0-4 has a face on one side only.");
  EXPECT_EQ(id_of(Boxes().cube(0, 1, true).mesh()), "inside_out");
  EXPECT_EQ(reason_of(Boxes().cube(0, 1, true).mesh()), "The faces of the shell of f0 look inwards.");
  EXPECT_EQ(id_of(Boxes().cube(0, 1).mesh()), "solid");
  EXPECT_EQ(id_of(asset_mesh("torus.off")), "solid");
  Mesh wire = make_mesh({}, 3);
  EXPECT_EQ(id_of(wire), "points");
  Edit edit(wire, nullptr);
  ryosen::apply(edit, op_of(wire, "make_edge v0 v1"));
  edit.commit();
  EXPECT_EQ(id_of(wire), "wires");
  EXPECT_EQ(id_of(Mesh()), "empty");
}

TEST(mesh_kind, the_first_that_fits_is_said) {
  // A fin beside a closed cube.
  Polygons faces = fin();
  for (std::vector<std::uint32_t> face : cube()) {
    for (std::uint32_t& v : face) v += 5;
    faces.push_back(face);
  }
  EXPECT_EQ(id_of(make_mesh(faces)), "non_manifold");
  EXPECT_EQ(id_of(make_mesh({{0, 1, 2}, {0, 1, 3}, {4, 5, 6}})), "misoriented") << "and it has a boundary";
}

TEST(mesh_kind, shells_inside_shells_look_away_from_the_solid) {
  EXPECT_EQ(id_of(Boxes().cube(0, 9).cube(3, 6, true).mesh()), "solid");
  EXPECT_EQ(id_of(Boxes().cube(3, 6, true).cube(0, 9).mesh()), "solid");
  EXPECT_EQ(id_of(Boxes().cube(0, 9).cube(3, 6).mesh()), "inside_out");
  EXPECT_EQ(reason_of(Boxes().cube(0, 9).cube(3, 6).mesh()),
            "The shell of f6 lies at depth 1 inside others and its faces look outwards, not inwards.");
  EXPECT_EQ(id_of(Boxes().cube(0, 9, true).cube(3, 6, true).mesh()), "inside_out");
  EXPECT_EQ(id_of(Boxes().cube(0, 9).cube(1, 8, true).cube(2, 7).mesh()), "solid");
  EXPECT_EQ(id_of(Boxes().cube(0, 9).cube(1, 8, true).cube(2, 7, true).mesh()), "inside_out");
  EXPECT_EQ(id_of(Boxes().cube(0, 9).cube(1, 8, true).cube(2, 4).cube(5, 7).mesh()), "solid");
}

TEST(mesh_kind, shells_side_by_side_are_each_judged) {
  EXPECT_EQ(id_of(Boxes().cube(0, 1).cube(2, 3).mesh()), "solid");
  EXPECT_EQ(id_of(Boxes().cube(0, 1).cube(2, 3, true).mesh()), "inside_out");
  // Inside of the box of the holed cube, in its hole.
  Mesh holed = mesh_of_exercise("cube_with_hole");
  IndexedMesh source = to_indexed(holed).mesh;
  const auto first = static_cast<std::uint32_t>(source.positions.size());
  const glm::dvec3 middle(1.5);
  for (const glm::dvec3& p : {glm::dvec3(0), glm::dvec3(.1, 0, 0), glm::dvec3(0, .1, 0), glm::dvec3(0, 0, .1)})
    source.positions.push_back(middle + p);
  for (const std::vector<std::uint32_t>& face :
       {std::vector<std::uint32_t>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    for (const std::uint32_t v : face) source.corners.push_back(first + v);
    source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
  }
  EXPECT_EQ(id_of(from_indexed(source)), "solid");
}

TEST(mesh_kind, shells_that_cross_or_touch_are_a_surface) {
  EXPECT_EQ(id_of(Boxes().cube(0, 2).cube(1, 3).mesh()), "surface");
  EXPECT_TRUE(reason_of(Boxes().cube(0, 2).cube(1, 3).mesh()).starts_with("Two shells cross or touch: faces f"));
  EXPECT_EQ(id_of(Boxes().cube(0, 1).add({1, 0, 0}, {2, 1, 1}).mesh()), "surface") << "along a face";
  EXPECT_EQ(id_of(Boxes().cube(0, 1).cube(1, 2).mesh()), "surface") << "in a corner";
  EXPECT_EQ(id_of(Boxes().cube(0, 1).cube(0, 1).mesh()), "surface") << "at the same place";
}

TEST(mesh_kind, what_encloses_no_volume_is_a_surface) {
  EXPECT_EQ(id_of(make_mesh({{0, 1, 2}, {2, 1, 0}})), "surface") << "two triangles back to back";
  EXPECT_EQ(reason_of(make_mesh({{0, 1, 2}, {2, 1, 0}})), "The shell of f0 encloses no volume.");
  EXPECT_EQ(id_of(Boxes().add({0, 0, 0}, {1, 1, 0}).mesh()), "surface") << "a cube pressed flat";
  EXPECT_EQ(id_of(Boxes().add({0, 0, 0}, {1, 1, 1e-9}).mesh()), "solid") << "thin, but not flat";
  for (const double size : {1e-150, 1e-30, 1e+30, 1e+150, 1e+300}) {
    EXPECT_EQ(id_of(Boxes().cube(0, size).mesh()), "solid") << size;
    EXPECT_EQ(id_of(Boxes().cube(0, size, true).mesh()), "inside_out") << size;
  }
}

TEST(mesh_kind, a_thin_solid_has_a_volume_wherever_it_lies) {
  for (const double length : {1e8, 1e12, 1e-8, 1e-14}) {
    EXPECT_EQ(id_of(Boxes().add({0, 0, 0}, {1, 1, length}).mesh()), "solid") << length;
    EXPECT_EQ(id_of(Boxes().add({0, 0, 0}, {length, 1, 1}, true).mesh()), "inside_out") << length;
  }
  const glm::dvec3 far(1e9, -3e9, 7e9), size(1, 1, 0x1p-20);
  EXPECT_EQ(id_of(Boxes().add(far, far + size).mesh()), "solid");
  EXPECT_EQ(id_of(Boxes().add(far, far + size, true).mesh()), "inside_out");
  EXPECT_EQ(id_of(Boxes().add(far, far + glm::dvec3(1, 1, 0)).mesh()), "surface");
}

// A tilted, bent plate of quads; with thickness 0 both sides are at the same places.
Mesh plate(double thickness) {
  constexpr std::uint32_t n = 8;
  IndexedMesh source;
  for (const double lift : {0.0, thickness})
    for (std::uint32_t i = 0; i <= n; ++i)
      for (std::uint32_t k = 0; k <= n; ++k) {
        const double x = 0.1 * i, y = 0.3 * k;
        source.positions.emplace_back(x, y, 0.7 * x - 0.9 * y + 0.01 * x * y + lift);
      }
  const auto number = [](std::uint32_t side, std::uint32_t i, std::uint32_t k) {
    return side * (n + 1) * (n + 1) + i * (n + 1) + k;
  };
  const auto add = [&](std::vector<std::uint32_t> face) {
    source.corners.insert(source.corners.end(), face.begin(), face.end());
    source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
  };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < n; ++k) {
      add({number(0, i, k), number(0, i, k + 1), number(0, i + 1, k + 1), number(0, i + 1, k)});
      add({number(1, i, k), number(1, i + 1, k), number(1, i + 1, k + 1), number(1, i, k + 1)});
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    add({number(0, i, 0), number(0, i + 1, 0), number(1, i + 1, 0), number(1, i, 0)});
    add({number(0, i + 1, n), number(0, i, n), number(1, i, n), number(1, i + 1, n)});
    add({number(0, 0, i + 1), number(0, 0, i), number(1, 0, i), number(1, 0, i + 1)});
    add({number(0, n, i), number(0, n, i + 1), number(1, n, i + 1), number(1, n, i)});
  }
  return from_indexed(source);
}

TEST(mesh_kind, a_sheet_covered_twice_has_none) {
  EXPECT_EQ(id_of(plate(0)), "surface");
  EXPECT_TRUE(reason_of(plate(0)).ends_with("encloses no volume."));
  for (const double thickness : {1e-3, 1e-9, 1e-14}) {
    EXPECT_EQ(id_of(plate(thickness)), "solid") << thickness;
    EXPECT_EQ(id_of(plate(-thickness)), "inside_out") << thickness;
  }
}

TEST(mesh_kind, a_slanted_polygon_is_flat_whatever_its_shape) {
  for (const std::size_t corners : {4u, 5u, 10u})
    for (const double height : {0x1p-40, 0.0, -0x1p-40}) {
      IndexedMesh source;
      for (const glm::ivec2& p :
           {glm::ivec2(0, 0), {9, 1}, {14, 4}, {15, 7}, {14, 9}, {12, 10}, {9, 11}, {6, 11}, {3, 9}, {1, 5}})
        if (source.positions.size() < corners) source.positions.emplace_back(p.x, p.y, p.x + 2 * p.y);
      const auto tip = static_cast<std::uint32_t>(corners);
      source.positions.emplace_back(8, 2, 12 + height);
      for (std::uint32_t i = tip; i-- > 0;) source.corners.push_back(i);
      source.face_offsets.push_back(tip);
      for (std::uint32_t i = 0; i < tip; ++i) {
        for (const std::uint32_t corner : {i, (i + 1) % tip, tip}) source.corners.push_back(corner);
        source.face_offsets.push_back(source.face_offsets.back() + 3);
      }
      EXPECT_EQ(id_of(from_indexed(source)), height > 0   ? "solid"
                                             : height < 0 ? "inside_out"
                                                          : "surface")
          << corners << " " << height;
    }
}

// Shells in each other, every other one turned over.
Mesh nested_cones(std::uint32_t count, std::uint32_t sides) {
  IndexedMesh source;
  for (std::uint32_t s = count; s > 0; --s) {
    const auto tip = static_cast<std::uint32_t>(source.positions.size());
    source.positions.emplace_back(0, 0, 2.0 * s);
    source.positions.emplace_back(0, 0, -1.0 * s);
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      source.positions.emplace_back(s * std::cos(angle), s * std::sin(angle), -1.0 * s);
    }
    for (std::uint32_t i = 0; i < sides; ++i) {
      std::uint32_t a = tip + 2 + i, b = tip + 2 + (i + 1) % sides;
      if ((count - s) % 2 == 1) std::swap(a, b);
      for (const std::uint32_t corner : {tip, a, b, tip + 1, b, a}) source.corners.push_back(corner);
      for (int k = 0; k < 2; ++k) source.face_offsets.push_back(source.face_offsets.back() + 3);
    }
  }
  return from_indexed(source);
}

TEST(mesh_kind, thousands_of_shells_in_each_other_are_told) {
  EXPECT_EQ(reason_of(nested_cones(4000, 6)), "All 4000 shells are closed and their faces look out of the solid.");
  Boxes boxes;
  for (int i = 0; i < 4000; ++i) boxes.cube(i, 9000 - i, i % 2 == 1);
  EXPECT_EQ(id_of(boxes.mesh()), "solid");
  EXPECT_EQ(reason_of(boxes.cube(4100, 4200).cube(4150, 4250).mesh()).substr(0, 27), "Two shells cross or touch: ");
}

TEST(mesh_kind, a_coordinate_that_is_not_finite_leaves_a_surface) {
  Mesh mesh = Boxes().cube(0, 1).mesh();
  Edit edit(mesh, nullptr);
  edit.set_position(Vertex(3), {std::numeric_limits<double>::quiet_NaN(), 0, 0});
  edit.commit();
  EXPECT_EQ(id_of(mesh), "surface");
  EXPECT_TRUE(reason_of(mesh).starts_with("A coordinate of v3 is not a finite number")) << reason_of(mesh);
}

TEST(mesh_kind, faces_with_rings_enclose_what_their_holes_leave) {
  EXPECT_EQ(id_of(mesh_of_exercise("cube_with_hole")), "solid");
  EXPECT_EQ(id_of(mesh_of_exercise("cube_with_two_holes")), "solid");
}

struct Span {
  glm::dvec3 lowest, highest;
};
bool is_inside(const Span& a, const Span& b) {
  for (int k = 0; k < 3; ++k)
    if (a.lowest[k] <= b.lowest[k] || a.highest[k] >= b.highest[k]) return false;
  return true;
}
bool is_apart(const Span& a, const Span& b) {
  for (int k = 0; k < 3; ++k)
    if (a.lowest[k] > b.highest[k] || b.lowest[k] > a.highest[k]) return true;
  return false;
}

// A box lies in another when all of it does; where corners lie on a grid, rays pass through edges and corners often.
TEST(mesh_kind, depths_of_random_boxes_are_those_of_their_corners) {
  Dice dice(5);
  std::size_t met = 0, deep = 0;
  for (int round = 0; round < 500; ++round) {
    Boxes boxes;
    std::vector<Span> all;
    const int count = 2 + dice.below(3);
    for (int i = 0; i < count; ++i) {
      const auto number = [&](int from, int to) { return static_cast<double>(from + dice.below(to - from + 1)); };
      const glm::dvec3 lowest = i == 0 ? glm::dvec3(0) : glm::dvec3(number(0, 8), number(0, 8), number(0, 8));
      const int least = i == 0 ? 12 : 1, most = i == 0 ? 14 : 4;
      all.push_back({lowest, lowest + glm::dvec3(number(least, most), number(least, most), number(least, most))});
      boxes.add(all.back().lowest, all.back().highest);
    }
    bool meet = false;
    for (const Span& a : all)
      for (const Span& b : all) meet = meet || (&a != &b && !is_inside(a, b) && !is_inside(b, a) && !is_apart(a, b));
    const Mesh mesh = boxes.mesh();
    Neighbourhood around(mesh, Neighbourhood::Reach::whole);
    const Shells shells = find_shells(around);
    ASSERT_EQ(shells.all.size(), all.size());
    ASSERT_EQ(shells.meeting.has_value(), meet) << round;
    met += meet;
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(shells.all[i].turned, 1);
      if (meet) continue;
      const auto depth = std::count_if(all.begin(), all.end(), [&](const Span& b) { return is_inside(all[i], b); });
      EXPECT_EQ(shells.all[i].depth, depth) << round << " " << i;
      deep += depth > 0;
    }
  }
  EXPECT_GT(met, 20u);
  EXPECT_GT(deep, 10u);
}

// Tetrahedra with corners on a grid and between its lines, in and through each other: shells meet where any of their
// faces do, and one lies in another where a ray from it passes the other an odd number of times.
TEST(mesh_kind, shells_of_random_tetrahedra_are_those_of_asking_all) {
  Dice dice(11);
  std::size_t met = 0, deep = 0;
  for (int round = 0; round < 400; ++round) {
    IndexedMesh source;
    const int count = 2 + dice.below(4);
    std::vector<std::array<glm::dvec3, 4>> all;
    for (int i = 0; i < count; ++i) {
      const double size = i == 0 ? 24 : 1 + dice.below(6), unit = dice.one_in(2) ? 1.0 : 0.9;
      const glm::dvec3 at(unit * dice.below(9), unit * dice.below(9), unit * dice.below(9));
      const glm::dvec3 from = i == 0 ? glm::dvec3(-1) : at;
      all.push_back(
          {from, from + glm::dvec3(size, 0, 0), from + glm::dvec3(0, size, 0), from + glm::dvec3(0, 0, size)});
      const auto first = static_cast<std::uint32_t>(source.positions.size());
      for (const glm::dvec3& p : all.back()) source.positions.push_back(p);
      for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
        for (const int k : {a, b, c}) source.corners.push_back(first + static_cast<std::uint32_t>(k));
        source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
      }
    }
    const std::vector<FacePair> pairs = pairs_by_asking_all(source);
    const Mesh mesh = from_indexed(std::move(source));
    Neighbourhood around(mesh, Neighbourhood::Reach::whole);
    const Shells shells = find_shells(around);
    ASSERT_EQ(shells.all.size(), all.size());
    ASSERT_EQ(shells.meeting.has_value(), !pairs.empty()) << round;
    met += !pairs.empty();
    if (shells.meeting) continue;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto is_around = [&](const std::array<glm::dvec3, 4>& other) {
        const glm::dvec3 d = all[i][0] - other[0];
        return d.x > 0 && d.y > 0 && d.z > 0 && d.x + d.y + d.z < other[1].x - other[0].x;
      };
      EXPECT_EQ(shells.all[i].depth, std::count_if(all.begin(), all.end(), is_around)) << round << " " << i;
      deep += shells.all[i].depth > 0;
    }
  }
  EXPECT_GT(met, 20u);
  EXPECT_GT(deep, 20u);
}

}  // namespace
}  // namespace ryosen
