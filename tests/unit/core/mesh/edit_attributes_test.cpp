// Attributes that an edit adds, removes and writes, through the history.
#include <gtest/gtest.h>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/valued_sheet.h"

namespace ryosen {
namespace {

constexpr ElementKind kinds[] = {ElementKind::vertex, ElementKind::edge, ElementKind::corner, ElementKind::face};
constexpr ValueRule rules[] = {ValueRule::blend, ValueRule::first, ValueRule::greatest, ValueRule::sum};

AttributeColumn random_column(const std::string& name, Dice& dice) {
  const ElementKind kind = kinds[dice.below(4)];
  const ValueRule rule = rules[dice.below(4)];
  switch (dice.below(5)) {
    case 0:
      return make_column(name, kind, rule, dice.one_in(2));
    case 1:
      return make_column(name, kind, rule, static_cast<std::int16_t>(dice.below(1000) - 500));
    case 2:
      return make_column(name, kind, rule, glm::u8vec4(static_cast<std::uint8_t>(dice.below(256))));
    case 3:
      return make_column(name, kind, rule, static_cast<float>(dice.unit()));
    default:
      return make_column(name, kind, rule, glm::dvec2(dice.unit(), -3));
  }
}

std::vector<std::size_t> live_attributes(const Mesh& mesh) {
  std::vector<std::size_t> live;
  for (std::size_t k = 0; k < mesh.attributes().size(); ++k)
    if (mesh.attributes()[k].is_removed == 0) live.push_back(k);
  return live;
}

void write_some_values(Edit& edit, Dice& dice) {
  const std::vector<std::size_t> live = live_attributes(edit.mesh());
  for (int i = 0; i < 5 && !live.empty(); ++i) {
    const std::size_t k = live[static_cast<std::size_t>(dice.below(static_cast<int>(live.size())))];
    const AttributeColumn& column = edit.mesh().attributes()[k];
    const std::size_t count = column.data.size() / column.words();
    if (count == 0 || column.element == ElementKind::pool) continue;
    std::vector<std::uint32_t> value = column.fill;
    value.front() ^= static_cast<std::uint32_t>(dice.below(column.type.scalar == Scalar::boolean ? 2 : 7));
    edit.set_attribute(k, static_cast<std::uint32_t>(dice.below(static_cast<int>(count))), value);
  }
}

bool change_at_random(Mesh& mesh, Journal& journal, Dice& dice, int& added) {
  if (dice.one_in(2)) return test::edit_at_random(mesh, journal, dice);
  Edit edit(mesh, &journal);
  if (dice.one_in(3)) edit.add_attribute(random_column("own" + std::to_string(added++), dice));
  const std::vector<std::size_t> live = live_attributes(mesh);
  if (!live.empty() && dice.one_in(6))
    edit.remove_attribute(live[static_cast<std::size_t>(dice.below(static_cast<int>(live.size())))]);
  write_some_values(edit, dice);
  if (dice.one_in(5)) return false;  // rolls back
  edit.commit();
  return true;
}

void walk(std::uint64_t seed, int attributes_at_first, int steps) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Mesh mesh = test::random_kernel_mesh(seed);
  Journal journal;
  Dice dice(seed);
  int added = 0;
  std::vector<MeshColumns> states{mesh.columns()};
  {
    Edit edit(mesh, &journal);
    while (added < attributes_at_first) edit.add_attribute(random_column("own" + std::to_string(added++), dice));
    edit.commit();
    states.push_back(mesh.columns());
  }
  for (int step = 0; step < steps; ++step) {
    if (journal.can_undo() && dice.one_in(3)) {
      journal.undo(mesh);
    } else if (journal.can_redo() && dice.one_in(2)) {
      journal.redo(mesh);
    } else if (change_at_random(mesh, journal, dice, added)) {
      states.resize(journal.position());
      states.push_back(mesh.columns());
    }
    ASSERT_EQ(states[journal.position()], mesh.columns()) << "step " << step;
    const auto broken = check_invariants(mesh);
    ASSERT_FALSE(broken) << broken->sentence;
  }
  while (journal.can_undo()) journal.undo(mesh);
  EXPECT_EQ(mesh.columns(), states.front());
  while (journal.can_redo()) journal.redo(mesh);
  EXPECT_EQ(mesh.columns(), states[journal.size()]);
}

TEST(edit_attributes, undo_and_redo_are_exact_on_random_walks) {
  for (std::uint64_t seed = 0; seed < test::seed_count(40, 400); ++seed) walk(seed, 0, 60);
}

TEST(edit_attributes, there_may_be_more_than_a_thousand) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) walk(seed, 1100, 25);
}

