// What the pointer is on, held against what is drawn; and clicks held against commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

// One picture-maker for all tests: contexts are dear.
Headless& headless() {
  static const std::unique_ptr<Headless> made = [] {
    Headless::Options options;
    options.backend = Backend::osmesa;
    options.size = {320, 240};
    Result<std::unique_ptr<Headless>> result = Headless::make(options);
    if (!result) throw std::runtime_error(result.failure().message.text.en);
    return std::move(result).value();
  }();
  return *made;
}

std::unique_ptr<Session> session_of(const std::string& asset) {
  auto document = Document::open(test::asset(asset));
  EXPECT_TRUE(document) << asset;
  auto session = std::make_unique<Session>(std::move(document).value());
  headless().place_view(*session);
  return session;
}

IdImage ids_of(Session& session) {
  headless().picture(session);
  return headless().read_ids();
}

TEST(pointing, picks_the_face_that_is_drawn) {
  for (const char* name : {"torus.off", "cube.obj", "fin.obj", "moebius.off", "stanford_bunny.obj"}) {
    const auto session = session_of(name);
    for (const char* view : {"view iso", "view left", "frame all"}) {
      ASSERT_TRUE(session->run(view).done());
      const IdImage ids = ids_of(*session);
      int asked = 0, different = 0;
      for (int y = 2; y < ids.size.height; y += 5) {
        for (int x = 2; x < ids.size.width; x += 5) {
          const auto i =
              static_cast<std::size_t>(y) * static_cast<std::size_t>(ids.size.width) + static_cast<std::size_t>(x);
          const auto picked = session->pointing.pick({x + 0.5, y + 0.5}, PickMode::face);
          const std::uint32_t face = picked ? picked->element.index : no_index;
          ++asked;
          different += face != ids.face[i];
        }
      }
      // On the very border of two faces single precision may fall to the other side.
      EXPECT_LE(different, asked / 250) << name << ", " << view;
    }
  }
}

