// Colours and texture in the error of a collapse: linear ones cost nothing and stay exact, borders of colours stay
// where they are, and without weight or values nothing differs.
#include <gtest/gtest.h>

#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/base/parallel.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/triangle_corners.h"
#include "tests/support/core/simplified.h"
#include "tests/support/core/valued_sheet.h"

namespace ryosen::test {
namespace {

using ColourOf = std::function<glm::dvec4(const glm::dvec3&)>;

void paint(Mesh& mesh, const ColourOf& colour_of) {
  Edit edit(mesh, nullptr);
  const int found = mesh.find_attribute(attribute_names::colour);
  const std::size_t column =
      found >= 0 ? static_cast<std::size_t>(found)
                 : edit.add_attribute(attribute_names::colour, ElementKind::vertex, ValueRule::blend, glm::dvec4(0));
  for (const Vertex v : live_vertices(mesh))
    edit.set_attribute(column, v.index, attribute_words(colour_of(mesh.position(v))));
  edit.commit();
}

glm::dvec4 colour_of_vertex(const Mesh& mesh, Vertex v) {
  return attribute_value<glm::dvec4>(*find_column(mesh, attribute_names::colour), v.index);
}

TEST(AttributeError, linear_values_stay_exact) {
  const glm::dmat3 turned(glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(1, 2, 3)));
  for (const char* const weight : {"0.005", "1", "100"})
    for (const char* const effort : {"0", "1", "2"}) {
      const std::string words = std::string("faces=50 colour_weight=") + weight + " effort=" + effort;
      SCOPED_TRACE(words);
      Mesh flat = valued_sheet(12), seamed = valued_sheet(12, 0.5), oblique = valued_sheet(12, 0.5, turned),
           squares = valued_sheet(12, no_seam, turned, false);
      simplified(flat, words);
      simplified(seamed, words);
      simplified(oblique, words);
      simplified(squares, words + " triangulate=on");
      EXPECT_LE(flat.live().faces, 50u);
      EXPECT_LE(squares.live().faces, 50u);
      EXPECT_LT(worst_value(flat), 1e-9);
      EXPECT_LT(worst_value(seamed, 0.5), 1e-9);
      EXPECT_LT(worst_value(oblique, 0.5, turned), 1e-9);
      EXPECT_LT(worst_value(squares), 1e-9);
    }
}

TEST(AttributeError, all_four_channels_of_a_colour_are_linear_by_themselves) {
  const ColourOf ramp = [](const glm::dvec3& p) {
    return glm::dvec4(0.3, 0.1 + 0.04 * p.x, 0.9 - 0.03 * p.y, 0.2 + 0.01 * p.x + 0.02 * p.y);
  };
  Mesh mesh = sheet(16, [](std::uint32_t, std::uint32_t) { return 0.0; });
  paint(mesh, ramp);
  simplified(mesh, "faces=50 colour_weight=1");
  EXPECT_LE(mesh.live().faces, 50u);
  for (const Vertex v : live_vertices(mesh)) {
    EXPECT_LT(glm::distance(colour_of_vertex(mesh, v), ramp(mesh.position(v))), 1e-12);
    EXPECT_EQ(colour_of_vertex(mesh, v).x, 0.3);
  }
}

// The largest distance from a border at x = 8 at which a face has both colours.
double width_of_border(const Mesh& mesh) {
  double width = 0;
  for (const Face f : live_faces(mesh)) {
    double darkest = 1, brightest = 0, farthest = 0;
    for (const Halfedge h : halfedges_around(mesh, f)) {
      const double grey = colour_of_vertex(mesh, mesh.from(h)).x;
      darkest = std::min(darkest, grey);
      brightest = std::max(brightest, grey);
      farthest = std::max(farthest, std::abs(mesh.position(mesh.from(h)).x - 8));
    }
    if (brightest - darkest > 0.3) width = std::max(width, farthest);
  }
  return width;
}

TEST(AttributeError, a_border_of_colours_stays_with_weight_and_wanders_off_without) {
  const ColourOf halves = [](const glm::dvec3& p) { return glm::dvec4(glm::dvec3(p.x > 8 ? 1 : 0), 1); };
  Mesh input = sheet(16, [](std::uint32_t, std::uint32_t) { return 0.0; });
  paint(input, halves);
  EXPECT_EQ(width_of_border(input), 1);
  for (const char* const effort : {"0", "1", "2"}) {
    SCOPED_TRACE(effort);
    Mesh with = input, without = input;
    simplified(with, std::string("faces=80 colour_weight=1 effort=") + effort);
    simplified(without, std::string("faces=80 colour_weight=0 effort=") + effort);
    EXPECT_LT(width_of_border(with), 1.5);
    EXPECT_GT(width_of_border(without), 2);
  }
}

// Places and faces alone.
std::vector<glm::dvec3> shape_of(const Mesh& mesh) {
  std::vector<glm::dvec3> places;
  for (const Face f : live_faces(mesh))
    for (const Halfedge h : halfedges_around(mesh, f)) places.push_back(mesh.position(mesh.from(h)));
  return places;
}

TEST(AttributeError, weight_0_or_one_colour_everywhere_leave_the_shape_of_a_mesh_without_colours) {
  for (const char* const words : {"faces=100 ", "faces=100 effort=0 ", "faces=100 effort=2 ", "error=0.4 ",
                                  "faces=100 no_self_intersections=on "}) {
    SCOPED_TRACE(words);
    Mesh plain = sheet(16, wave), weighed = plain, even = plain, coloured = plain, counted = plain;
    paint(even, [](const glm::dvec3&) { return glm::dvec4(0.25, 0.5, 0.75, 1); });
    paint(coloured, [](const glm::dvec3& p) { return glm::dvec4(0.5 + 0.5 * std::sin(p.x), 0, 0, 1); });
    counted = coloured;
    simplified(plain, std::string(words) + "colour_weight=0");
    simplified(weighed, std::string(words) + "colour_weight=10");
    simplified(even, std::string(words) + "colour_weight=10");
    simplified(coloured, std::string(words) + "colour_weight=0");
    simplified(counted, std::string(words) + "colour_weight=1");
    EXPECT_EQ(weighed.columns(), plain.columns());
    EXPECT_EQ(shape_of(even), shape_of(plain));
    EXPECT_EQ(shape_of(coloured), shape_of(plain));
    EXPECT_NE(shape_of(counted), shape_of(plain));
    for (const Vertex v : live_vertices(even)) EXPECT_EQ(colour_of_vertex(even, v), glm::dvec4(0.25, 0.5, 0.75, 1));
  }
}

TEST(AttributeError, undo_and_threads_give_the_same_bytes) {
  Mesh mesh = valued_sheet(20, 0.5);
  paint(mesh, [](const glm::dvec3& p) { return glm::dvec4(p.x > 0.3, 0.5 + 0.5 * std::sin(20 * p.y), p.x * p.y, 1); });
  for (const char* const words :
       {"faces=90 colour_weight=1", "faces=90 colour_weight=1 effort=0", "faces=90 colour_weight=0.1 effort=2",
        "faces=90 colour_weight=1 seams=keep", "faces=90 colour_weight=1 seams=drop"}) {
    SCOPED_TRACE(words);
    std::optional<MeshColumns> first;
    for (const unsigned threads : {1u, 3u}) {
      const ThreadCount count(threads);
      Mesh made = mesh;
      Journal journal;
      ASSERT_GT(run_algorithm(made, journal, std::string("simplify ") + words).changed, 0u);
      EXPECT_FALSE(check_invariants(made));
      if (!first) first = made.columns();
      EXPECT_EQ(made.columns(), *first);
      journal.undo(made);
      EXPECT_EQ(made.columns(), mesh.columns());
    }
  }
}

TEST(AttributeError, cancelling_anywhere_leaves_the_mesh_as_it_is) {
  Mesh sheet_of_waves = sheet(24, wave), seamed = valued_sheet(20, 0.5);
  for (Mesh* const mesh : {&sheet_of_waves, &seamed})
    paint(*mesh, [](const glm::dvec3& p) { return glm::dvec4(0.5 + 0.5 * std::sin(2 * p.x), 0.5, 0, 1); });
  const AlgorithmRow& row = *find_algorithm("simplify");
  for (const Mesh* const input : {&sheet_of_waves, &seamed})
    for (const char* const words :
         {"faces=90", "faces=90 effort=2", "faces=90 colour_weight=1 effort=2", "faces=2", "faces=90 effort=0"}) {
      SCOPED_TRACE(words);
      bool was_cancelled = true;
      for (int reports = 0; was_cancelled; ++reports) {
        Mesh mesh = *input;
        Journal journal;
        int left = reports;
        Progress cancelling([&](double) { return left-- > 0; }, Progress::Clock::duration::zero());
        Edit edit(mesh, &journal);
        const AlgorithmResult result =
            row.run(edit, {*read_values(row.parameters, split_words(words)).values->on(mesh).values}, cancelling);
        was_cancelled = cancelling.is_cancelled();
        if (!was_cancelled) continue;
        ASSERT_EQ(result.goal_report->stopped, Stop::cancelled) << reports;
        ASSERT_EQ(result.changed, 0u) << reports;
        ASSERT_EQ(mesh.columns(), input->columns()) << reports;
      }
    }
}

// A colour that is missing, or one that is no number, has no say and stays one that is none.
TEST(AttributeError, vertices_without_a_colour_count_for_nothing) {
  Mesh mesh = sheet(12, [](std::uint32_t, std::uint32_t) { return 0.0; });
  const double none = std::numeric_limits<double>::quiet_NaN();
  paint(mesh, [&](const glm::dvec3& p) { return p.x > 6 ? glm::dvec4(none) : glm::dvec4(p.y / 12, 0.5, 0, 1); });
  simplified(mesh, "faces=60 colour_weight=1");
  EXPECT_LE(mesh.live().faces, 60u);
  for (const Vertex v : live_vertices(mesh)) {
    const glm::dvec4 colour = colour_of_vertex(mesh, v);
    EXPECT_TRUE(is_finite(mesh.position(v)));
    EXPECT_TRUE(std::isnan(colour.x) || std::abs(colour.x - mesh.position(v).y / 12) < 1e-9) << colour.x;
  }
}

}  // namespace
}  // namespace ryosen::test
