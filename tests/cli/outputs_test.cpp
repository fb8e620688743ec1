// What a run writes: never in the place of what it reads or wrote before, and into devices and pipes.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

constexpr const char* tetrahedron = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

TEST(outputs, a_script_never_turns_what_the_run_reads_into_a_picture) {
  const TemporaryFolder folder;
  folder.write("in.off", tetrahedron);
  std::filesystem::create_symlink("in.off", folder.at("soft.png"));
  std::filesystem::create_hard_link(folder.at("in.off"), folder.at("hard.png"));
  folder.write("b.off", tetrahedron);
  for (const char* lines :
       {"shot in.off", "shot soft.png", "shot hard.png", "shot s", "shot first.png\nshot first.png",
        "save o.off\nshot o.off", "shot out.png", "open b.off\nsave b.off", "save o.off\nopen b.off\nsave o.off"}) {
    folder.write("s", lines);
    const ProgramRun run =
        run_program({"shot", "in.off", "--script", "s", "-o", "out.png", "--size", "32x32"}, folder.path());
    EXPECT_EQ(run.exit_code, 5) << lines;
    EXPECT_NE(run.err.find("would replace it"), std::string::npos) << lines << "\n" << run.err;
    for (const char* made : {"first.png", "o.off", "out.png"}) EXPECT_FALSE(folder.has(made)) << lines;
    EXPECT_EQ(read_file(folder.at("in.off")), tetrahedron) << lines;
    EXPECT_EQ(read_file(folder.at("s")), lines);
  }
  folder.write("s", "shot in.off\n");
  EXPECT_EQ(run_program({"shot", "in.off", "--script", "s", "-o", "s"}, folder.path()).exit_code, 5);
  const std::vector<std::string> overwrite{"shot", "in.off",  "--script", "s",    "--overwrite",
                                           "-o",   "out.png", "--size",   "32x32"};
  EXPECT_EQ(run_program(overwrite, folder.path()).exit_code, 2) << "a picture under the name of a mesh";
  EXPECT_EQ(read_file(folder.at("in.off")), tetrahedron);
  folder.write("s", "shot s\n");
  EXPECT_EQ(run_program(overwrite, folder.path()).exit_code, 0);
  EXPECT_TRUE(read_file(folder.at("s")).starts_with("\x89PNG"));
}

TEST(outputs, a_reference_stays_what_the_picture_is_compared_with) {
  const TemporaryFolder folder;
  folder.write("in.off", tetrahedron);
  folder.write("s", "shot ref.png\n");
  const std::vector<std::string> make{"shot", "in.off", "--size", "32x32"};
  const auto run = [&](std::vector<std::string> further) {
    further.insert(further.begin(), make.begin(), make.end());
    return run_program(further, folder.path());
  };
  ASSERT_EQ(run({"--view", "top", "-o", "ref.png"}).exit_code, 0);
  const std::string reference = read_file(folder.at("ref.png"));
  EXPECT_EQ(run({"--script", "s", "--compare", "ref.png"}).exit_code, 5);
  EXPECT_EQ(run({"-o", "ref.png", "--compare", "ref.png"}).exit_code, 5);
  const ProgramRun same = run({"-o", "d.png", "--compare", "ref.png", "--diff", "./d.png", "--json"});
  EXPECT_EQ(same.exit_code, 5);
  EXPECT_EQ(same.line()["messages"][0]["code"], "output_would_be_replaced");
  EXPECT_FALSE(folder.has("d.png"));
  EXPECT_EQ(read_file(folder.at("ref.png")), reference);
  EXPECT_EQ(run({"--compare", "ref.png", "--diff", "d.png"}).exit_code, 1);
}

TEST(outputs, the_result_of_edit_does_not_replace_what_a_line_has_saved) {
  const TemporaryFolder folder;
  folder.write("in.off", tetrahedron);
  const auto edit = [&](std::vector<std::string> further) {
    further.insert(further.begin(), {"edit", "in.off"});
    return run_program(further, folder.path()).exit_code;
  };
  EXPECT_EQ(edit({"--do", "save o.off; split 0-1", "-o", "o.off"}), 5);
  EXPECT_EQ(edit({"--do", "save o.off; new; save o.off"}), 5);
  EXPECT_FALSE(folder.has("o.off"));
  EXPECT_EQ(edit({"--do", "save o.off; split 0-1; save o.off; save"}), 0) << "its own file is saved again";
  EXPECT_EQ(edit({"--do", "save o.off"}), 0) << "a file that the run has nothing to do with is replaced";
}

