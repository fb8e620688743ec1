// `forms`: what the comparison prints, and that its figures are those of the mesh.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/pairing.h"
#include "tests/support/app/program.h"
#include "tests/support/core/long_run.h"

namespace ryosen::test {
namespace {

std::map<std::string, Json> rows_of(const Json& line, const std::string& list, const std::string& id) {
  std::map<std::string, Json> rows;
  for (const Json& row : line[list]) rows[row[id]] = row;
  return rows;
}

TEST(forms_command, compares_every_form_and_method) {
  const ProgramRun run = run_program({"forms", asset("torus.off"), "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Json line = run.line();
  std::vector<std::string> keys;
  for (const auto& item : line.items()) keys.push_back(item.key());
  EXPECT_EQ(keys, (std::vector<std::string>{"file", "vertices", "edges", "faces", "forms", "pairing", "texts"}));
  const std::size_t v = line["vertices"], f = line["faces"];
  EXPECT_EQ(v * 2, f);

  const auto rows = rows_of(line, "forms", "form");
  ASSERT_EQ(rows.size(), forms::all_forms().size());
  for (const forms::FormRow& form : forms::all_forms()) {
    const Json& row = rows.at(std::string(form.id));
    EXPECT_EQ(row["suitable"], true);
    EXPECT_TRUE(row["reason"].is_null());
    EXPECT_FALSE(std::string(row["en"]).empty() || std::string(row["ja"]).empty());
    EXPECT_EQ(row["query_ns"].size(), forms::relation_count);
    EXPECT_GT(row["build_ms"], 0.0);
  }
  EXPECT_EQ(rows.at("triangle_soup")["bytes_per_face"], 72.0);
  EXPECT_EQ(rows.at("halfedge")["bytes"], v * 28 + 3 * f * 20 + f * 4);
  EXPECT_TRUE(rows.at("triangle_soup")["query_ns"]["valence"].is_null());
  EXPECT_GT(rows.at("opposite_map")["query_ns"]["vertex_faces"], 0.0) << "by a search";
  EXPECT_GT(rows.at("opposite_map")["query_ns"]["face_faces"], 0.0);
  EXPECT_GT(rows.at("winged_edge")["query_ns"]["valence"], 0.0);

  const auto methods = rows_of(line, "pairing", "method");
  EXPECT_EQ(methods.size(), pairing_methods().size());
  for (const auto& [id, method] : methods) {
    EXPECT_EQ(method["whole"], true) << id;
    EXPECT_EQ(method["faces"], f) << id;
    EXPECT_GT(method["ms"], 0.0) << id;
  }
}

// What takes too long is measured on a part, and says so.
TEST(forms_command, brute_force_on_a_large_mesh_is_measured_on_a_part) {
  const TemporaryFolder folder;
  std::string mesh = asset("stanford_bunny.obj");
  if (!is_long_run()) {
    mesh = folder.at("torus.off");
    ASSERT_EQ(run_program({"torus", "--segments", "100", "--tube-segments", "60", "-o", mesh}).exit_code, 0);
  }
  const ProgramRun run = run_program({"forms", mesh, "--json"});
  const Json line = run.line();
  for (const auto& [id, method] : rows_of(line, "pairing", "method")) {
    EXPECT_EQ(method["whole"], id != "brute_force");
    EXPECT_EQ(method["faces"] == line["faces"], id != "brute_force");
    EXPECT_GT(method["ms"], 0.0);
  }
  const std::string text = run_program({"forms", mesh}).out;
  EXPECT_NE(text.find("* on the first "), std::string::npos) << text;
}

TEST(forms_command, says_why_a_form_cannot_hold_the_mesh) {
  const ProgramRun run = run_program({"forms", asset("cube.obj"), "--json"});
  EXPECT_EQ(run.exit_code, 0);
  const Json row = rows_of(run.line(), "forms", "form").at("opposite_map");
  EXPECT_EQ(row["suitable"], false);
  EXPECT_EQ(row["reason"]["en"], "It holds triangles alone; f0 has 4 corners.");
  EXPECT_TRUE(row["bytes"].is_null());
  EXPECT_TRUE(row["bytes_per_face"].is_null());
  EXPECT_TRUE(row["query_ns"]["face_faces"].is_null());
  const std::string japanese = run_program({"forms", asset("cube.obj"), "--lang", "ja"}).out;
  EXPECT_NE(japanese.find("三角形しか持てません。f0 は 4 角形です。"), std::string::npos) << japanese;
}

TEST(forms_command, says_what_the_texts_do_on_a_boundary) {
  const ProgramRun run = run_program({"forms", asset("fan.obj"), "--json"});
  const Json texts = run.line()["texts"];
  ASSERT_EQ(texts.size(), 4u);
  for (const Json& report : texts) {
    EXPECT_EQ(report["completed"], false);
    const bool on_edge = report["place"] == "boundary_edge";
    EXPECT_NE(std::string(report["en"]).find(on_edge ? "nothing has been changed" : "changed in part"),
              std::string::npos);
  }
  EXPECT_NE(run_program({"forms", asset("fan.obj")}).out.find("collapse on a boundary edge: It follows"),
            std::string::npos);
}

TEST(forms_command, compares_the_memory_that_text_002_compares) {
  const std::string text = run_program({"forms", asset("torus.off")}).out;
  EXPECT_NE(text.find("Text 002, section 2.3: halfedges take less memory than a polygon set. So it is here (bytes per "
                      "face: halfedge, loops and parent edges 92, polygon set 96)."),
            text.npos)
      << text;
  EXPECT_NE(text.find("halfedges take more memory than an indexed face set. So it is here"), text.npos) << text;
  const std::string quads = run_program({"forms", asset("cube.obj"), "--lang", "ja"}).out;
  EXPECT_NE(quads.find("テキスト 002 の 2.3 節「半稜線はポリゴンセットよりメモリ効率が良い」：ここでは違います"),
            quads.npos)
      << quads;
  EXPECT_NE(quads.find("頂点に 32"), quads.npos) << "why: " << quads;
}

TEST(forms_command, refuses_a_plot_under_the_name_of_another_format) {
  TemporaryFolder folder;
  for (const char* const name : {"plot.svg", "plot.jpg", "plot.PDF"}) {
    const std::string file = folder.at(name);
    const ProgramRun run = run_program({"forms", asset("tetrahedron.off"), "--growth", "--plot", file, "--json"});
    EXPECT_EQ(run.exit_code, 2) << name;
    EXPECT_EQ(run.lines().back()["messages"][0]["code"], "unknown_format") << run.out;
    EXPECT_FALSE(std::filesystem::exists(file)) << name;
  }
}

TEST(forms_command, help_lists_forms_and_methods) {
  for (const char* language : {"en", "ja"}) {
    const ProgramRun run = run_program({"help", "forms", "--lang", language});
    EXPECT_EQ(run.exit_code, 0);
    for (const forms::FormRow& row : forms::all_forms())
      EXPECT_NE(run.out.find(row.id), std::string::npos) << row.id << " in " << language;
    for (const PairingMethod& method : pairing_methods())
      EXPECT_NE(run.out.find(method.id), std::string::npos) << method.id << " in " << language;
  }
}

TEST(forms_command, exit_codes) {
  EXPECT_EQ(run_program({"forms"}).exit_code, 2);
  EXPECT_EQ(run_program({"forms", asset("cube.obj"), "--all"}).exit_code, 2);
  EXPECT_EQ(run_program({"forms", "nosuch.obj"}).exit_code, 3);
  EXPECT_EQ(run_program({"forms", "nosuch.obj", "--json"}).line()["status"], "error");
  EXPECT_EQ(run_program({"forms", asset("obj_16_text_coord.obj")}).exit_code, 4);
  EXPECT_EQ(run_program({"forms", asset("moebius.off")}).exit_code, 0);
}

// The record of an element in each form, written by hand from the tables of the texts.
struct RecordCase {
  const char *file, *element, *form, *fields, *stored;
};

constexpr RecordCase record_cases[] = {
    {"tetrahedron.off", "0-1", "winged_edge",
     R"({"from":"v0","to":"v1","left":"f1","right":"f0","left_next":"e3","left_prev":"e2","right_next":"e0",)"
     R"("right_prev":"e4"})",
     R"({"from":0,"to":1,"left":1,"right":0,"left_next":3,"left_prev":2,"right_next":0,"right_prev":4})"},
    {"tetrahedron.off", "f1", "triangle_soup", R"({"positions":[[0,0,0],[1,0,0],[0,0,1]]})",
     R"({"positions":[[0,0,0],[1,0,0],[0,0,1]]})"},
    {"tetrahedron.off", "f1", "polygon_set", R"({"positions":[[0,0,0],[1,0,0],[0,0,1]]})",
     R"({"positions":[[0,0,0],[1,0,0],[0,0,1]]})"},
    {"tetrahedron.off", "f1", "indexed_face_set", R"({"vertices":["v0","v1","v3"]})", R"({"vertices":[0,1,3]})"},
    {"tetrahedron.off", "f1", "face_adjacency", R"({"vertices":["v0","v1","v3"],"faces":["f0","f2","f3"]})",
     R"({"vertices":[0,1,3],"faces":[0,2,3]})"},
    {"tetrahedron.off", "h2", "halfedge", R"({"from":"v0","face":"f1","twin":"h3","next":"h6","prev":"h5"})",
     R"({"from":0,"face":1,"twin":2,"next":4,"prev":5})"},
    {"tetrahedron.off", "h2", "halfedge_loop", R"({"edge":"e1","from":"v0","next":"h6","prev":"h5","face":"f1"})",
     R"({"edge":1,"from":0,"next":6,"prev":5,"face":1})"},
    {"tetrahedron.off", "h2", "dcel", R"({"from":"v0","twin":"h3","next":"h6","prev":"h5","face":"f1"})",
     R"({"from":0,"twin":3,"next":6,"prev":5,"face":1})"},
    {"tetrahedron.off", "h2", "opposite_map", R"({"from":"v0","to":"v1","twin":"h3"})",
     R"({"from":0,"to":1,"twin":2})"},
    {"tetrahedron.off", "h2", "opposite_array", R"({"from":"v0","twin":"h3"})", R"({"from":0,"twin":2})"},
    {"tetrahedron.off", "v3", "face_adjacency", R"({"position":[0,0,1],"face":"f3"})",
     R"({"position":[0,0,1],"face":3})"},
    {"fan.obj", "f5", "face_adjacency", R"({"vertices":["v0","v6","v1"],"faces":["f4",null,"f0"]})",
     R"({"vertices":[0,6,1],"faces":[4,null,0]})"},
    {"two_quads.obj", "1-4", "winged_edge",
     R"({"from":"v1","to":"v4","left":"f0","right":"f1","left_next":"e4","left_prev":"e0","right_next":"e2",)"
     R"("right_prev":"e6"})",
     nullptr},
    {"two_quads.obj", "f1", "dcel", R"({"outer":"h4","inner":[]})", R"({"outer":4,"inner":[]})"},
};

TEST(forms_records, are_those_of_the_tables_written_by_hand) {
  for (const RecordCase& one : record_cases) {
    const ProgramRun run =
        run_program({"forms", asset(one.file), "--element", one.element, "--form", one.form, "--json"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.line()["fields"], Json::parse(one.fields)) << one.file << ' ' << one.element << ' ' << one.form;
    if (one.stored == nullptr) continue;
    EXPECT_EQ(run.line()["stored"], Json::parse(one.stored)) << one.file << ' ' << one.element << ' ' << one.form;
  }
}

TEST(forms_records, of_all_elements_come_in_every_form) {
  const ProgramRun run = run_program({"forms", asset("two_quads.obj"), "--element", "all", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::map<std::string, std::map<char, int>> told;
  for (const Json& line : run.lines()) {
    const std::string element = line["element"];
    ++told[line["form"]][element[0]];
    EXPECT_EQ(line["fields"].is_null(), line["none"].is_object()) << line;
    EXPECT_EQ(line["words"].size(), line["fields"].is_null() ? 0 : line["fields"].size()) << line;
  }
  EXPECT_EQ(told.size(), forms::all_forms().size());
  const std::map<char, int> all{{'v', 6}, {'e', 7}, {'f', 2}, {'h', 14}};
  for (const auto& [form, counts] : told) EXPECT_EQ(counts, all) << form;
}

TEST(forms_records, of_nothing_known_are_refused) {
  const std::string fan = asset("fan.obj");
  for (const std::vector<std::string>& line : {std::vector<std::string>{"forms", fan, "--element", "v99"},
                                               {"forms", fan, "--element", "0-1", "--form", "x"},
                                               {"forms", fan, "--form", "dcel"}}) {
    const ProgramRun run = run_program(line);
    EXPECT_EQ(run.exit_code, 2) << line.back();
    EXPECT_FALSE(run.err.empty()) << line.back();
  }
}

// As `why` says it of the same name.
TEST(forms_records, of_a_name_that_fits_several_say_so) {
  const std::string file = asset("three_tri_edge.off");
  const auto said = [](const std::vector<std::string>& words) { return run_program(words).line()["messages"][0]; };
  for (const auto& [name, code] : std::vector<std::pair<std::string, std::string>>{
           {"0-1", "name_ambiguous"}, {"0-99", "element_unknown"}, {"x", "line_malformed"}}) {
    const Json forms = said({"forms", file, "--element", name, "--json"}),
               why = said({"why", file, "--op", "collapse", "--edge", name, "--json"});
    EXPECT_EQ(forms["code"], code) << name;
    EXPECT_EQ(forms["en"], why["en"]) << name;
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"why", file, "--op", "collapse", "--edge", name, "--json"},
          {"measure", file, name, "--json"},
          {"steps", "collapse", name, file, "--json"}}) {
      EXPECT_EQ(run_program(words).exit_code, 2) << words[0];
      EXPECT_EQ(said(words)["code"], code) << words[0];
    }
  }
}

}  // namespace
}  // namespace ryosen::test
