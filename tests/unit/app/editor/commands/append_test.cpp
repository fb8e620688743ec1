// A file added to the open mesh, and the selection as a file or a duplicate.
#include <gtest/gtest.h>

#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> session_with(const std::string& name) {
  auto document = Document::open(test::asset(name));
  return document ? std::make_unique<Session>(std::move(document).value()) : nullptr;
}

TEST(append, adds_a_file_as_one_entry_selected_and_undone_exactly) {
  const auto session = session_with("fin.obj");
  const std::uint64_t before = session->mesh().hash();
  for (const char* const added : {"cube.obj", "three_tri_edge.off", "isolated_vertex.obj", "torus.off"}) {
    const auto alone = Document::open(test::asset(added));
    const std::uint32_t faces = session->mesh().live().faces;
    ASSERT_TRUE(session->run("append " + test::asset(added)).done()) << added;
    EXPECT_EQ(session->mesh().live().faces, faces + (*alone)->mesh().live().faces);
    EXPECT_EQ(session->document().history().size(), 1u);
    ASSERT_FALSE(session->selecting.selection.empty());
    for (const Element& e : session->selecting.selection)
      EXPECT_TRUE(e.kind != Element::Kind::face || e.index >= faces);
    ASSERT_TRUE(session->run("undo").done());
    EXPECT_EQ(session->mesh().hash(), before) << added;
  }
  EXPECT_EQ(session->run("append nowhere.obj").exit_code, ExitCode::input_missing);
  EXPECT_EQ(session->run("append").exit_code, ExitCode::usage);
  EXPECT_EQ(session->mesh().hash(), before);
  EXPECT_TRUE(session->document().path().string().ends_with("fin.obj")) << "it stays the document's file";
}

TEST(append, says_what_it_leaves_out) {
  const auto session = session_with("cube.obj");
  EXPECT_NE(session->run("append " + test::asset("seam.obj")).sentence.en.find("texture coordinates"),
            std::string::npos);
}

TEST(save_selected, writes_the_selection_and_nothing_else) {
  test::TemporaryFolder folder;
  const auto session = session_with("cube.obj");
  EXPECT_EQ(session->run("save_selected " + folder.at("a.obj")).exit_code, ExitCode::refused);
  ASSERT_TRUE(session->run("select f0 f1").done());
  for (const char* const name : {"a.obj", "b c.ply", "d.off"}) {
    const Outcome saved = session->run("save_selected \"" + folder.at(name) + "\"");
    ASSERT_TRUE(saved.done()) << saved.sentence.en;
    const auto written = Document::open(folder.at(name));
    ASSERT_TRUE(written);
    EXPECT_EQ((*written)->mesh().live().faces, 2u) << name;
  }
  EXPECT_TRUE(session->document().path().string().ends_with("cube.obj"));
  EXPECT_TRUE(session->log().empty()) << "it does nothing to the document";
  ASSERT_TRUE(session->run("select 0-1 v6").done());
  ASSERT_TRUE(session->run("save_selected " + folder.at("lines.obj")).done());
  const std::string lines = test::read_file(folder.at("lines.obj"));
  EXPECT_NE(lines.find("\nl 1 2"), std::string::npos) << lines;
  EXPECT_EQ(lines.find("\nf "), std::string::npos) << lines;
}

TEST(save_selected, takes_the_place_of_no_input_in_a_script) {
  test::TemporaryFolder folder;
  const std::string mesh = folder.copy(test::asset("cube.obj"), "cube.obj"), before = test::read_file(mesh);
  const auto run = test::run_program({"edit", mesh, "--do", "select f0; save_selected " + mesh});
  EXPECT_EQ(run.exit_code, 5) << run.err;
  EXPECT_EQ(test::read_file(mesh), before);
}

TEST(duplicate, of_the_selection_selects_the_copy_and_is_logged_by_names) {
  const auto session = session_with("cube.obj");
  EXPECT_EQ(session->run("duplicate selected").exit_code, ExitCode::refused);
  ASSERT_TRUE(session->run("select f0 f1").done());
  ASSERT_TRUE(session->run("key Shift+D").done());
  EXPECT_EQ(session->selecting.selected_names(), (std::vector<std::string>{"f6", "f7"}));
  ASSERT_TRUE(session->run("key Enter").done());
  EXPECT_EQ(session->selecting.selected_names(), (std::vector<std::string>{"f6", "f7"}));
  ASSERT_FALSE(session->log().empty());
  EXPECT_EQ(session->log().back(), "duplicate elements=f0,f1 by=0,0,0");
  ASSERT_TRUE(session->run("undo").done());
  EXPECT_EQ(session->selecting.selected_names(), (std::vector<std::string>{"f0", "f1"}));
}

}  // namespace
}  // namespace ryosen
