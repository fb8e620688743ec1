// `forms`: what the comparison prints, and that its figures are those of the mesh.
#include <gtest/gtest.h>

#include <map>

#include "core/forms/all.h"
#include "core/forms/pairing.h"
#include "tests/support/app/program.h"

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
  EXPECT_TRUE(rows.at("opposite_map")["query_ns"]["vertex_faces"].is_null());
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
TEST(forms_command, brute_force_on_the_bunny_is_measured_on_a_part) {
  const ProgramRun run = run_program({"forms", asset("stanford_bunny.obj"), "--json"});
  const Json line = run.line();
  for (const auto& [id, method] : rows_of(line, "pairing", "method")) {
    EXPECT_EQ(method["whole"], id != "brute_force");
    EXPECT_EQ(method["faces"] == line["faces"], id != "brute_force");
    EXPECT_GT(method["ms"], 0.0);
  }
  const std::string text = run_program({"forms", asset("stanford_bunny.obj")}).out;
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

TEST(forms_command, says_where_a_text_orders_memory_the_other_way) {
  const std::string text = run_program({"forms", asset("torus.off")}).out;
  EXPECT_NE(text.find("halfedges take less memory than a set of polygons; here they take more."), text.npos) << text;
  EXPECT_NE(text.find("180 bytes per face against 96"), text.npos) << text;
  EXPECT_EQ(run_program({"forms", asset("cube.obj")}).out.find("less memory"), std::string::npos) << "no soup of quads";
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

}  // namespace
}  // namespace ryosen::test
