#include "core/io/system_reason.h"

#include <gtest/gtest.h>

#include <cerrno>

namespace ryosen {
namespace {

TEST(SystemReason, WhatAUserMeetsIsSaidInBothLanguages) {
  for (const int error : {ENOSPC, EDQUOT, EFBIG, EIO, EROFS, ENOENT, ENOTDIR, EISDIR, EACCES, EPERM, ELOOP,
                          ENAMETOOLONG, EMFILE, ENFILE, ENOMEM}) {
    const Text reason = system_reason(error);
    EXPECT_NE(reason.en, "");
    EXPECT_NE(reason.ja, reason.en);
    EXPECT_NE(reason.en.back(), '.') << "goes into a sentence";
  }
  EXPECT_NE(system_reason(ENOSPC).en.find("full"), std::string::npos);
}

TEST(SystemReason, OtherNumbersGetTheWordsOfTheSystem) {
  EXPECT_EQ(system_reason(EDOM).en, "Numerical argument out of domain");
  EXPECT_EQ(system_reason(EDOM).ja, system_reason(EDOM).en);
}

}  // namespace
}  // namespace ryosen
