// Commands, flags, languages and what the program says about itself.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/ui/fonts.h"
#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

TEST(command_line, unknown_words_are_usage_errors_with_a_hint) {
  const ProgramRun command = run_program({"chekc", "a.obj"});
  EXPECT_EQ(command.exit_code, 2);
  EXPECT_NE(command.err.find("'check'"), std::string::npos) << command.err;
  const ProgramRun flag = run_program({"check", "--fail-no", "none", asset("cube.obj")});
  EXPECT_EQ(flag.exit_code, 2);
  EXPECT_NE(flag.err.find("'--fail-on'"), std::string::npos) << flag.err;
}

TEST(command_line, json_is_pure_on_every_usage_error) {
  const std::vector<std::vector<std::string>> wrong = {
      {"--json", "nonsense"},
      {"check", "--json"},
      {"check", "--json=1", "x", "--json"},
      {"check", "x", "--jobs", "--json"},
      {"why", "--json", "--edge"},
      {"edit", "a", "b", "--json"},
      {"help", "nonsense", "--json"},
      {"check", "x", "--lang", "de", "--json"},
  };
  for (const auto& arguments : wrong) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 2) << testing::PrintToString(arguments);
    const Json line = run.line();
    EXPECT_TRUE(line["file"].is_null()) << line;
    EXPECT_EQ(line["status"], "error");
    EXPECT_FALSE(std::string(line["messages"][0]["ja"]).empty());
  }
}

TEST(command_line, flags_may_stand_anywhere) {
  const std::string cube = asset("cube.obj");
  EXPECT_EQ(run_program({"--json", "check", cube}).line()["status"], "ok");
  EXPECT_EQ(run_program({"check", cube, "--json"}).line()["status"], "ok");
  EXPECT_EQ(run_program({"check", "--json", "--", cube}).line()["status"], "ok");
  const TemporaryFolder folder;
  folder.copy(cube, "--json");
  EXPECT_EQ(run_program({"check", "--json", "--", "--json"}, folder.path()).line()["file"], "--json");
}

TEST(command_line, language_comes_from_the_flag_else_from_the_environment) {
  const std::string missing = "ファイル";
  const auto speaks_japanese = [&](const std::vector<std::string>& further, const std::string& variable) {
    std::vector<std::string> arguments{"check", "nosuch.obj"};
    arguments.insert(arguments.end(), further.begin(), further.end());
    return run_program(arguments, {}, {variable}).err.find(missing) != std::string::npos;
  };
  EXPECT_FALSE(speaks_japanese({}, "LC_ALL=C"));
  EXPECT_TRUE(speaks_japanese({}, "LC_ALL=ja_JP.UTF-8"));
  EXPECT_TRUE(speaks_japanese({"--lang", "ja"}, "LC_ALL=C"));
  EXPECT_FALSE(speaks_japanese({"--lang=en"}, "LC_ALL=ja_JP.UTF-8"));
}

TEST(command_line, quiet_leaves_errors_only) {
  const TemporaryFolder folder;
  folder.write("w.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\n");
  EXPECT_NE(run_program({"check", folder.at("w.obj")}).err, "");
  EXPECT_EQ(run_program({"check", folder.at("w.obj"), "-q"}).err, "");
  EXPECT_NE(run_program({"check", "nosuch.obj", "-q"}).err, "");
}

TEST(help, names_every_command_and_each_has_its_own) {
  const std::vector<Json> rows = run_program({"help", "--json"}).lines();
  ASSERT_GE(rows.size(), 8u);
  const std::string overview = run_program({"help"}).out;
  for (const Json& row : rows) {
    const std::string id = row["command"];
    EXPECT_NE(overview.find("ryosen " + id), std::string::npos) << id;
    EXPECT_FALSE(std::string(row["en"]).empty());
    EXPECT_FALSE(std::string(row["ja"]).empty());
    const ProgramRun own = run_program({"help", id, "--lang", "ja"});
    EXPECT_EQ(own.exit_code, 0);
    for (const Json& flag : row["flags"]) {
      EXPECT_NE(own.out.find(flag["flag"]), std::string::npos) << id << flag;
      EXPECT_NE(own.out.find(flag["ja"]), std::string::npos) << id << flag;
    }
  }
}