TEST(outputs, a_picture_without_a_name_takes_a_free_one) {
  const TemporaryFolder folder;
  folder.write("in.off", tetrahedron);
  folder.write("ryosen-1.png", "mine");
  folder.write("s", "shot\nkey F12\n");
  EXPECT_EQ(run_program({"shot", "in.off", "--script", "s", "-o", "o.png", "--size", "32x32"}, folder.path()).exit_code,
            0);
  EXPECT_EQ(folder.names(),
            (std::vector<std::string>{"in.off", "o.png", "ryosen-1.png", "ryosen-2.png", "ryosen.png", "s"}));
  EXPECT_EQ(read_file(folder.at("ryosen-1.png")), "mine");
}

TEST(outputs, a_free_name_is_none_that_the_run_will_write) {
  const TemporaryFolder folder;
  folder.write("in.off", tetrahedron);
  folder.write("s", "key F12\nview top\nshot ryosen-1.png\n");
  const std::vector<std::string> shot{"shot", "in.off", "--script", "s", "-o", "ryosen.png", "--size", "32x32"};
  const ProgramRun run = run_program(shot, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"in.off", "ryosen-1.png", "ryosen-2.png", "ryosen.png", "s"}));
  EXPECT_EQ(read_file(folder.at("ryosen.png")), read_file(folder.at("ryosen-1.png")));
  EXPECT_NE(read_file(folder.at("ryosen.png")), read_file(folder.at("ryosen-2.png"))) << "before the view was changed";
}

TEST(outputs, standard_output_gets_the_mesh_and_nothing_else) {
  const TemporaryFolder folder;
  folder.write("in.off", tetrahedron);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"edit", "--do", "expect V 4"}, {"repair"}, {"convert", "--format", "off"}}) {
    std::vector<std::string> arguments{words[0], "in.off", "-o", "/dev/stdout"};
    arguments.insert(arguments.end(), words.begin() + 1, words.end());
    const ProgramRun run = run_program(arguments, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, tetrahedron) << words[0];
    EXPECT_NE(run.err.find("written: /dev/stdout"), std::string::npos) << run.err;
    arguments.push_back("--json");
    const ProgramRun json = run_program(arguments, folder.path());
    EXPECT_EQ(json.exit_code, 2) << words[0];
    EXPECT_EQ(json.line()["messages"][0]["code"], "flags_exclude");
  }
  const ProgramRun formless = run_program({"convert", "in.off", "-o", "/dev/stdout"}, folder.path());
  EXPECT_EQ(formless.exit_code, 2) << "in which format?";
  EXPECT_NE(formless.err.find("--format"), std::string::npos) << formless.err;
  EXPECT_EQ(run_program({"edit", "--new", "--do", "expect V 0", "-o", "/dev/stdout"}, folder.path()).exit_code, 2);
  EXPECT_EQ(run_program({"repair", "in.off", "-o", "/dev/full"}, folder.path()).exit_code, 5);
  EXPECT_EQ(run_program({"repair", "in.off", "-o", "/dev/null"}, folder.path()).exit_code, 0);
}

// What a shell does with the program's words.
struct ShellRun {
  int exit_code;
  std::string err;
};

ShellRun run_in_shell(const TemporaryFolder& folder, const std::string& words, const std::string& redirection) {
  const std::string command =
      "cd '" + folder.path().string() + "' && '" + RYOSEN_PROGRAM + "' " + words + " 2>err " + redirection;
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), read_file(folder.at("err"))};
}

TEST(outputs, a_report_that_cannot_be_written_says_what_was_written) {
  const TemporaryFolder folder;
  folder.write("in.off", tetrahedron);
  for (const char* redirection : {">&-", ">/dev/full"}) {
    for (const auto& [words, written] : {std::pair{"subdivide in.off -o o.obj", "o.obj"},
                                         {"convert in.off -o o2.obj --json", "o2.obj"},
                                         {"repair in.off -o o3.off --json", "o3.off"},
                                         {"edit in.off --do 'split 0-1' -o o4.off", "o4.off"},
                                         {"hull in.off -o o5.off", "o5.off"}}) {
      const ShellRun run = run_in_shell(folder, words, redirection);
      EXPECT_EQ(run.exit_code, 5) << words << redirection;
      EXPECT_NE(run.err.find("Standard output cannot be written. " + std::string(written) + " is written."),
                std::string::npos)
          << words << redirection << run.err;
      EXPECT_EQ(run_program({"check", written}, folder.path()).exit_code, 0) << words << redirection;
      std::filesystem::remove(folder.at(written));
    }
    const ShellRun two = run_in_shell(folder, "edit in.off --do 'save a.off; split 0-1' -o b.off", redirection);
    EXPECT_EQ(two.exit_code, 5);
    EXPECT_NE(two.err.find("a.off and b.off are written."), std::string::npos) << two.err;
    const ShellRun none = run_in_shell(folder, "check in.off", redirection);
    EXPECT_EQ(none.exit_code, 5);
    EXPECT_NE(none.err.find("Standard output cannot be written.\n"), std::string::npos) << none.err;
    const ShellRun japanese = run_in_shell(folder, "repair in.off -o o6.off --lang ja", redirection);
    EXPECT_NE(japanese.err.find("標準出力に書き込めません。o6.off は書き出しました。"), std::string::npos)
        << japanese.err;
  }
}

