// Random scripts of all commands, operators and algorithms: nothing breaks, and undo leads back to the first mesh.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/app/program.h"
#include "tests/support/app/random_lines.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

constexpr int lines_in_a_script = 12;
constexpr std::uint32_t most_faces = 1500;  // of a mesh that grows on
constexpr int most_reports = 60;            // of a line that takes long, which is cancelled then

constexpr const char* meshes[] = {
    "cube.obj",      "torus.off",     "tetrahedron.off",    "fin.obj",  "bow_tie.obj",       "fan.obj", "moebius.off",
    "collinear.obj", "two_quads.obj", "three_tri_edge.off", "ball.off", "duplicate_face.obj"};

// The document that is open, and its hash before its first edit.
struct FirstState {
  std::uint64_t serial = 0, hash = 0;

  void follow(Session& session) {
    if (session.document().serial() == serial) return;
    serial = session.document().serial();
    const std::size_t position = session.document().position();
    session.document().go_to(0);
    hash = session.mesh().hash();
    session.document().go_to(position);
  }
};

void run_script(std::uint64_t seed, const std::vector<std::string>& ids) {
  auto opened = Document::open(meshes[seed % std::size(meshes)]);
  ASSERT_TRUE(opened);
  Session session(std::move(opened).value());
  session.files = RunFiles(RunFiles::Policy::keep);
  test::RandomLines lines(ids, seed);
  FirstState first;
  first.follow(session);
  std::string script;
  std::ofstream running("script.ryosen");  // what a crash or a line without end leaves
  running << "# seed " << seed << "\nopen " << meshes[seed % std::size(meshes)] << std::endl;
  for (int i = 0; i < lines_in_a_script; ++i) {
    const std::string line = session.mesh().live().faces > most_faces ? "undo" : lines.next(session);
    script += line + "\n";
    running << line << std::endl;
    int reports = 0;
    session.frontend.on_progress = [&reports](double) { return ++reports < most_reports; };
    session.run(line);
    first.follow(session);
  }
  const auto broken = check_invariants(session.mesh());
  ASSERT_FALSE(broken) << broken->sentence << "\nseed " << seed << "\n" << script;
  session.shown.end();
  Document& document = session.document();
  document.go_to(document.history().size());
  const std::uint64_t last = session.mesh().hash();
  document.go_to(0);
  ASSERT_EQ(session.mesh().hash(), first.hash) << "undone\nseed " << seed << "\n" << script;
  document.go_to(document.history().size());
  ASSERT_EQ(session.mesh().hash(), last) << "done again\nseed " << seed << "\n" << script;
}

// All but what looks at the folders of the user.
std::vector<std::string> commands_to_try() {
  std::vector<std::string> ids;
  for (const CommandRow* row : command_table())
    if (row->id != "recover" && row->id != "prefer" && row->id != "bind" && row->id != "quit")
      ids.emplace_back(row->id);
  return ids;
}

TEST(random_scripts, break_nothing_and_are_undone) {
  const test::TemporaryFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  for (const char* name : meshes) folder.copy(test::asset(name), name);
  folder.copy(test::asset("cube.obj"), "in.obj");
  folder.copy(test::asset("torus.off"), "in.off");
  const std::uint64_t first = 45000000, scripts = test::is_long_run() ? 50000 : 150;
  RecordProperty("seeds", std::to_string(first) + " to " + std::to_string(first + scripts - 1));
  const std::vector<std::string> ids = commands_to_try();
  for (std::uint64_t i = 0; i < scripts && !testing::Test::HasFatalFailure(); ++i) run_script(first + i, ids);
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace ryosen