TEST(help, covers_the_contract) {
  std::vector<std::string> ids;
  for (const Json& row : run_program({"help", "--json"}).lines()) ids.push_back(row["command"]);
  for (const char* id : {"check", "why", "edit", "formats", "keys", "doctor", "help", "--version"})
    EXPECT_NE(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
  EXPECT_EQ(run_program({"check", "--help"}).out, run_program({"help", "check"}).out);
}

TEST(version, is_one_line) {
  const ProgramRun run = run_program({"--version"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out.rfind("ryosen ", 0), 0u);
  EXPECT_EQ("ryosen " + std::string(run_program({"--version", "--json"}).line()["version"]) + "\n", run.out);
}

TEST(formats, lists_what_is_read_and_written) {
  std::vector<std::string> ids;
  for (const Json& row : run_program({"formats", "--json"}).lines()) {
    ids.push_back(row["format"]);
    EXPECT_TRUE(row["read"] == true || row["write"] == true);
    EXPECT_FALSE(row["extensions"].empty());
  }
  for (const char* id : {"obj", "off"}) EXPECT_NE(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
}

TEST(keys, each_sends_a_command) {
  const std::vector<Json> rows = run_program({"keys", "--json"}).lines();
  EXPECT_GT(rows.size(), 10u);
  for (const Json& row : rows) EXPECT_FALSE(std::string(row["command"]).empty()) << row;
}

TEST(doctor, reports_backends_fonts_and_packages) {
  const ProgramRun run = run_program({"doctor", "--json"});
  const Json report = run.line();
  bool works = false;
  for (const Json& backend : report["backends"]) works |= static_cast<bool>(backend["works"]);
  EXPECT_EQ(run.exit_code, works ? 0 : 1);
  EXPECT_TRUE(report["display"].is_null());
  const std::vector<FontUse> fonts = font_uses();
  ASSERT_EQ(report["fonts"].size(), fonts.size()) << "those that the window looks for";
  for (std::size_t i = 0; i < fonts.size(); ++i) {
    EXPECT_EQ(report["fonts"][i]["file"], fonts[i].file);
    EXPECT_EQ(report["fonts"][i]["found"], fonts[i].is_found);
  }
  EXPECT_GT(report["packages"].size(), 10u);
  EXPECT_TRUE(report["versions"].contains("compiler"));
}

TEST(command_line, h_is_help) {
  EXPECT_EQ(run_program({"-h"}).out, run_program({"--help"}).out);
  const ProgramRun run = run_program({"check", "-h"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, run_program({"help", "check"}).out);
}

TEST(command_line, a_sentence_that_asks_ends_as_a_question) {
  for (const auto& [language, end] : {std::pair("en", "did you mean eye?\n"), {"ja", "eye ですか？\n"}}) {
    const std::string said = run_program({"shot", asset("cube.obj"), "-o", "/dev/null", "--camera",
                                          R"({"eyes":[1,2,3]})", "--lang", language})
                                 .err;
    EXPECT_TRUE(said.ends_with(end)) << said;
  }
}

// The commands that only look at meshes leave the graphics libraries alone.
TEST(command_line, loads_no_graphics) {
  const std::string cube = asset("cube.obj");
  const std::vector<std::vector<std::string>> commands = {
      {"check", cube}, {"why", cube, "--op", "swap", "--all"}, {"edit", cube, "--do", "split 0-1"}};
  for (const auto& arguments : commands) {
    const ProgramRun run = run_program(arguments, {}, {"LD_DEBUG=files"});
    for (const char* library : {"libOSMesa", "libGL.so", "libEGL", "libX11"})
      EXPECT_EQ(run.err.find(library), std::string::npos) << library;
  }
}

}  // namespace
}  // namespace ryosen::test
