#include "ryosen/algo/parameters.h"

#include <gtest/gtest.h>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

TEST(parameters, fields_are_called_by_their_labels_in_either_language) {
  const std::vector<ParameterRow>& rows = find_algorithm("weld_close")->parameters;
  ASSERT_EQ(rows.size(), 1u);
  const std::string en(rows[0].name_en), ja(rows[0].name_ja);
  EXPECT_NE(ja, rows[0].id);
  const auto read = [&](const std::string& text) { return read_fields(rows, std::vector<std::string>{text}); };
  const Text missing = read("").sentence, wrong = read("-1").sentence;
  EXPECT_TRUE(missing.en.starts_with(en + " is missing: ")) << missing.en;
  EXPECT_TRUE(missing.ja.starts_with(ja + " を指定してください：")) << missing.ja;
  EXPECT_TRUE(wrong.en.starts_with(en + " is ") && wrong.en.ends_with(", not '-1'")) << wrong.en;
  EXPECT_TRUE(wrong.ja.starts_with(ja + " は")) << wrong.ja;
  ASSERT_TRUE(read("0.1%").values);
  EXPECT_EQ(read("0.1%").values->line(), "distance=0.1%");
}

TEST(parameters, an_empty_field_leaves_what_stands_at_first) {
  const std::vector<ParameterRow>& rows = find_algorithm("fill_holes")->parameters;
  const ReadValues read = read_fields(rows, std::vector<std::string>(rows.size()));
  ASSERT_TRUE(read.values);
  EXPECT_EQ(read.values->line(), ParameterValues(rows).line());
}

TEST(parameters, elements_that_are_set_need_no_lookup_as_long_as_they_are_alive) {
  Mesh mesh = test::make_mesh(test::two_quads());
  ParameterValues values(find_algorithm("translate")->parameters);
  const Elements elements{Face(0), Vertex(4)};
  values.set_elements("elements", elements, {"f0", "v4"});
  values.set_place("by", {1, 0, 0});
  EXPECT_EQ(values.text("elements"), "f0,v4");
  ReadValues found = values.on(mesh);
  ASSERT_TRUE(found.values);
  EXPECT_EQ(found.values->elements("elements"), elements);
  EXPECT_EQ(found.values->line(), values.line());
  Edit edit(mesh, nullptr);
  ryosen::apply(edit, *parse_line(mesh, "delete f0").op);
  edit.commit();
  found = values.on(mesh);
  EXPECT_FALSE(found.values);
  EXPECT_EQ(found.error, NameError::deleted);
  EXPECT_EQ(found.name, "f0");
}

TEST(parameters, of_a_halfedge_are_those_of_its_name) {
  const Mesh mesh = test::make_mesh(test::two_quads());
  ParameterValues given(find_algorithm("translate")->parameters), named = given;
  const Halfedge h = mesh.halfedge(Face(0));
  given.set_place("by", {1, 0, 0});
  named.set_place("by", {1, 0, 0});
  given.set_elements("elements", {Element(h)}, {name_of(mesh, h)});
  named.set_names("elements", {name_of(mesh, h)});
  ASSERT_TRUE(given.on(mesh).values && named.on(mesh).values);
  EXPECT_EQ(given.on(mesh).values->elements("elements"), named.on(mesh).values->elements("elements"));
}

}  // namespace
}  // namespace ryosen