TEST(outputs, what_convert_writes_is_read_again_as_what_it_is) {
  const TemporaryFolder folder;
  folder.write("full.off", tetrahedron);
  folder.write("empty.off", "OFF\n0 0 0\n");
  std::size_t refused = 0;
  for (const char* in : {"full.off", "empty.off"})
    for (const char* name : {"o.obj", "o.off", "o.ply", "o.stl", "o.txt", "o.glb", "o.dat", "o"})
      for (const char* format : {"obj", "ply-ascii", "off", "stl-ascii", "stl-binary", "txt"}) {
        std::filesystem::remove(folder.at(name));
        const ProgramRun run = run_program({"convert", in, "-o", name, "--format", format}, folder.path());
        const std::string what = std::string(in) + " " + name + " " + format;
        refused += run.exit_code == 2;
        EXPECT_EQ(folder.has(name), run.exit_code == 0) << what;
        EXPECT_EQ(run.exit_code == 2, run.err.find("choose a name with .") != std::string::npos) << run.err;
        if (!folder.has(name)) continue;
        const Json check = run_program({"check", name, "--json"}, folder.path()).line();
        EXPECT_TRUE(std::string(format).starts_with(check["format"].get<std::string>())) << what;
        EXPECT_NE(check["status"], "error") << what;
      }
  EXPECT_GT(refused, 10u);
  EXPECT_LT(refused, 60u);
}

TEST(outputs, pipes_are_written_to_where_somebody_reads_them) {
  const TemporaryFolder folder;
  folder.write("in.off", tetrahedron);
  ASSERT_EQ(::mkfifo(folder.at("pipe").c_str(), 0600), 0);
  const ProgramRun alone = run_program({"repair", "in.off", "-o", "pipe"}, folder.path());
  EXPECT_EQ(alone.exit_code, 5);
  EXPECT_NE(alone.err.find("nobody reads this pipe"), std::string::npos) << alone.err;
  const std::string command = "cd " + folder.path().string() + " && exec 7<>pipe && " + shell_program() +
                              " repair in.off -o pipe >/dev/null && timeout 5 head -c 66 <&7 >got";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(read_file(folder.at("got")), tetrahedron);
  EXPECT_TRUE(std::filesystem::is_fifo(folder.at("pipe")));
}

TEST(outputs, names_and_words_of_files_do_not_command_the_terminal) {
  const TemporaryFolder folder;
  const std::string name = "\x1b[31m\xe2\x80\xae\xc2\x9b\xff\nred.obj";
  folder.write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n");
  const std::string seen = "\\x1b[31m\\u202e\\u009b\\xff\\x0ared.obj";
  const ProgramRun run = run_program({"check", name}, folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(run.out.starts_with(seen + " (obj): warnings\n")) << run.out;
  EXPECT_NE(run.err.find(seen + ":5: warning: "), std::string::npos) << run.err;
  for (const std::string& text : {run.out, run.err}) {
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find('\xff'), std::string::npos);
  }
  const ProgramRun missing = run_program({"check", "\x1b]0;x\x07"}, folder.path());
  EXPECT_NE(missing.err.find("There is no file \\x1b]0;x\\x07."), std::string::npos) << missing.err;
  EXPECT_NE(run_program({"repair", name, "-o", "\n.obj"}, folder.path()).out.find("written: \\x0a.obj\n"),
            std::string::npos);
  const std::string japanese = "\xe7\xa8\x9c\xe7\xb7\x9a.obj";
  folder.write(japanese, "v 0 0 0\n");
  EXPECT_TRUE(run_program({"check", japanese}, folder.path()).out.starts_with(japanese)) << "letters stay";
}

}  // namespace
}  // namespace ryosen::test
