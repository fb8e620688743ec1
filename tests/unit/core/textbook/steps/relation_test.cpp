// Neighbours found step by step on every form are those that the form answers itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/all.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/steps/all.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/played_steps.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;
using steps::Step;

// A form's own answer in slots of the mesh. Only for meshes without gaps and copies.
std::set<Element> own_answer(const Mesh& mesh, const forms::FormRow& row, const forms::RelationRow& relation,
                             Element element, bool& is_told) {
  const std::unique_ptr<forms::Form> form = row.make(mesh);
  std::uint32_t number = element.index;
  if (relation.asks == forms::ElementOf::edge)
    number = form->find_edge(mesh.from(halfedge(element.edge())).index, mesh.to(halfedge(element.edge())).index);
  forms::Answer answer;
  is_told = form->answer(relation.relation, number, answer);
  std::set<Element> all;
  const std::string_view id = relation.id;
  for (const std::uint32_t n : answer.numbers)
    all.insert(id.ends_with("faces") ? Element(Face(n)) : Element(Vertex(n)));
  for (const forms::EdgeEnds& ends : answer.edges)
    all.insert(edge(find_halfedge(mesh, Vertex(ends.a), Vertex(ends.b))));
  return all;
}

void expect_relations(const Mesh& mesh) {
  for (const forms::RelationRow& relation : forms::relations()) {
    const std::uint32_t count = relation.asks == forms::ElementOf::vertex ? mesh.vertex_slots()
                                : relation.asks == forms::ElementOf::edge ? mesh.edge_slots()
                                                                          : mesh.face_slots();
    for (std::uint32_t i = 0; i < count; i += 3) {
      const Element element = relation.asks == forms::ElementOf::vertex ? Element(Vertex(i))
                              : relation.asks == forms::ElementOf::edge ? Element(Edge(i))
                                                                        : Element(Face(i));
      const auto sequence = played("relation", mesh, {std::string(relation.id), slot_name(element)});
      ASSERT_EQ(sequence->size(), forms::all_forms().size());
      for (std::size_t form = 0; form < sequence->size(); ++form) {
        const forms::FormRow& row = forms::all_forms()[form];
        if (forms::why_unsuitable(mesh, row) || !row.stores_vertices) continue;
        bool is_told = false;
        const std::set<Element> expected = own_answer(mesh, row, relation, element, is_told);
        std::set<Element> found;
        const Step step = sequence->at(form + 1);
        EXPECT_EQ(step.rows.empty(), !is_told) << row.id << " " << relation.id;
        for (const steps::Mark& mark : step.marks)
          if (mark.role == steps::Role::answer) found.insert(mark.element);
        if (relation.relation == forms::Relation::valence) {
          EXPECT_EQ(std::to_string(found.size()), is_told ? step.rows[1].new_value : "0") << row.id;
        } else if (is_told) {
          EXPECT_EQ(found, expected) << row.id << " " << relation.id << " " << slot_name(element);
        }
      }
    }
  }
}

TEST(relation_steps, find_what_each_form_answers_itself) {
  for (const char* const name : {"tetrahedron.off", "fan.obj", "two_quads.obj", "cube.obj"})
    expect_relations(asset_mesh(name));
}

TEST(relation_steps, every_form_finds_the_same_also_at_copies) {
  for (const char* const name : {"fan.obj", "torus.off", "three_tri_edge.off", "bow_tie.obj", "fin.obj"}) {
    const Mesh mesh = asset_mesh(name);
    for (const forms::RelationRow& relation : forms::relations()) {
      const char* const element = relation.asks == forms::ElementOf::vertex ? "v0"
                                  : relation.asks == forms::ElementOf::edge ? "e0"
                                                                            : "f0";
      const auto sequence = played("relation", mesh, {std::string(relation.id), element});
      std::set<std::set<Element>> answers;
      for (std::size_t i = 1; i <= sequence->size(); ++i) {
        const Step step = sequence->at(i);
        std::set<Element> found;
        for (const steps::Mark& mark : step.marks)
          if (mark.role == steps::Role::answer) found.insert(mark.element);
        if (!step.rows.empty()) answers.insert(found);
      }
      EXPECT_EQ(answers.size(), 1u) << name << " " << relation.id;
    }
  }
}

