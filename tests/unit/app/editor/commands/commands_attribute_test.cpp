// The command `attribute`, and what the editor shows of attributes.
#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/commands.h"
#include "app/editor/document/element_values.h"
#include "app/editor/document/findings.h"
#include "app/editor/session/selecting.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> session_of(const char* name = "cube.obj") {
  return std::make_unique<Session>(Document::open(test::asset(name)).value());
}

void do_all(Session& session, std::initializer_list<const char*> lines) {
  for (const char* line : lines) {
    const Outcome outcome = session.run(line);
    EXPECT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
  }
}

double number_of(const Session& session, std::string_view name, std::uint32_t slot) {
  const AttributeColumn* const column = find_column(session.mesh(), name);
  return column ? number_at(*column, slot) : std::nan("");
}

TEST(commands_attribute, add_set_and_remove_are_undone_and_done_again) {
  const auto session = session_of();
  do_all(*session, {"attribute add vertex.load float", "attribute set vertex.load 2.5 v0 v3", "split 0-1 0.5"});
  EXPECT_EQ(number_of(*session, "vertex.load", 8), 1.25) << "between 2.5 and 0";
  do_all(*session, {"attribute remove vertex.load"});
  EXPECT_FALSE(find_column(session->mesh(), "vertex.load"));
  do_all(*session, {"undo"});
  EXPECT_EQ(number_of(*session, "vertex.load", 3), 2.5);
  do_all(*session, {"undo", "undo"});
  EXPECT_EQ(number_of(*session, "vertex.load", 3), 0);
  do_all(*session, {"undo"});
  EXPECT_FALSE(find_column(session->mesh(), "vertex.load"));
  do_all(*session, {"redo 4"});
  EXPECT_FALSE(find_column(session->mesh(), "vertex.load"));
}

TEST(commands_attribute, the_history_has_lines_that_do_the_same_again) {
  const auto session = session_of();
  do_all(*session, {"attribute add edge.crease float sum 0", "select e0 e1 e2 e7", "attribute set edge.crease 3",
                    "attribute add face.tag ucharx2 greatest 1 2", "attribute set face.tag 7 9 f0..f3",
                    "attribute add corner.fixed bool", "attribute set corner.fixed true f1"});
  const auto again = session_of();
  for (const HistoryEntry& entry : session->document().history()) do_all(*again, {entry.command.c_str()});
  EXPECT_EQ(again->document().history()[1].command, "attribute set edge.crease 3 e0..e2 e7");
  EXPECT_TRUE(again->mesh().columns() == session->mesh().columns());
}

TEST(commands_attribute, says_why_it_does_nothing) {
  const auto session = session_of();
  do_all(*session, {"attribute add face.tag int"});
  struct Case {
    const char *line, *told;
    ExitCode code;
  };
  for (const Case& c :
       {Case{"attribute", "attribute", ExitCode::usage}, Case{"attribute ad face.x int", "add NAME", ExitCode::usage},
        Case{"attribute add face.x inte", "\"inte\" is not a type", ExitCode::usage},
        Case{"attribute add tag int", "\"tag\" is not an attribute name", ExitCode::usage},
        Case{"attribute add pool.x int", "\"pool.x\" is not an attribute name", ExitCode::usage},
        Case{"attribute add face.x int mean", "\"mean\" is not a rule", ExitCode::usage},
        Case{"attribute add face.x int first 1.5", "\"1.5\" is not a number of the type int", ExitCode::usage},
        Case{"attribute add face.x intx2 first 1", "\"1\" is the last of 1 number; the type intx2 needs 2",
             ExitCode::usage},
        Case{"attribute add face.material int", "face.material is kept by the program", ExitCode::refused},
        Case{"attribute add face.tag int", "there is an attribute face.tag already", ExitCode::refused},
        Case{"attribute remove face.tags", "there is no attribute face.tags", ExitCode::refused},
        Case{"attribute set face.tags 1 f0", "there is no attribute face.tags", ExitCode::refused},
        Case{"attribute set face.tag 1.5 f0", "\"1.5\" is not a number of the type int", ExitCode::usage},
        Case{"attribute set face.tag 1 v0", "it belongs to faces", ExitCode::refused},
        Case{"attribute set face.tag 1", "it belongs to faces", ExitCode::refused},
        Case{"attribute set face.tag 1 f0 x9", "x9", ExitCode::usage},
        Case{"attribute set face.tag 1 f99", "f99", ExitCode::usage},
        Case{"colours face.tags", "there is no attribute face.tags", ExitCode::refused}}) {
    const Outcome outcome = session->run(c.line);
    EXPECT_FALSE(outcome.done()) << c.line;
    EXPECT_EQ(outcome.exit_code, c.code) << c.line << outcome.sentence.en;
    EXPECT_NE(outcome.sentence.en.find(c.told), std::string::npos) << c.line << ": " << outcome.sentence.en;
    EXPECT_FALSE(outcome.sentence.ja.empty());
  }
  EXPECT_EQ(session->document().history().size(), 1u);
  EXPECT_EQ(session->run("attribute list").sentence.en, "face.tag int first 0");
  do_all(*session, {"attribute set face.tag 0 f0"});
  EXPECT_EQ(session->document().history().size(), 1u) << "it is 0 already";
}