// Where a segment comes nearest to a pixel on the screen. Depth runs as its inverse does.
struct NearestPlace {
  glm::dvec2 place;
  double distance_px, depth;
};
NearestPlace nearest_place(const Session& session, Edge e, glm::dvec2 pixel) {
  const Mesh& m = session.mesh();
  const ScreenPoint a = *project(session.view.camera, session.view.size, m.position(ends(m, e).first));
  const ScreenPoint b = *project(session.view.camera, session.view.size, m.position(ends(m, e).second));
  const glm::dvec2 along = b.pixel - a.pixel;
  const double t = std::clamp(glm::dot(pixel - a.pixel, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
  const glm::dvec2 place = a.pixel + t * along;
  return {place, glm::length(place - pixel), 1 / ((1 - t) / a.depth + t / b.depth)};
}

enum class Sight { seen, hidden, unclear };

// Whether the picture has something clearly in front of a place: at all pixels around it, at none, or at some.
Sight sight_of(const IdImage& ids, const NearestPlace& at) {
  const int x = static_cast<int>(std::floor(at.place.x)), y = static_cast<int>(std::floor(at.place.y));
  if (x < 1 || y < 1 || x + 1 >= ids.size.width || y + 1 >= ids.size.height) return Sight::unclear;
  int in_front = 0;
  for (int i = 0; i < 9; ++i) {
    const int pixel = (y + i / 3 - 1) * ids.size.width + x + i % 3 - 1;
    const float seen = ids.depth[static_cast<std::size_t>(pixel)];
    in_front += seen > 0 && seen < 0.995 * at.depth;
  }
  return in_front == 0 ? Sight::seen : in_front == 9 ? Sight::hidden : Sight::unclear;
}

// The seen edge nearest to a pixel by looking at all of them. Nothing where the picture leaves it open.
struct Expected {
  Edge edge;
  double distance_px = 1e9;
};
std::optional<Expected> nearest_seen_edge(const Session& session, const IdImage& ids, glm::dvec2 pixel) {
  Expected best;
  double next = 1e9;  // the distance of the best rival, seen or unclear
  for (std::uint32_t i = 0; i < session.mesh().edge_slots(); ++i) {
    const NearestPlace at = nearest_place(session, Edge(i), pixel);
    if (at.distance_px > pick_radius_px + 0.5) continue;
    const Sight sight = sight_of(ids, at);
    if (sight == Sight::hidden) continue;
    if (sight == Sight::seen && at.distance_px < best.distance_px) {
      next = std::min(next, best.distance_px);
      best = {Edge(i), at.distance_px};
    } else {
      next = std::min(next, at.distance_px);
    }
  }
  if (best.distance_px == 1e9 && next == 1e9) return best;  // nothing near
  const bool is_at_the_limit = std::abs(best.distance_px - pick_radius_px) < 0.01;
  if (next < best.distance_px + 0.01 || is_at_the_limit) return std::nullopt;
  return best;
}

TEST(pointing, picks_the_nearest_edge_that_is_seen) {
  std::mt19937 random(7);
  int hits = 0, misses = 0;
  for (const char* name : {"torus.off", "cube.obj", "tetrahedron.off", "fan.obj", "moebius.off"}) {
    const auto session = session_of(name);
    const IdImage ids = ids_of(*session);
    for (int i = 0; i < 600; ++i) {
      const glm::dvec2 pixel(static_cast<double>(random() % 320u) + 0.5, static_cast<double>(random() % 240u) + 0.5);
      const auto expected = nearest_seen_edge(*session, ids, pixel);
      if (!expected) continue;
      const auto picked = session->pointing.pick(pixel, PickMode::edge);
      const bool is_near = expected->distance_px < pick_radius_px;
      (is_near ? hits : misses) += 1;
      ASSERT_EQ(picked.has_value(), is_near) << name << " at " << pixel.x << "," << pixel.y;
      if (!picked) continue;
      EXPECT_EQ(name_of(session->mesh(), picked->element), name_of(session->mesh(), expected->edge))
          << name << " at " << pixel.x << "," << pixel.y;
      EXPECT_NEAR(picked->distance_px, expected->distance_px, 1e-6);
    }
  }
  EXPECT_GT(hits, 200);
  EXPECT_GT(misses, 1000);
}

// With Alt too, whatever the mode: what is pointed at is what is selected, in the middle of a face the nearest side,
// but none beside the surface or far away.
TEST(pointing, a_click_that_selects_reaches_as_far_for_an_edge_as_one_for_its_loop) {
  std::mt19937 random(11);
  int hits = 0, far_hits = 0, misses = 0;
  for (int i = 0; i < 400; ++i) {
    const auto session = session_of(i % 3 == 0 ? "cube.obj" : "torus.off");
    ASSERT_TRUE(session->run(i % 2 == 0 ? "mode edge" : "mode face").done());
    const glm::dvec2 pixel(random() % 320u, random() % 240u);
    const auto picked = session->pointing.pick_to_select(pixel, PickMode::edge);
    (picked ? hits : misses) += 1;
    if (picked && picked->distance_px > pick_radius_px) {
      ++far_hits;
      EXPECT_TRUE(session->pointing.pick(pixel, PickMode::face)) << pixel.x << "," << pixel.y;
    }
    session->pointing.point_at(pixel, {.alt = true});
    ASSERT_EQ(session->selecting.hover().has_value(), picked.has_value()) << pixel.x << "," << pixel.y;
    session->pointing.click(pixel, "", {.alt = true});
    const Elements loop = session->selecting.selection;
    ASSERT_EQ(!loop.empty(), picked.has_value()) << pixel.x << "," << pixel.y;
    if (!picked) continue;
    EXPECT_EQ(session->selecting.hover()->picked.element, picked->element);
    EXPECT_NE(std::find(loop.begin(), loop.end(), picked->element), loop.end());
    if (session->selecting.mode != PickMode::edge) continue;
    session->pointing.click(pixel, "", {});
    EXPECT_EQ(session->selecting.selection[0], picked->element);
  }
  EXPECT_GT(hits, 20);
  EXPECT_GT(far_hits, 20);
  EXPECT_GT(misses, 20);
}

TEST(pointing, a_click_does_what_the_command_on_the_edge_does) {
  std::mt19937 random(3);
  int clicks = 0;
  for (const OpInfo& op : all_ops()) {
    if (op.target != OpTargetKind::edge) continue;
    const std::string tool(op.id);
    for (int i = 0; i < 60; ++i) {
      const auto clicked = session_of("torus.off");
      const glm::dvec2 pixel(random() % 320u, random() % 240u);
      const auto picked = clicked->pointing.pick(pixel, PickMode::edge);
      if (!picked) continue;
      ++clicks;
      clicked->selecting.tool = tool;
      clicked->pointing.point_at(pixel);
      const bool expected = clicked->selecting.hover()->preview.verdict.legal();
      const std::string line =
          command_of(clicked->mesh(), op_at(clicked->mesh(), tool, {picked->halfedge, picked->along}));
      const std::string by_click =
          "click " + std::to_string(static_cast<int>(pixel.x)) + "," + std::to_string(static_cast<int>(pixel.y));
      const Outcome outcome = clicked->run(by_click);

      const auto commanded = session_of("torus.off");
      const Outcome same = commanded->run(line);
      EXPECT_EQ(outcome.done(), expected) << line;
      EXPECT_EQ(same.done(), expected) << line;
      EXPECT_EQ(clicked->mesh().hash(), commanded->mesh().hash()) << line;
      EXPECT_EQ(clicked->log(), commanded->log());
    }
  }
  EXPECT_GT(clicks, 20);
}

TEST(pointing, the_picture_follows_edits_and_undo) {
  const auto session = session_of("torus.off");
  const Image before = headless().picture(*session);
  session->pointing.point_at({161, 196});
  ASSERT_TRUE(session->run("split 0-1").done());
  ASSERT_TRUE(session->run("undo").done());
  session->pointing.point_away();
  EXPECT_TRUE(headless().picture(*session) == before);
  // Step by step or all at once, the picture is the same.
  ASSERT_TRUE(session->run("split 0-1").done());
  headless().picture(*session);
  ASSERT_TRUE(session->run("swap 1-2").done() || session->run("split 2-3").done());
  const Image stepwise = headless().picture(*session);
  headless().forget();
  EXPECT_TRUE(headless().picture(*session) == stepwise);
}

}  // namespace
}  // namespace ryosen
