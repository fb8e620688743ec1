// The table of rules against what the operators say: each rule that it lists for an operator fires on some mesh, none
// fires that it does not list, and where it names a remedy that can be applied one helps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <set>

#include "ryosen/base/reasons.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/preview/preview.h"
#include "ryosen/ops/preview/remedy.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

using Key = std::pair<std::string, std::string>;  // operator, rule

struct Instance {
  Mesh mesh;
  AnyOp op;
};

// The number of instances of each reason that are kept and remedied.
const std::size_t most_instances = is_long_run() ? 60 : 20;

std::set<Key> listed(RuleSeverity severity) {
  std::set<Key> keys;
  for (const RuleText& text : rule_table()) {
    if (text.severity != severity) continue;
    for (std::string_view id : split_words(text.operators)) keys.emplace(id, text.id);
  }
  return keys;
}

// Points on a small grid, so that many lie on one line, and two texture coordinates that meet in seams.
Mesh mesh_with_values(std::uint64_t seed) {
  const RandomMesh random = random_mesh(seed);
  Dice dice(seed);
  IndexedMesh list;
  const auto number = [&] { return static_cast<double>(dice.below(3)); };
  for (int p = 0; p < random.points; ++p) list.positions.emplace_back(number(), number(), number());
  list.texcoords.pool = {{0, 0, 0}, {1, 1, 0}};
  list.texcoords.components = 2;
  for (const std::vector<int>& face : random.faces) {
    for (int p : face) {
      list.corners.push_back(static_cast<std::uint32_t>(p));
      list.texcoords.index.push_back(static_cast<std::uint32_t>(dice.below(2)));
    }
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return from_indexed(std::move(list));
}

std::vector<Mesh> registry() {
  std::vector<Mesh> meshes{Mesh()};
  for (const Polygons& faces : {tetrahedron(), cube(), torus_grid(3, 4), two_quads(), closed_fan(3), closed_fan(6),
                                bow_tie(), fin(), moebius_strip(), two_tetrahedra_on_an_edge(), Polygons{{0, 1, 2}},
                                Polygons{{0, 1, 2}, {0, 2, 1}}, Polygons{{0, 1, 2, 3, 4}}})
    meshes.push_back(make_mesh(faces));
  for (std::uint64_t seed = 0; seed < 150; ++seed) meshes.push_back(random_complex(seed));
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    meshes.push_back(mesh_with_values(seed));
    Mesh wires = meshes.back();
    for (std::uint32_t f = 0; f < wires.face_slots(); f += 2) try_apply(wires, nullptr, DeleteLoop{Face(f)});
    meshes.push_back(std::move(wires));
  }
  return meshes;
}

// What every operator says on the meshes of the registry with many random arguments.
class Survey {
 public:
  Survey() {
    Dice dice(1);
    for (const Mesh& mesh : registry())
      for (std::size_t place = 0; place < all_ops().size(); ++place)
        for (int i = is_long_run() ? 40 : 14; i > 0; --i) ask(mesh, random_op(mesh, place, dice));
    ask_where_chance_does_not_lead(dice);
  }

  const std::map<Key, std::size_t>& refused() const { return refused_; }
  const std::map<Key, std::size_t>& warned() const { return warned_; }
  std::vector<Instance> instances(const Key& key) const {
    const auto found = instances_.find(key);
    return found == instances_.end() ? std::vector<Instance>() : found->second;
  }

 private:
  // What random meshes and arguments hardly ever meet.
  void ask_where_chance_does_not_lead(Dice& dice) {
    const Mesh beside = make_mesh({{0, 1, 2, 3}, {1, 0, 4}, {0, 2, 1, 3}});
    const Mesh pillow = make_mesh({{0, 1, 2}, {0, 2, 3}, {0, 3, 2, 1}});
    const Mesh hexagon = make_mesh({{0, 1, 2, 3, 4, 5}, {0, 1, 3, 2}});
    ask(beside, op_of(beside, "unite_loop 0-1"));
    ask(beside, op_of(beside, "dissolve 0-1"));
    ask(pillow, op_of(pillow, "unite_loop 0-2"));
    ask(hexagon, op_of(hexagon, "separate_loop 0 3 f0"));
    ask(hexagon, MakeFace{{Vertex(0), Vertex(2)}});
    ask(hexagon, op_of(hexagon, "split 1-2 1.5"));
    ask(hexagon, op_of(hexagon, "separate_edge 1-2 -0.5"));
    // A corner so near to the edge that the point on it, rounded, lies on the other side.
    for (int i = is_long_run() ? 2000 : 400; i > 0; --i) {
      const glm::dvec3 b{1 + dice.unit(), dice.unit(), 0};
      IndexedMesh sliver;
      sliver.positions = {{0, 0, 0}, b, {0.4 * b.x, std::nextafter(0.4 * b.y, dice.one_in(2) ? 0.0 : 9.0), 0}};
      sliver.corners = {0, 1, 2};
      sliver.face_offsets = {0, 3};
      const Mesh mesh = from_indexed(std::move(sliver));
      ask(mesh, SplitEdge{find_halfedge(mesh, Vertex(0), Vertex(1)), dice.unit()});
    }
  }