TEST(relation_steps, table_2_reads_all_faces_and_table_3_those_around) {
  const Mesh mesh = asset_mesh("torus.off");
  const auto sequence = played("relation", mesh, {"vertex_faces", "v0"});
  std::map<std::string, std::size_t> records;
  for (std::size_t i = 1; i <= sequence->size(); ++i)
    for (const steps::RowChange& row : sequence->at(i).rows)
      if (row.table == "records_read") records[row.row] = std::stoul(*row.new_value);
  EXPECT_EQ(records.at("indexed_face_set"), mesh.live().faces);
  std::size_t around = 0;
  for ([[maybe_unused]] const Face f : faces_around(mesh, Vertex(0))) ++around;
  EXPECT_EQ(records.at("face_adjacency"), around + 1) << "the vertex, and its faces";
  EXPECT_EQ(records.at("opposite_map"), mesh.live().faces) << "no link from a vertex: a search, as on table 2";
  EXPECT_LT(records.at("halfedge"), mesh.live().faces / 2);
}

// They store places alone: no relation names a vertex, an edge or a neighbour of theirs, and the loop names places.
TEST(relation_steps, a_soup_and_a_polygon_set_name_nothing_that_they_do_not_store) {
  const Mesh mesh = asset_mesh("tetrahedron.off");
  std::size_t told = 0;
  for (const forms::RelationRow& relation : forms::relations()) {
    const char* const element = relation.asks == forms::ElementOf::vertex ? "v0"
                                : relation.asks == forms::ElementOf::edge ? "e0"
                                                                          : "f0";
    const auto sequence = played("relation", mesh, {std::string(relation.id), element});
    for (std::size_t form = 0; form < sequence->size(); ++form) {
      const Step step = sequence->at(form + 1);
      const std::string_view id = forms::all_forms()[form].id;
      if (id != "triangle_soup" && id != "polygon_set") continue;
      ++told;
      EXPECT_TRUE(step.rows.empty()) << id;
      EXPECT_EQ(step.marks.size(), 1u) << id << ": what is asked about";
      EXPECT_NE(step.caption.en.find("places alone"), std::string::npos) << step.caption.en;
      EXPECT_EQ(step.caption.en.find("v0"), std::string::npos) << step.caption.en;
    }
  }
  EXPECT_EQ(told, 2 * forms::relation_count);
}

// Points, edges by their ends, and faces by their corners, as the live slots say them: what a relation is by its name.
class ByTheFaces {
 public:
  explicit ByTheFaces(const Mesh& mesh) {
    const auto point = [&](Halfedge h) { return mesh.copy_point(mesh.from(h)).index; };
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i)
      if (mesh.is_alive(Edge(i))) edges_.insert(std::minmax(point(halfedge(Edge(i))), point(twin(halfedge(Edge(i))))));
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
      if (!mesh.is_alive(Face(i))) continue;
      for (const Halfedge h : loop(mesh, mesh.halfedge(Face(i)))) {
        corners_[i].push_back(point(h));
        sides_[i].insert(std::minmax(point(h), point(twin(h))));
      }
    }
  }

  using Ends = std::pair<std::uint32_t, std::uint32_t>;
  // As the steps write it, in any order.
  std::multiset<std::string> answer(std::string_view relation, std::uint32_t v, Ends e, std::uint32_t f) const {
    std::multiset<std::string> all;
    const auto name = [](Ends ends) { return std::to_string(ends.first) + "-" + std::to_string(ends.second); };
    for (const Ends& other : edges_) {
      const bool is_at_v = other.first == v || other.second == v;
      if (relation == "vertex_edges" && is_at_v) all.insert(name(other));
      if ((relation == "vertex_vertices" || relation == "valence") && is_at_v)
        all.insert("v" + std::to_string(other.first == v ? other.second : other.first));
      const bool meets_e = std::set{e.first, e.second, other.first, other.second}.size() < 4;
      if (relation == "edge_edges" && other != e && meets_e) all.insert(name(other));
    }
    if (relation == "edge_vertices") all = {"v" + std::to_string(e.first), "v" + std::to_string(e.second)};
    for (const auto& [g, corners] : corners_) {
      const std::string face = "f" + std::to_string(g);
      const bool has_v = std::find(corners.begin(), corners.end(), v) != corners.end();
      if (relation == "vertex_faces" && has_v) all.insert(face);
      if (relation == "edge_faces" && sides_.at(g).contains(e)) all.insert(face);
      if (relation == "face_vertices" && g == f)
        for (const std::uint32_t corner : corners) all.insert("v" + std::to_string(corner));
      if (relation == "face_edges" && g == f)
        for (const Ends& side : sides_.at(g)) all.insert(name(side));
      if (relation == "face_faces" && g != f && share_a_side(f, g)) all.insert(face);
    }
    return all;
  }

 private:
  bool share_a_side(std::uint32_t f, std::uint32_t g) const {
    return std::any_of(sides_.at(f).begin(), sides_.at(f).end(),
                       [&](const Ends& side) { return sides_.at(g).contains(side); });
  }
  std::set<Ends> edges_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> corners_;
  std::map<std::uint32_t, std::set<Ends>> sides_;
};

