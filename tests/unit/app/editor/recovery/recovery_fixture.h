// Windows that crash: sessions that end without finishing their autosave, with a state folder of their own.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {

class RecoveryTest : public testing::Test {
 protected:
  void SetUp() override {
    if (const char* const before = std::getenv("XDG_STATE_HOME")) before_ = before;
    setenv("XDG_STATE_HOME", state_.path().c_str(), 1);
  }
  void TearDown() override { before_ ? setenv("XDG_STATE_HOME", before_->c_str(), 1) : unsetenv("XDG_STATE_HOME"); }

  // A session as the window has it.
  struct Window {
    explicit Window(std::unique_ptr<Document> document) : session(std::move(document)) {
      session.frontend.autosave = &autosave;
      autosave.begin(session.document());
    }
    void run(const std::string& line) {
      const Outcome outcome = session.run(line);
      EXPECT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
    }

    Session session;
    Autosave autosave{recovery_folder()};
  };

  std::unique_ptr<Window> open(const std::string& path) const {
    auto document = Document::open(path);
    EXPECT_TRUE(document) << path;
    return std::make_unique<Window>(std::move(document).value());
  }
  static std::unique_ptr<Window> open_nothing() { return std::make_unique<Window>(std::make_unique<Document>()); }

  std::vector<std::string> kept() const { return state_.names(); }

  test::TemporaryFolder state_, files_;
  std::optional<std::string> before_;
};

}  // namespace ryosen
