#include "app/editor/document/change_feed.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> opened() {
  auto session = std::make_unique<Session>(Document::open(test::asset("cube.obj")).value());
  session->findings().picker();
  session->findings().highlights();
  return session;
}

TEST(change_feed, an_edit_an_undo_and_a_trial_tick_for_each_reader) {
  const auto session = opened();
  const ChangeFeed::Cursor first = session->findings().changes().since({}).now;
  ChangeFeed::Cursor last = first;
  const auto news = [&] {
    const ChangeFeed::Changes changes = session->findings().changes().since(last);
    last = changes.now;
    return changes;
  };
  EXPECT_TRUE(news().faces.empty());
  ASSERT_TRUE(session->run("poke f0").done());
  const ChangeFeed::Changes poked = news();
  EXPECT_FALSE(poked.everything);
  EXPECT_NE(std::find(poked.vertices.begin(), poked.vertices.end(), 8u), poked.vertices.end());
  EXPECT_NE(std::find(poked.faces.begin(), poked.faces.end(), 6u), poked.faces.end());
  EXPECT_TRUE(news().vertices.empty()) << "it has seen that";
  ASSERT_TRUE(session->run("undo").done());
  EXPECT_FALSE(news().faces.empty());
  ASSERT_TRUE(session->run("hide f1").done());
  EXPECT_TRUE(news().hiding);
  ASSERT_TRUE(session->run("self_intersections").done());
  EXPECT_TRUE(news().searched);
  EXPECT_TRUE(session->shown.try_out(ShownBy::gesture, MakeVertex{{4, 0, 0}}).done());
  EXPECT_FALSE(news().vertices.empty());
  session->shown.end();
  EXPECT_FALSE(news().vertices.empty());
  const ChangeFeed::Changes all = session->findings().changes().since(first);
  EXPECT_FALSE(all.everything);
  EXPECT_TRUE(all.hiding && all.searched) << "who comes late gets all of it";
}

TEST(change_feed, another_document_is_everything) {
  const auto session = opened();
  const ChangeFeed::Cursor before = session->findings().changes().since({}).now;
  ASSERT_TRUE(session->run("new").done());
  EXPECT_TRUE(session->findings().changes().since(before).everything);
  EXPECT_FALSE(session->findings().changes().since(session->findings().changes().since(before).now).everything);
}

TEST(change_feed, steps_of_a_gesture_tick_as_they_come) {
  const auto session = opened();
  ASSERT_TRUE(session->run("select v0").done());
  ASSERT_TRUE(session->run("gesture move").done());
  const ChangeFeed::Cursor before = session->findings().changes().since({}).now;
  session->gesturing.follow({300, 300}, {});
  const ChangeFeed::Changes changes = session->findings().changes().since(before);
  EXPECT_FALSE(changes.everything);
  EXPECT_EQ(std::count(changes.vertices.begin(), changes.vertices.end(), 0u), 1);
}

}  // namespace
}  // namespace ryosen