TEST(commands_attribute, all_copies_of_a_point_and_all_sheets_of_an_edge_have_one_value) {
  for (const char* name : {"bow_tie.obj", "three_tri_edge.off"}) {
    const auto session = session_of(name);
    do_all(*session, {"attribute add vertex.a int", "attribute add edge.b int"});
    for (const Vertex v : live_vertices(session->mesh()))
      do_all(*session,
             {("attribute set vertex.a " + std::to_string(v.index + 1) + " v" + std::to_string(v.index)).c_str()});
    for (const Edge e : live_edges(session->mesh()))
      do_all(*session,
             {("attribute set edge.b " + std::to_string(e.index + 1) + " e" + std::to_string(e.index)).c_str()});
    const Mesh& mesh = session->mesh();
    for (const Vertex v : live_vertices(mesh))
      EXPECT_EQ(number_of(*session, "vertex.a", v.index), number_of(*session, "vertex.a", point(mesh, v).index));
    for (const Edge e : live_edges(mesh))
      for (const Halfedge sheet : sheets_between(mesh, mesh.from(halfedge(e)), mesh.to(halfedge(e))))
        EXPECT_EQ(number_of(*session, "edge.b", e.index), number_of(*session, "edge.b", edge(sheet).index));
  }
}

TEST(commands_attribute, values_are_told_and_a_corner_has_a_name) {
  const auto session = session_of();
  do_all(*session, {"attribute add corner.u float", "attribute set corner.u 3 v1@f0"});
  const AttributeColumn& u = *find_column(session->mesh(), "corner.u");
  std::vector<float> values = attribute_values<float>(u);
  EXPECT_EQ(std::count(values.begin(), values.end(), 3.0f), 1);
  EXPECT_TRUE(session->run("attribute get corner.u v1@f0").sentence.en.ends_with(" 3"));
  do_all(*session, {"attribute add vertex.load int", "attribute set vertex.load 7 v2"});
  EXPECT_EQ(session->run("attribute get vertex.load v1 v2").sentence.en, "v1 0, v2 7");
  do_all(*session, {"select v2 v3"});
  EXPECT_EQ(session->run("attribute get vertex.load").sentence.en, "v2 7, v3 0");
  EXPECT_EQ(session->run("attribute get vertex.load f0").exit_code, ExitCode::refused);
  EXPECT_EQ(session->run("attribute get vertex.none v0").exit_code, ExitCode::refused);
  EXPECT_EQ(session->run("attribute set vertex.load 1 v0 f1 f2").sentence.en,
            "2 elements have no value of vertex.load.");
  EXPECT_EQ(session->document().history().size(), 5u);
}

TEST(commands_attribute, what_is_appended_brings_values_of_the_same_name) {
  const test::TemporaryFolder folder;
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float load\nproperty int other\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 1 4\n1 0 0 2 5\n0 1 0 3 6\n3 0 1 2\n";
  const std::string path = folder.write("a.ply", text);
  const auto session = session_of();
  do_all(*session, {"attribute add vertex.load float"});
  EXPECT_EQ(session->run("append " + path).sentence.en,
            "Left out of that file: attributes that this mesh does not have.");
  EXPECT_EQ(number_of(*session, "vertex.load", 9), 2);
  EXPECT_EQ(number_of(*session, "vertex.load", 0), 0);
}

