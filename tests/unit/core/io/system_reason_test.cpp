#include "ryosen/io/system_reason.h"

#include <gtest/gtest.h>

#include <cerrno>

namespace ryosen {
namespace {

TEST(system_reason, what_a_user_meets_is_said_in_both_languages) {
  for (const int error : {ENOSPC, EDQUOT, EFBIG, EIO, EROFS, ENOENT, ENOTDIR, EISDIR, EACCES, EPERM, ELOOP,
                          ENAMETOOLONG, EMFILE, ENFILE, ENOMEM}) {
    const Text reason = system_reason(error);
    EXPECT_NE(reason.en, "");
    EXPECT_NE(reason.ja, reason.en);
    EXPECT_NE(reason.en.back(), '.') << "goes into a sentence";
  }
  EXPECT_NE(system_reason(ENOSPC).en.find("full"), std::string::npos);
}

TEST(system_reason, other_numbers_get_the_words_of_the_system) {
  EXPECT_EQ(system_reason(EDOM).en, "Numerical argument out of domain");
  EXPECT_EQ(system_reason(EDOM).ja, system_reason(EDOM).en);
}

}  // namespace
}  // namespace ryosen
