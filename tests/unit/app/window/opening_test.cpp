#include "app/window/opening.h"

#include <gtest/gtest.h>

#include "app/editor/document/large_files.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

TEST(opening, reads_what_a_document_reads) {
  const std::string file = test::asset("stanford_bunny.obj");
  Opening opening(file);
  EXPECT_EQ(opening.told().en, "Reading stanford_bunny.obj, 2.4 MB");
  const auto document = opening.take(), same = Document::open(file);
  ASSERT_TRUE(document && same);
  EXPECT_EQ((*document)->mesh().hash(), (*same)->mesh().hash());
  EXPECT_EQ((*document)->path(), file);
}

TEST(opening, fails_as_a_document_fails) {
  const test::TemporaryFolder folder;
  for (const std::string& file : {folder.at("missing.obj"), folder.write("bad.off", "OFF\n3 1 0\n0 0 0\n")}) {
    Opening opening(file);
    const auto document = opening.take(), same = Document::open(file);
    ASSERT_FALSE(document || same);
    EXPECT_EQ(document.failure().exit_code, same.failure().exit_code);
    EXPECT_EQ(document.failure().message.text.en, same.failure().message.text.en);
  }
}

// It is not read to its end then.
TEST(opening, may_be_given_up_at_any_time) {
  for (const int ms : {0, 1, 5, 20}) {
    Opening opening(test::asset("stanford_bunny.obj"));
    opening.is_done(std::chrono::milliseconds(ms));
  }
}

TEST(opening, tells_the_long_ones_by_their_size) {
  EXPECT_TRUE(is_long_to_read(test::asset("stanford_bunny.obj")));
  EXPECT_FALSE(is_long_to_read(test::asset("cube.obj")));
  EXPECT_FALSE(is_long_to_read("/dev/stdin"));
  EXPECT_FALSE(is_long_to_read("no such file"));
}

}  // namespace
}  // namespace ryosen