  void ask(const Mesh& mesh, const AnyOp& op) {
    const std::string id(info_of(op).id);
    const Verdict verdict = check(mesh, op);
    for (const Reason& reason : verdict.reasons) {
      const Key key{id, std::string(text_of(reason.rule).id)};
      ++refused_[key];
      EXPECT_EQ(text_of(reason.rule).severity, RuleSeverity::refuse) << key.second;
      std::vector<Instance>& kept = instances_[key];
      if (kept.size() < most_instances) kept.push_back({mesh, op});
      // Where it is the only reason a remedy against it is enough.
      else if (verdict.reasons.size() == 1)
        kept[refused_[key] % most_instances] = {mesh, op};
    }
    if (!verdict.legal()) return;
    Mesh scratch = mesh;
    Journal journal;
    for (const Reason& reason : preview(scratch, journal, op).warnings)
      ++warned_[{id, std::string(text_of(reason.rule).id)}];
  }

  std::map<Key, std::size_t> refused_, warned_;
  std::map<Key, std::vector<Instance>> instances_;
};

const RuleText& text_of_id(const std::string& id) {
  const auto table = rule_table();
  return *std::find_if(table.begin(), table.end(), [&](const RuleText& text) { return text.id == id; });
}

void expect_same(const std::map<Key, std::size_t>& fired, const std::set<Key>& wanted) {
  for (const Key& key : wanted)
    EXPECT_TRUE(fired.contains(key)) << key.second << " is listed for " << key.first << " but never fires";
  for (const auto& [key, count] : fired) {
    const bool is_anyones = text_of_id(key.second).operators.empty();
    EXPECT_TRUE(is_anyones || wanted.contains(key)) << key.second << " fires for " << key.first << " but is not listed";
    std::cout << "  " << key.first << " " << key.second << " " << count << "\n";
  }
}

TEST(reasons_table, every_operator_says_when_its_elements_have_been_deleted) {
  std::set<std::string> asked;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Mesh mesh = random_complex(seed);
    Mesh empty = mesh;
    for (std::uint32_t i = 0; i < empty.vertex_slots(); ++i)
      if (empty.is_alive(Vertex(i))) try_apply(empty, nullptr, Delete{Vertex(i)});
    ASSERT_EQ(empty.live(), ElementCounts());
    Dice dice(seed);
    for (std::size_t place = 0; place < all_ops().size(); ++place) {
      const AnyOp op = random_op(mesh, place, dice);
      const auto* triangulate = std::get_if<Triangulate>(&op);
      if (std::holds_alternative<Orient>(op) || std::holds_alternative<MakeVertex>(op)) continue;
      if (triangulate && !triangulate->face) continue;
      EXPECT_TRUE(check(empty, op).has(Rule::deleted)) << command_of(mesh, op);
      EXPECT_TRUE(check(Mesh(), op).has(Rule::deleted)) << command_of(mesh, op);
      asked.emplace(info_of(op).id);
    }
  }
  EXPECT_EQ(asked.size(), all_ops().size() - 2);
}

// Whether the table says that nothing makes it legal, that it is done, or that something else must be named.
bool is_final(const RuleText& text) {
  return text.remedy_en.starts_with("never") || text.remedy_en.starts_with("nothing") ||
         text.remedy_en.starts_with("choose two") || text.rule == Rule::deleted;
}

// Applies what find_remedy() says; whether the operator is legal then.
bool is_remedied(const Instance& instance) {
  Mesh mesh = instance.mesh;
  const ParsedOp named = parse_line(mesh, command_of(mesh, instance.op));
  if (!named.op || check(mesh, *named.op).legal()) return false;
  // Corners in two faces have no line of their own; this is the one that is spoken of from here on.
  const std::string line = command_of(mesh, *named.op);
  const std::vector<std::string> steps = find_remedy(mesh, *named.op);
  EXPECT_EQ(mesh.columns(), instance.mesh.columns()) << line;
  if (steps.empty()) return false;
  for (const std::string& step : steps) {
    const ParsedOp parsed = parse_line(mesh, step);
    EXPECT_TRUE(parsed.op && try_apply(mesh, nullptr, *parsed.op)) << step << " against " << line;
  }
  const ParsedOp again = parse_line(mesh, line);
  EXPECT_TRUE(again.op && check(mesh, *again.op).legal()) << line << " after " << steps.back();
  return true;
}

void expect_remedies(const Survey& survey) {
  for (const RuleText& text : rule_table()) {
    if (text.severity != RuleSeverity::refuse || is_final(text)) continue;
    std::size_t helped = 0, tried = 0;
    for (std::string_view id : split_words(text.operators))
      for (const Instance& instance : survey.instances({std::string(id), std::string(text.id)})) {
        if (++tried; is_remedied(instance)) ++helped;
      }
    std::cout << "  " << text.id << ": remedied " << helped << " of " << tried << "\n";
    EXPECT_GT(helped, 0u) << text.id << ": no remedy helps, but the table names one: " << text.remedy_en;
  }
}

TEST(reasons_table, what_is_listed_fires_and_nothing_else_and_each_remedy_that_is_named_helps) {
  const Survey survey;
  expect_same(survey.refused(), listed(RuleSeverity::refuse));
  expect_same(survey.warned(), listed(RuleSeverity::warn));
  for (const char* id : {"collapse", "swap", "move_vertex"}) EXPECT_TRUE(survey.warned().contains({id, "intersects"}));
  expect_remedies(survey);
}

}  // namespace
}  // namespace ryosen
