// Neighbours found step by step on every form are those that the form answers itself.
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>
#include <string>

#include "core/forms/all.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/mesh/names.h"
#include "core/steps/all.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/played_steps.h"
#include "tests/support/core/random_meshes.h"

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
        if (forms::why_unsuitable(mesh, row) || !row.keeps_numbers) continue;
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

TEST(relation_steps, every_form_finds_the_same_also_by_places_and_at_copies) {
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
  EXPECT_EQ(records.at("triangle_soup"), mesh.live().faces);
  EXPECT_LT(records.at("halfedge"), mesh.live().faces / 2);
}

}  // namespace
}  // namespace ryosen