TEST(commands_attribute, colours_follow_the_values) {
  const auto session = session_of();
  do_all(*session, {"attribute add face.heat double", "attribute set face.heat 8 f2"});
  EXPECT_EQ(session->run("colours face.heat").sentence.en, "face.heat: 0 to 8, mean 1.33333333, median 0, of 6");
  const auto highest = [&] {
    return figures_of(session->findings().map_values(*session->view.colouring).all()).highest;
  };
  do_all(*session, {"attribute set face.heat 9 f3"});
  EXPECT_EQ(highest(), 9);
  do_all(*session, {"undo"});
  EXPECT_EQ(highest(), 8);
  do_all(*session, {"poke f2"});
  EXPECT_EQ(figures_of(session->findings().map_values(*session->view.colouring).all()).count, 9u);
  do_all(*session, {"select by face.heat 8 8"});
  EXPECT_EQ(session->selecting.selection.size(), 4u);
  do_all(*session, {"attribute remove face.heat"});
  EXPECT_EQ(figures_of(session->findings().map_values(*session->view.colouring).all()).count, 0u);
  do_all(*session, {"undo"});
  EXPECT_EQ(highest(), 8);
}

TEST(commands_attribute, the_feed_tells_written_values) {
  const auto session = session_of();
  do_all(*session, {"attribute add vertex.a int", "attribute add edge.b int"});
  session->findings().highlights();
  ChangeFeed::Cursor last = session->findings().changes().since({}).now;
  const auto news = [&] {
    ChangeFeed::Changes changes = session->findings().changes().since(last);
    last = changes.now;
    return changes;
  };
  const auto a = static_cast<std::uint32_t>(session->mesh().find_attribute("vertex.a")), b = a + 1;
  using Values = std::vector<TouchedElements::Value>;
  do_all(*session, {"attribute set edge.b 4 e3"});
  const ChangeFeed::Changes set = news();
  EXPECT_FALSE(set.everything);
  EXPECT_EQ(set.values, (Values{{b, 3}}));
  EXPECT_TRUE(set.vertices.empty() && set.faces.empty());
  do_all(*session, {"undo"});
  EXPECT_EQ(news().values, (Values{{b, 3}}));
  do_all(*session, {"split 0-1"});
  const Values split = news().values;
  EXPECT_NE(std::find(split.begin(), split.end(), TouchedElements::Value{a, 8}), split.end()) << "the new vertex";
  EXPECT_NE(std::find(split.begin(), split.end(), TouchedElements::Value{b, 12}), split.end()) << "a new edge";
  do_all(*session, {"attribute remove edge.b"});
  EXPECT_TRUE(news().everything);
}

TEST(element_values, are_told_by_name) {
  const auto session = session_of();
  do_all(*session,
         {"attribute add vertex.load float", "attribute set vertex.load 2.5 v0", "attribute add vertex.flag bool",
          "attribute add corner.weight shortx2 first 3 4", "attribute add edge.crease double"});
  const Mesh& mesh = session->mesh();
  const auto told = [&](const Element& element) {
    std::string all;
    for (const ElementValue& each : values_of(mesh, session->document().tables(), element))
      all += each.name + "=" + each.value + ";";
    return all;
  };
  EXPECT_EQ(told(Vertex(0)), "load=2.5;flag=false;");
  EXPECT_EQ(told(Edge(0)), "crease=0;");
  EXPECT_EQ(told(Halfedge(0)), "weight=3 4;");
  EXPECT_EQ(told(Face(0)), "");
}

TEST(element_values, have_the_names_of_materials_and_the_values_of_pools) {
  const test::TemporaryFolder folder;
  const auto document = Document::open(folder.write(
      "a.obj", "v 0 0 0 1 0 0.5\nv 1 0 0 1 0 0.5\nv 0 1 0 1 0 0.5\nvt 0.25 1\nusemtl oak\ng door\nf 1/1 2/1 3\n"));
  ASSERT_TRUE(document);
  const Mesh& mesh = (*document)->mesh();
  const auto told = [&](const Element& element) {
    std::string all;
    for (const ElementValue& each : values_of(mesh, (*document)->tables(), element))
      all += each.name + "=" + each.value + ";";
    return all;
  };
  EXPECT_EQ(told(Face(0)), "material=oak;group=door;");
  EXPECT_EQ(told(Vertex(0)), "colour=1 0 0.5 1;");
  EXPECT_EQ(told(mesh.halfedge(Face(0))), "texcoord=0.25 1 0;");
  EXPECT_EQ(told(mesh.prev(mesh.halfedge(Face(0)))), "") << "the third corner has none";
  EXPECT_EQ(told(twin(mesh.halfedge(Face(0)))), "") << "outside";
}

}  // namespace
}  // namespace ryosen
