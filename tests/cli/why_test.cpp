// `why`: which lines it prints, in which order, and that its remedies hold.
#include <gtest/gtest.h>

#include "ryosen/io/formats.h"
#include "ryosen/ops/all.h"
#include "tests/support/app/program.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen::test {
namespace {

std::vector<std::string> edges_of(const ProgramRun& run) {
  std::vector<std::string> edges;
  for (const Json& line : run.lines()) edges.push_back(line["edge"]);
  return edges;
}

TEST(why, collapse_goes_both_ways_in_order) {
  const ProgramRun run = run_program({"why", asset("misoriented.obj"), "--op", "collapse", "--all", "--json"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(edges_of(run), (std::vector<std::string>{"0-1@f0", "1-0@f0", "0-1@f1", "1-0@f1", "0-2", "2-0", "0-3", "3-0",
                                                     "1-2", "2-1", "1-3", "3-1"}));
}

TEST(why, orders_by_number_not_by_text) {
  const std::vector<std::string> edges =
      edges_of(run_program({"why", asset("torus.off"), "--op", "split", "--all", "--json"}));
  ASSERT_EQ(edges.size(), 144u);
  const auto number = [](const std::string& edge) {
    return std::pair(std::stoi(edge), std::stoi(edge.substr(edge.find('-') + 1)));
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_LT(number(edges[i]).first, number(edges[i]).second);
    if (i == 0) continue;
    EXPECT_LT(number(edges[i - 1]), number(edges[i]));
  }
}

// Two tetrahedra on a common edge are closed again in the kernel; on points the edge has four faces.
TEST(why, names_the_sides_of_an_edge_that_was_closed_again) {
  const TemporaryFolder folder;
  folder.write("two.off",
               "OFF\n6 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n0 0 -1\n"
               "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 0 1 4\n3 0 5 1\n3 1 5 4\n3 0 4 5\n");
  const ProgramRun run = run_program({"why", folder.at("two.off"), "--op", "swap", "--all", "--json"});
  const std::vector<Json> lines = run.lines();
  ASSERT_EQ(lines.size(), 10u + 4u);
  const char* sides[] = {"0-1@f0", "0-1@f1", "0-1@f4", "0-1@f5"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(lines[i]["edge"], sides[i]);
    EXPECT_EQ(lines[i]["legal"], false);
    EXPECT_EQ(lines[i]["reasons"][0]["rule"], "copies");
  }
  EXPECT_EQ(lines[4]["edge"], "0-2");
}

TEST(why, line_has_the_keys_of_the_contract) {
  const ProgramRun run = run_program({"why", asset("tetrahedron.off"), "--op", "collapse", "--edge", "1-0", "--json"});
  EXPECT_EQ(run.exit_code, 0);
  const Json line = run.line();
  std::vector<std::string> keys;
  for (const auto& item : line.items()) keys.push_back(item.key());
  EXPECT_EQ(keys, (std::vector<std::string>{"op", "edge", "legal", "reasons", "warnings", "remedy"}));
  EXPECT_EQ(line["op"], "collapse");
  EXPECT_EQ(line["edge"], "1-0");
  ASSERT_EQ(line["reasons"].size(), 1u);
  const Json& reason = line["reasons"][0];
  EXPECT_EQ(reason["rule"], "duplicate_face");
  EXPECT_EQ(reason["severity"], "refuse");
  EXPECT_EQ(reason["witnesses"], Json::array({"f2", "f3"}));
  EXPECT_FALSE(std::string(reason["en"]).empty());
  EXPECT_FALSE(std::string(reason["ja"]).empty());
}

TEST(why, legal_has_no_remedy_to_offer) {
  const Json line = run_program({"why", asset("fan.obj"), "--do", "collapse 0-1 mid", "--json"}).line();
  EXPECT_EQ(line["legal"], true);
  EXPECT_EQ(line["reasons"], Json::array());
  EXPECT_EQ(line["remedy"], Json::array());
}

constexpr const char* lone_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(why, says_never_where_nothing_helps) {
  const TemporaryFolder folder;
  folder.write("t.obj", lone_triangle);
  const Json line = run_program({"why", folder.at("t.obj"), "--op", "swap", "--edge", "1-2", "--json"}).line();
  EXPECT_EQ(line["reasons"][0]["rule"], "boundary");
  EXPECT_EQ(line["remedy"], "never");
}

TEST(why, remedies_make_the_operator_legal) {
  std::size_t tried = 0;
  for (const char* name : {"tetrahedron.off", "sliver.obj", "misoriented.obj", "hanging_pair.obj", "moebius.off",
                           "fan.obj", "two_quads.obj", "fin.obj"}) {
    for (const char* op : {"collapse", "swap"}) {
      for (const Json& line : run_program({"why", asset(name), "--op", op, "--all", "--json"}).lines()) {
        if (!line["remedy"].is_array() || line["remedy"].empty() || ++tried % 4 != 0) continue;
        std::string script;
        for (const Json& step : line["remedy"]) script += std::string(step) + ";";
        script += std::string(op) + " " + std::string(line["edge"]);
        EXPECT_EQ(run_program({"edit", asset(name), "--do", script}).exit_code, 0) << name << ": " << script;
      }
    }
  }
  EXPECT_GT(tried, 20u);
}

TEST(why, geometry_adds_warnings_under_all) {
  const auto warned = [](const std::vector<std::string>& arguments) {
    std::size_t count = 0;
    for (const Json& line : run_program(arguments).lines()) count += !line["warnings"].empty();
    return count;
  };
  EXPECT_EQ(warned({"why", asset("sliver.obj"), "--op", "collapse", "--all", "--json"}), 0u);
  EXPECT_GT(warned({"why", asset("sliver.obj"), "--op", "collapse", "--all", "--geometry", "--json"}), 0u);
}

// Every line of --all says what --edge says about that edge.
TEST(why, answers_about_all_edges_as_about_one) {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& name, const IndexedMesh& mesh) {
    MeshFile file;
    file.mesh = mesh;
    EXPECT_TRUE(write_mesh_file(folder.at(name), file, *find_target("off")));
    return folder.at(name);
  };
  const std::vector<std::string> files{write("fan.off", fan(7)), write("book.off", book(6)),
                                       write("equal.off", equal_triangles(4)), write("face.off", large_face(5)),
                                       asset("misoriented.obj")};
  std::size_t asked = 0;
  for (const std::string& file : files)
    for (const OpInfo& op : all_ops()) {
      if (op.target != OpTargetKind::edge) continue;
      const std::string id(op.id);
      for (const Json& line : run_here({"why", file, "--op", id, "--all", "--geometry", "--json"}).lines()) {
        const std::string edge = line["edge"];
        EXPECT_EQ(line, run_here({"why", file, "--op", id, "--edge", edge, "--json"}).line()) << id << " " << edge;
        ++asked;
      }
    }
  EXPECT_GT(asked, 500u);
}

// Of n triangles on the same points one can be deleted in a step, and only so many steps are looked for.
TEST(why, gives_up_where_too_many_triangles_have_one_apex) {
  const TemporaryFolder folder;
  const auto remedy = [&](int copies) {
    std::string off = "OFF\n3 " + std::to_string(copies) + " 0\n0 0 0\n1 0 0\n0 1 0\n";
    for (int i = 0; i < copies; ++i) off += "3 0 1 2\n";
    folder.write("equal.off", off);
    const std::string edge = "0-1@f" + std::to_string(copies - 1);
    return run_program({"why", folder.at("equal.off"), "--op", "split", "--edge", edge, "--json"}).line()["remedy"];
  };
  EXPECT_TRUE(remedy(2).is_array());
  EXPECT_TRUE(remedy(5).is_array());
  EXPECT_EQ(remedy(6), "never");
}

TEST(why, names_what_was_asked) {
  const auto first_line = [](const std::string& line) {
    const std::string out = run_program({"why", asset("cube.obj"), "--do", line}).out;
    return out.substr(0, out.find('\n'));
  };
  EXPECT_EQ(first_line("make_edge  v0 v6"), "make_edge v0 v6: refused");
  EXPECT_EQ(first_line("dissolve v7"), "dissolve v7: legal");
  EXPECT_EQ(first_line("orient"), "orient: refused");
  EXPECT_EQ(first_line("collapse 0-1 mid"), "collapse 0-1: legal");
}

TEST(why, orient_has_no_edge) {
  const ProgramRun run = run_program({"why", asset("cube.obj"), "--do", "orient", "--json"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(run.line()["edge"].is_null());
  EXPECT_EQ(run.line()["reasons"][0]["rule"], "oriented");
}

TEST(why, name_that_fits_several_is_usage) {
  const ProgramRun run = run_program({"why", asset("fin.obj"), "--op", "swap", "--edge", "0-1"});
  EXPECT_EQ(run.exit_code, 2);
  for (const char* side : {"@f0", "@f1", "@f2"}) EXPECT_NE(run.err.find(side), std::string::npos) << run.err;
  for (const char* name : {"0-1@f1", "1-0@f1", "~0-1@f1"})
    EXPECT_EQ(run_program({"why", asset("fin.obj"), "--op", "swap", "--edge", name}).exit_code, 0) << name;
}

TEST(why, quarantined_face_is_deleted) {
  const TemporaryFolder folder;
  folder.write("q.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n");
  const ProgramRun run = run_program({"why", folder.at("q.obj"), "--op", "split", "--edge", "0-1@f1", "--json"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.line()["legal"], false);
  EXPECT_EQ(run.line()["reasons"][0]["rule"], "deleted");
  EXPECT_EQ(run.line()["remedy"], "never");
  EXPECT_NE(std::string(run.line()["reasons"][0]["en"]).find("set aside: it visits vertex v1"), std::string::npos);
  EXPECT_NE(std::string(run.line()["reasons"][0]["ja"]).find("5 行目"), std::string::npos);
  for (const char* line : {"delete f1", "detach f0 f1", "poke f1"}) {
    const ProgramRun asked = run_program({"why", folder.at("q.obj"), "--do", line, "--json"});
    EXPECT_EQ(asked.exit_code, 0) << line;
    const std::string reason = asked.line()["reasons"][0]["en"];
    EXPECT_NE(reason.find("f1 is set aside"), std::string::npos) << line << ": " << reason;
  }
  const ProgramRun text = run_program({"why", folder.at("q.obj"), "--op", "split", "--edge", "0-1@f1"});
  EXPECT_NE(text.out.find("(line 5)"), std::string::npos) << text.out;
  EXPECT_EQ(text.out.find("has been deleted"), std::string::npos) << text.out;
}

TEST(why, says_what_the_table_of_rules_knows_where_no_remedy_was_found) {
  const auto text = [](const std::vector<std::string>& further) {
    std::vector<std::string> arguments{"why"};
    arguments.insert(arguments.end(), further.begin(), further.end());
    return run_program(arguments).out;
  };
  const TemporaryFolder folder;
  folder.write("t.obj", lone_triangle);
  const std::string edge = text({folder.at("t.obj"), "--op", "swap", "--edge", "1-2"});
  EXPECT_NE(edge.find("none was found nearby; worth a try: put a face on its other side"), std::string::npos) << edge;
  const std::string japanese = text({folder.at("t.obj"), "--op", "swap", "--edge", "1-2", "--lang", "ja"});
  EXPECT_NE(japanese.find("反対側に面を張ります"), std::string::npos) << japanese;
}

TEST(why, names_what_fills_on_a_boundary) {
  const auto remedy = [](const std::vector<std::string>& question) {
    std::vector<std::string> arguments{"why"};
    arguments.insert(arguments.end(), question.begin(), question.end());
    const std::string out = run_program(arguments).out;
    const std::size_t at = out.find("remedy: ");
    return at == std::string::npos ? out : out.substr(at + 8);
  };
  // The side of two quads with one common side, whose ends lie on the boundary.
  EXPECT_EQ(remedy({asset("two_quads.obj"), "--do", "collapse 1-4"}).rfind("make_face", 0), 0u)
      << remedy({asset("two_quads.obj"), "--do", "collapse 1-4"});
}

TEST(why, usage_errors) {
  const std::string mesh = asset("cube.obj");
  const std::vector<std::vector<std::string>> wrong = {
      {"why", mesh},
      {"why", mesh, "--op", "collapse"},
      {"why", mesh, "--op", "collapse", "--all", "--edge", "0-1"},
      {"why", mesh, "--op", "colapse", "--all"},
      {"why", mesh, "--op", "orient", "--all"},
      {"why", mesh, "--do", "collapse 0-1", "--all"},
      {"why", mesh, "--do", ""},
      {"why", mesh, "--op", "collapse", "--edge", ""},
      {"why", mesh, "--do", "collapse 0-1; collapse 1-2"},
      {"why", mesh, "--do", "collapse 0-1 middle"},
      {"why", mesh, "--do", "collapse"},
      {"why", mesh, "--do", "undo"},
      {"why", mesh, "--op", "collapse", "--edge", "0~1"},
      {"why", mesh, "--op", "collapse", "--edge", "0-6"},
      {"why", "--op", "collapse", "--all"},
  };
  for (std::vector<std::string> arguments : wrong) {
    arguments.push_back("--json");
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 2) << testing::PrintToString(arguments);
    EXPECT_EQ(run.line()["status"], "error") << testing::PrintToString(arguments);
  }
}

TEST(why, inputs_that_cannot_be_read) {
  EXPECT_EQ(run_program({"why", "nosuch.obj", "--op", "swap", "--all"}).exit_code, 3);
  EXPECT_EQ(run_program({"why", asset("obj_16_text_coord.obj"), "--op", "swap", "--all"}).exit_code, 4);
}

}  // namespace
}  // namespace ryosen::test
