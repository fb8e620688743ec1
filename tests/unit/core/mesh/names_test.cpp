#include "ryosen/mesh/names.h"

#include <gtest/gtest.h>

#include <set>

#include "ryosen/mesh/copies.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// What a sentence lists behind its colon or its "one of".
std::vector<std::string> choices(const std::string& sentence, const std::string& behind) {
  const std::size_t at = sentence.find(behind);
  if (at == std::string::npos) return {};
  std::vector<std::string> names;
  for (std::string_view word : split_words(std::string_view(sentence).substr(at + behind.size())))
    names.emplace_back(word.substr(0, word.find(',')));
  return names;
}

TEST(names, the_choices_of_an_ambiguous_edge_are_plain_and_are_its_sheets) {
  for (const Polygons& faces : {fin(), two_tetrahedra_on_an_edge(), Polygons{{0, 1, 2}, {0, 1, 3}}}) {
    const Mesh mesh = make_mesh(faces);
    for (const char* name : {"0-1", "1-0"}) {
      const Named<Halfedge> edge_half = find_edge(mesh, name);
      ASSERT_EQ(edge_half.error, NameError::ambiguous);
      const std::vector<std::string> names = choices(edge_half.sentence.en, "choose one of ");
      EXPECT_EQ(names, choices(edge_half.sentence.ja, "次から選んでください："));
      std::set<Halfedge> chosen;
      for (const std::string& choice : names) {
        EXPECT_TRUE(choice.starts_with(name)) << choice << " for " << name;
        const Named<Halfedge> sheet = find_edge(mesh, choice);
        ASSERT_TRUE(sheet.ok()) << choice;
        chosen.insert(sheet.element);
      }
      const std::vector<Halfedge> sheets =
          sheets_between(mesh, Vertex(name[0] == '0' ? 0 : 1), Vertex(name[0] == '0' ? 1 : 0));
      EXPECT_EQ(chosen, std::set<Halfedge>(sheets.begin(), sheets.end()));
    }
  }
}

TEST(names, a_name_to_choose_is_read_as_the_halfedge) {
  for (const Polygons& faces : {fin(), two_tetrahedra_on_an_edge(), bow_tie(), tetrahedron()}) {
    const Mesh mesh = make_mesh(faces);
    for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
      if (!mesh.is_alive(Halfedge(i))) continue;
      const std::string name = name_to_choose(mesh, Halfedge(i));
      EXPECT_EQ(find_edge(mesh, name).element, Halfedge(i)) << name;
      EXPECT_EQ(name.find('~'), std::string::npos) << name;
    }
  }
}

TEST(names, of_an_edge_give_its_named_side) {
  for (const Polygons& faces : {fin(), two_tetrahedra_on_an_edge(), bow_tie(), tetrahedron()}) {
    const Mesh mesh = make_mesh(faces);
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
      if (!mesh.is_alive(Edge(i))) continue;
      const std::string name = name_of(mesh, Edge(i));
      EXPECT_EQ(find_edge(mesh, name).element, named_side(mesh, Edge(i))) << name;
    }
  }
}

TEST(names, what_a_name_looks_like_is_said_in_each_language) {
  const Mesh mesh;
  for (const Text& sentence : {find_vertex(mesh, "x").sentence, find_edge(mesh, "x").sentence}) {
    EXPECT_NE(sentence.en.find(" or "), std::string::npos) << sentence.en;
    EXPECT_EQ(sentence.ja.find(" or "), std::string::npos) << sentence.ja;
  }
}

}  // namespace
}  // namespace ryosen
