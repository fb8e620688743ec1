// A format that is only read, brought by another program, through everything that goes over the table of formats.
#include <gtest/gtest.h>
#include <unistd.h>

#include "app/cli/check_report.h"
#include "app/editor/session/session.h"
#include "ryosen/io/formats.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

using test::ProgramRun;
using test::run_here;
using test::TemporaryFolder;

// "dot N": N points. Ends in N where N is no number.
Format dots_format() {
  Format format;
  format.id = "dots";
  format.name = {"dots", "点の並び"};
  format.extensions = {".dots"};
  format.sniff = [](std::string_view head, std::uint64_t) {
    return head.starts_with("dot ") ? Likeness::sure : Likeness::no;
  };
  format.read = [](std::string_view bytes, const std::filesystem::path&) -> Result<MeshFile> {
    if (bytes[4] < '0' || bytes[4] > '9')
      return malformed("unreadable_number", {"No number.", "数ではありません。"}, FilePlace::at_line(1));
    MeshFile file;
    file.mesh.positions.resize(static_cast<std::size_t>(bytes[4] - '0'));
    return file;
  };
  return format;
}

TEST(scoped_format, is_read_by_every_command_and_written_by_none) {
  const TemporaryFolder folder;
  folder.write("a.dots", "dot 3\n");
  folder.write("bad.dots", "dot x\n");
  EXPECT_EQ(run_here({"formats"}).out.find("dots"), std::string::npos);
  const ScopedFormat added(dots_format());

  EXPECT_NE(run_here({"formats", "--lang", "en"}).out.find("dots (.dots); read\n"), std::string::npos);
  EXPECT_NE(run_here({"formats", "--json"})
                .out.find("\"extensions\":[\".dots\"],\"variants\":[],\"read\":true,\"write\":false"),
            std::string::npos);
  const ProgramRun checked = run_here({"check", "--json", folder.path().string()});
  EXPECT_EQ(checked.exit_code, 9) << "the folder is walked over its extension";
  EXPECT_NE(checked.out.find("a.dots\",\"format\":\"dots\",\"status\":\"warnings\",\"vertices\":3"), std::string::npos);
  EXPECT_NE(checked.out.find("bad.dots\",\"format\":\"dots\",\"status\":\"error\""), std::string::npos);

  const std::string in = folder.at("a.dots"), out = folder.at("b.dots"), obj = folder.at("b.obj");
  for (const ProgramRun& refused : {run_here({"convert", in, "-o", out, "--lang", "en"}),
                                    run_here({"convert", in, "-o", obj, "--format", "dots", "--lang", "en"}),
                                    run_here({"edit", in, "-o", out, "--do", "undo", "--lang", "en"})}) {
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("dots are only read, not written"), std::string::npos) << refused.err;
  }
  EXPECT_EQ(run_here({"convert", in, "-o", obj}).exit_code, 0);

  Session session(std::make_unique<Document>());
  EXPECT_TRUE(session.run("open " + in).done());
  const Outcome save = session.run("save");
  EXPECT_EQ(save.exit_code, ExitCode::usage);
  EXPECT_NE(save.sentence.en.find("only read"), std::string::npos) << save.sentence.en;
  EXPECT_TRUE(session.document().losses(out).empty());
  EXPECT_TRUE(session.run("save " + folder.at("c.ply.gz")).done());
}

// A second look at a pipe finds nothing there.
TEST(check_report, reads_a_refused_file_once) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  constexpr std::string_view text = "v 0 0 0\nv x 0 0\n";
  ASSERT_EQ(::write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  ::close(ends[1]);
  const cli::CheckReport report = cli::check_file("/dev/fd/" + std::to_string(ends[0]));
  ::close(ends[0]);
  ASSERT_TRUE(report.failure);
  EXPECT_EQ(report.failure->message.code, "unreadable_number");
  EXPECT_EQ(report.format, "obj");
}

TEST(check_report, has_what_was_asked_for) {
  const std::string cube = test::asset("cube.obj");
  EXPECT_NE(cli::check_file(cube).kind.reason.en, "");
  EXPECT_EQ(cli::check_file(cube, {.kind = false}).kind.reason.en, "");
  EXPECT_EQ(cli::check_file(cube).figures.vertices, 8u);
  EXPECT_EQ(cli::check_file(cube, {.figures = false}).figures.vertices, 0u);
}

}  // namespace
}  // namespace ryosen