TEST(edit_attributes, a_removed_one_is_not_found_and_its_name_is_free) {
  Mesh mesh = test::random_kernel_mesh(1);
  Journal journal;
  const auto add = [&](double value) {
    Edit edit(mesh, &journal);
    edit.add_attribute("weight", ElementKind::vertex, ValueRule::blend, value);
    edit.commit();
  };
  add(1);
  {
    Edit edit(mesh, &journal);
    edit.remove_attribute(0);
    edit.commit();
  }
  EXPECT_EQ(mesh.find_attribute("weight"), -1);
  add(2);
  EXPECT_EQ(mesh.find_attribute("weight"), 1);
  journal.undo(mesh);
  journal.undo(mesh);
  EXPECT_EQ(mesh.find_attribute("weight"), 0);
  EXPECT_EQ(attribute_value<double>(mesh.attributes()[0], 0), 1);
  journal.undo(mesh);
  EXPECT_TRUE(mesh.attributes().empty());
  journal.redo(mesh);
  journal.redo(mesh);
  journal.redo(mesh);
  EXPECT_EQ(mesh.find_attribute("weight"), 1);
}

TEST(edit_attributes, a_withdrawn_edit_takes_its_attribute_along) {
  Mesh mesh = test::random_kernel_mesh(2);
  const MeshColumns before = mesh.columns();
  Journal journal;
  {
    Edit edit(mesh, &journal);
    const std::size_t k = edit.add_attribute("mark", ElementKind::face, ValueRule::first, std::uint8_t{3});
    const std::uint32_t value[] = {4};
    edit.set_attribute(k, 0, value);
    edit.commit();
  }
  journal.withdraw(mesh);
  EXPECT_EQ(mesh.columns(), before);
  EXPECT_EQ(journal.size(), 0u);
}

TEST(edit_attributes, new_elements_get_the_default_and_writes_of_new_cells_cost_no_history) {
  Mesh mesh = test::random_kernel_mesh(3);
  Journal journal;
  std::size_t k = 0, e = 0;
  {
    Edit edit(mesh, &journal);
    k = edit.add_attribute("weight", ElementKind::vertex, ValueRule::sum, 2.5f);
    e = edit.add_attribute("crease", ElementKind::edge, ValueRule::sum, glm::dvec2(1, 2));
    edit.commit();
  }
  Edit edit(mesh, &journal);
  const Vertex a = edit.add_vertex({});
  edit.fresh(a);
  EXPECT_EQ(attribute_value<float>(mesh.attributes()[k], a.index), 2.5f);
  EXPECT_EQ(mesh.attributes()[e].data.size(), std::size_t{4} * mesh.edge_slots());
  edit.set_attribute(k, a.index, attribute_words(7.0f));
  edit.set_attribute(k, 0, attribute_words(8.0f));
  edit.commit();
  EXPECT_EQ(journal.touched(1).size(), 1u) << "the value of the old vertex alone";
  journal.undo(mesh);
  EXPECT_EQ(attribute_value<float>(mesh.attributes()[k], 0), 2.5f);
  journal.redo(mesh);
  EXPECT_EQ(attribute_value<float>(mesh.attributes()[k], a.index), 7.0f);
}

TEST(edit_attributes, a_corner_attribute_and_its_pool_are_removed_together) {
  for (const bool by_pool : {false, true}) {
    Mesh mesh = test::valued_sheet(2);
    const MeshColumns before = mesh.columns();
    Journal journal;
    {
      Edit edit(mesh, &journal);
      const CornerAttribute texture = corner_attributes(mesh).front();
      edit.remove_attribute(by_pool ? texture.pool_column : texture.index_column);
      edit.commit();
    }
    EXPECT_TRUE(corner_attributes(mesh).empty());
    EXPECT_FALSE(find_column(mesh, attribute_names::texcoord) || find_column(mesh, attribute_names::texcoord_pool));
    EXPECT_TRUE(touched_elements(mesh, journal, 0).everything);
    journal.undo(mesh);
    EXPECT_EQ(mesh.columns(), before);
  }
}

void longest_word(const ValueSources& sources, std::uint32_t* value) {
  for (std::size_t i = 0; i < sources.values.size(); ++i) *value = std::max(*value, *sources.values[i]);
}

TEST(edit_attributes, an_own_rule_is_asked_by_operators_and_undone) {
  Mesh mesh = test::make_mesh({{0, 1, 2}, {2, 1, 3}});
  Journal journal;
  std::size_t k = 0;
  {
    Edit edit(mesh, &journal);
    k = edit.add_attribute("level", ElementKind::vertex, longest_word, std::uint32_t{1});
    edit.set_attribute(k, 1, attribute_words(std::uint32_t{7}));
    edit.set_attribute(k, 2, attribute_words(std::uint32_t{5}));
    edit.commit();
  }
  const MeshColumns before = mesh.columns();
  Edit edit(mesh, &journal);
  ryosen::apply(edit, SplitEdge{find_halfedge(mesh, Vertex(1), Vertex(2)), 0.5});
  edit.commit();
  EXPECT_EQ(attribute_value<std::uint32_t>(mesh.attributes()[k], 4), 7u);
  journal.undo(mesh);
  EXPECT_EQ(mesh.columns(), before);
}

}  // namespace
}  // namespace ryosen