// The answer marks of a step, edges by the points of their ends.
std::multiset<std::string> answer_of(const Mesh& mesh, const Step& step) {
  std::multiset<std::string> found;
  for (const steps::Mark& mark : step.marks) {
    if (mark.role != steps::Role::answer) continue;
    if (mark.element.kind != Element::Kind::edge) {
      found.insert(slot_name(mark.element));
      continue;
    }
    const Halfedge h = halfedge(mark.element.edge());
    const auto [a, b] = std::minmax({mesh.copy_point(mesh.from(h)).index, mesh.copy_point(mesh.to(h)).index});
    found.insert(std::to_string(a) + "-" + std::to_string(b));
  }
  return found;
}

// Every relation of every live element on every form; how many were answered.
std::size_t expect_all_relations(const Mesh& mesh, const std::string& name) {
  const ByTheFaces truth(mesh);
  std::size_t answered = 0;
  for (const forms::RelationRow& relation : forms::relations()) {
    const std::uint32_t slots = relation.asks == forms::ElementOf::vertex ? mesh.vertex_slots()
                                : relation.asks == forms::ElementOf::edge ? mesh.edge_slots()
                                                                          : mesh.face_slots();
    for (std::uint32_t i = 0; i < slots; ++i) {
      const Element element = relation.asks == forms::ElementOf::vertex ? Element(Vertex(i))
                              : relation.asks == forms::ElementOf::edge ? Element(Edge(i))
                                                                        : Element(Face(i));
      if (!is_alive(mesh, element)) continue;
      std::uint32_t v = no_index;
      ByTheFaces::Ends ends{no_index, no_index};
      if (relation.asks == forms::ElementOf::vertex) v = mesh.copy_point(Vertex(i)).index;
      if (relation.asks == forms::ElementOf::edge)
        ends = std::minmax(mesh.copy_point(mesh.from(halfedge(Edge(i)))).index,
                           mesh.copy_point(mesh.to(halfedge(Edge(i)))).index);
      const std::multiset<std::string> expected = truth.answer(relation.id, v, ends, i);
      const auto sequence = played("relation", mesh, {std::string(relation.id), slot_name(element)});
      for (std::size_t form = 0; form < sequence->size(); ++form) {
        const Step step = sequence->at(form + 1);
        if (step.rows.empty()) continue;
        ++answered;
        EXPECT_EQ(answer_of(mesh, step), expected)
            << name << ": " << forms::all_forms()[form].id << " " << relation.id << " " << slot_name(element);
      }
    }
  }
  return answered;
}

// A deletion leaves edges whose first half has no face, and points whose copies are gone.
TEST(relation_steps, after_every_deletion_every_form_finds_what_the_faces_say) {
  std::vector<std::pair<std::string, Mesh>> meshes;
  for (const char* const name : {"tetrahedron.off", "two_quads.obj", "bow_tie.obj", "fin.obj", "misoriented.obj",
                                 "hanging_pair.obj", "fan.obj", "three_tri_edge.off"})
    meshes.emplace_back(name, asset_mesh(name));
  meshes.emplace_back("two.obj", asset_mesh("../tests/data/reports/two.obj"));
  meshes.emplace_back("two_fins.off", asset_mesh("../tests/data/reports/two_fins.off"));
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    Mesh mesh = make_mesh(random.faces, random.points);
    if (mesh.live().faces > 0 && mesh.live().faces < 8 && !mesh.has_rings())
      meshes.emplace_back("seed " + std::to_string(seed), std::move(mesh));
  }
  std::size_t asked = 0, deletions = 0, answered = 0;
  for (const auto& [name, mesh] : meshes) {
    std::vector<std::string> lines;
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i)
      for (const char* const op : {"delete f", "delete_loop f"}) lines.push_back(op + std::to_string(i));
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) lines.push_back("delete v" + std::to_string(i));
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) lines.push_back("delete e" + std::to_string(i));
    for (const std::string& line : lines) {
      if (!is_long_run() && asked++ % 6 != 0) continue;  // of each mesh others
      const ParsedOp op = parse_line(mesh, line);
      Mesh after = mesh;
      if (!op.op || !try_apply(after, nullptr, *op.op)) continue;
      ++deletions;
      answered += expect_all_relations(after, name + ", " + line);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(deletions, is_long_run() ? 360u : 60u);
  EXPECT_GT(answered, is_long_run() ? 30000u : 5000u);
}

}  // namespace
}  // namespace ryosen
