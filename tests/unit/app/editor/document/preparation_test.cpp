#include "app/editor/document/preparation.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

#include "app/editor/session/session.h"
#include "ryosen/analysis/components.h"
#include "ryosen/analysis/shells.h"
#include "ryosen/base/interruption.h"

namespace ryosen {
namespace {

// A torus of quads with a hole where one is left out; so many that they are prepared for in the background.
std::unique_ptr<Session> large_session(std::uint32_t rows = 450) {
  constexpr std::uint32_t columns = 450;
  MeshFile file;
  IndexedMesh& mesh = file.mesh;
  for (std::uint32_t i = 0; i < rows; ++i)
    for (std::uint32_t j = 0; j < columns; ++j) {
      const double u = 2 * std::numbers::pi * i / rows, v = 2 * std::numbers::pi * j / columns, r = 2 + std::cos(v);
      mesh.positions.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
      if (i + 1 == rows && j + 1 == columns) continue;
      const auto id = [&](std::uint32_t row, std::uint32_t column) { return row % rows * columns + column % columns; };
      for (const std::uint32_t corner : {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)})
        mesh.corners.push_back(corner);
      mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
  return std::make_unique<Session>(std::make_unique<Document>(std::move(file)));
}

void wait_for(Session& session) {
  while (session.findings().preparing()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    session.prepare();
  }
}

void expect_as_if_asked_at_once(Session& session) {
  const HighlightSets anew(session.mesh());
  EXPECT_TRUE(session.findings().highlights() == anew);
  EXPECT_EQ(session.findings().boundary_loops().count(), 1u);
  EXPECT_EQ(session.findings().euler_terms().left(), euler_poincare(session.mesh()).left());
  EXPECT_EQ(session.findings().euler_terms().genus, euler_poincare(session.mesh()).genus);
  EXPECT_EQ(session.findings().kind().kind, find_kind(session.mesh(), anew.problems()).kind);
}

TEST(preparation, finds_in_the_background_what_would_be_found_at_once) {
  const auto session = large_session();
  EXPECT_FALSE(session->findings().preparing());
  session->prepare();
  ASSERT_TRUE(session->findings().preparing());
  EXPECT_FALSE(session->pointing.pick({640, 360}, PickMode::face));
  wait_for(*session);
  EXPECT_TRUE(session->findings().changes().since({}).searched);
  expect_as_if_asked_at_once(*session);
  const auto other = large_session();
  for (int x = 100; x < 1200; x += 50) {
    const auto picked = session->pointing.pick({x, 360}, PickMode::edge),
               expected = other->pointing.pick({x, 360}, PickMode::edge);
    ASSERT_EQ(picked.has_value(), expected.has_value());
    EXPECT_TRUE(!picked || picked->element == expected->element);
  }
}

TEST(preparation, regions_are_refused_until_it_is_done_rather_than_empty) {
  const auto session = large_session();
  session->run("select f7");
  session->prepare();
  ASSERT_TRUE(session->findings().preparing());
  for (const char* line : {"box 0,0 1280,720", "lasso 0,0 1280,0 600,700"})
    EXPECT_EQ(session->run(line).exit_code, ExitCode::refused) << line;
  EXPECT_EQ(session->selecting.selection, Elements{Face(7)});
  wait_for(*session);
  EXPECT_TRUE(session->run("box 0,0 1280,720").done());
  EXPECT_GT(session->selecting.selection.size(), 1u);
}

TEST(preparation, ends_for_an_edit_and_begins_anew_behind_it) {
  const auto session = large_session();
  session->prepare();
  ASSERT_TRUE(session->findings().preparing());
  const Outcome outcome = session->run("split 0-1");
  EXPECT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_FALSE(session->findings().preparing());
  session->prepare();
  EXPECT_TRUE(session->findings().preparing());
  wait_for(*session);
  expect_as_if_asked_at_once(*session);
}

// Each of what is found ends before its time where somebody does not want to wait for it.
TEST(preparation, every_stage_can_be_interrupted) {
  const auto session = large_session();
  const Mesh& mesh = session->mesh();
  const HighlightSets sets(mesh);
  Picker picker(mesh);
  Progress unseen;
  const std::atomic<bool> flag = true;
  {
    const Interruptible interruptible(&flag);
    EXPECT_THROW(picker.prepare(mesh, unseen), Interrupted);
    EXPECT_THROW(HighlightSets{mesh}, Interrupted);
    EXPECT_THROW((HighlightSets{mesh, 1}), Interrupted);
    EXPECT_THROW(euler_poincare(mesh, sets.problems()), Interrupted);
    Neighbourhood around(mesh, Neighbourhood::Reach::whole);
    EXPECT_THROW(BoundaryLoopCount().search(around, sets.of(ProblemKind::boundary_loop)), Interrupted);
    EXPECT_THROW(find_shells(around), Interrupted);
    EXPECT_THROW(find_twist(around), Interrupted);
  }
  int picked = 0;
  for (int x = 100; x < 1200; x += 50)
    picked += picker.pick(mesh, session->view.camera, session->view.size, {x, 360}, PickMode::face).has_value();
  EXPECT_GT(picked, 5);
}

TEST(preparation, is_waited_for_by_who_asks) {
  const auto session = large_session();
  session->prepare();
  ASSERT_TRUE(session->findings().preparing());
  EXPECT_EQ(session->findings().boundary_loops().count(), 1u);
  EXPECT_FALSE(session->findings().preparing());
  expect_as_if_asked_at_once(*session);
}

TEST(preparation, is_not_worth_it_for_a_small_mesh) {
  const auto session = large_session(10);
  session->prepare();
  EXPECT_FALSE(session->findings().preparing());
}

}  // namespace
}  // namespace ryosen
