// An element as an argument is read as its printed name is.
#include "ryosen/ops/parameters/op_argument.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

ParsedOp parse_elements(const Mesh& mesh, std::string_view id, const Elements& elements,
                        std::vector<std::string_view> words = {}) {
  return parse_op(mesh, id, op_arguments(elements, words));
}

Elements living_elements(const Mesh& mesh) {
  Elements all;
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i)
    for (const Element& e : {Element(Vertex(i)), Element(Halfedge(i)), Element(Edge(i)), Element(Face(i))})
      if (is_alive(mesh, e)) all.push_back(e);
  return all;
}

TEST(OpArgument, an_element_is_read_as_its_printed_name) {
  Dice dice(11);
  std::size_t read = 0, failed = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Mesh mesh = random_complex(seed);
    const Elements all = living_elements(mesh);
    if (all.empty()) continue;
    for (const OpInfo& op : all_ops()) {
      for (int i = 0; i < 40; ++i) {
        Elements elements;
        for (int n = 1 + dice.below(4); n > 0; --n) elements.push_back(all[dice.below(static_cast<int>(all.size()))]);
        std::string line(op.id);
        for (const Element& e : elements) line += " " + print_argument(mesh, e);
        const std::vector<std::string_view> words = split_words(line);
        const auto named = op_arguments(std::span(words).subspan(1)), given = op_arguments(elements);
        ASSERT_EQ(first_misfit(op.line, given), first_misfit(op.line, named)) << seed << " " << line;
        ASSERT_EQ(bool(fault_of_arguments(op.id, given)), bool(fault_of_arguments(op.id, named)))
            << seed << " " << line;
        const ParsedOp by_name = parse_op(mesh, op.id, named), by_element = parse_op(mesh, op.id, given);
        ASSERT_EQ(by_element.error, by_name.error) << seed << " " << line;
        EXPECT_EQ(by_element.op, by_name.op) << seed << " " << line;
        if (by_name.error != NameError::malformed) {
          EXPECT_EQ(by_element.sentence.en, by_name.sentence.en);
        }
        ++(by_element.op ? read : failed);
      }
    }
  }
  EXPECT_GT(read, 1000u);
  EXPECT_GT(failed, 1000u);
}

TEST(OpArgument, a_vertex_is_that_copy_of_its_point) {
  const Mesh mesh = make_mesh(bow_tie());
  Vertex v;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (has_copies(mesh, Vertex(i))) v = Vertex(i);
  ASSERT_TRUE(v);
  const std::string point_name = name_of(mesh, v);
  EXPECT_EQ(parse_line(mesh, "dissolve " + point_name).error, NameError::ambiguous);
  for_each_copy(mesh, v, [&](Vertex copy) {
    const ParsedOp parsed = parse_elements(mesh, "dissolve", {copy});
    ASSERT_TRUE(parsed.op) << parsed.sentence.en;
    EXPECT_EQ(std::get<Dissolve>(*parsed.op).vertex, copy);
    EXPECT_EQ(print_argument(mesh, Element(copy)), name_of_copy(mesh, copy));
  });
}

// Three sheets on 0-1: each edge is its own, from the lower point; each halfedge has its direction.
TEST(OpArgument, an_edge_is_its_sheet_and_a_halfedge_its_direction) {
  const Mesh mesh = make_mesh(fin());
  EXPECT_EQ(parse_line(mesh, "split 0-1").error, NameError::ambiguous);
  const std::vector<Halfedge> sheets = sheets_between(mesh, Vertex(0), Vertex(1));
  ASSERT_EQ(sheets.size(), 3u);
  for (const Halfedge h : sheets) {
    const auto side = [&](const Element& e) {
      const ParsedOp parsed = parse_elements(mesh, "split", {e});
      return parsed.op ? halfedge_of(*parsed.op) : Halfedge();
    };
    EXPECT_EQ(side(edge(h)), h);
    EXPECT_EQ(side(h), h);
    EXPECT_EQ(side(twin(h)), twin(h));
  }
}

TEST(OpArgument, an_element_that_is_not_there_is_refused_as_its_name_is) {
  Mesh mesh = make_mesh(two_quads());
  Edit edit(mesh, nullptr);
  ryosen::apply(edit, *parse_line(mesh, "delete f0").op);
  edit.commit();
  const auto fault = [&](std::string_view id, const Element& e) {
    const ParsedOp parsed = parse_elements(mesh, id, {e}),
                   named = parse_line(mesh, std::string(id) + " " + slot_name(e));
    EXPECT_FALSE(parsed.op);
    EXPECT_EQ(parsed.error, named.error) << id;
    EXPECT_EQ(parsed.sentence.en, named.sentence.en);
    EXPECT_EQ(parsed.sentence.ja, named.sentence.ja);
    return parsed.sentence.en;
  };
  EXPECT_EQ(fault("poke", Face(0)), "f0 is no longer in the mesh");
  EXPECT_EQ(fault("poke", Face(7)), "f7 does not exist");
  EXPECT_EQ(fault("unite_edge", Vertex(99)), "v99 does not exist");
  EXPECT_EQ(fault("split", Edge(99)), "e99 does not exist");
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i))) {
      EXPECT_EQ(fault("split", Edge(i)), "e" + std::to_string(i) + " is no longer in the mesh");
    }
  }
  EXPECT_EQ(fault("poke", Vertex(1)), "'v1' is not a name; expected f3");
}

TEST(OpArgument, a_position_is_one_where_it_is_finite) {
  const Mesh mesh = make_mesh(tetrahedron());
  const Edge e = edge(sheets_between(mesh, Vertex(0), Vertex(1)).front());
  const glm::dvec3 place(0.1, -2e-9, 3);
  const OpArgument arguments[] = {Element(e), place};
  EXPECT_EQ(parse_op(mesh, "collapse", arguments).op, parse_line(mesh, "collapse 0-1 0.1,-2e-9,3").op);
  EXPECT_FALSE(fault_of_arguments("collapse", arguments));
  const OpArgument endless = glm::dvec3(std::numeric_limits<double>::infinity(), 0, 0);
  const OpArgument beyond[] = {Element(e), endless};
  const ParsedOp parsed = parse_op(mesh, "collapse", beyond);
  EXPECT_EQ(parsed.error, NameError::malformed);
  EXPECT_TRUE(parsed.sentence.en.starts_with("'" + print_argument(mesh, endless) + "' is not understood"))
      << parsed.sentence.en;
}

TEST(OpArgument, any_element_of_a_kind_fits_its_places) {
  const auto fits = [](std::string_view id, Element::Kind kind, std::size_t count) {
    return !first_misfit(find_op(id)->line, op_arguments(kind, count, {}));
  };
  EXPECT_TRUE(fits("collapse", Element::Kind::edge, 1));
  EXPECT_TRUE(fits("collapse", Element::Kind::halfedge, 1));
  EXPECT_FALSE(fits("collapse", Element::Kind::vertex, 1));
  EXPECT_TRUE(fits("weld", Element::Kind::vertex, 2));
  EXPECT_FALSE(fits("weld", Element::Kind::face, 2));
}

}  // namespace
}  // namespace ryosen
