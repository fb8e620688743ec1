#include "app/ui/frame_pace.h"

#include <gtest/gtest.h>

#include "render/mesh_buffers.h"

namespace ryosen {
namespace {

using namespace std::chrono_literals;

TEST(frame_pace, draws_all_of_a_small_mesh_and_less_the_longer_it_takes) {
  FramePace pace;
  EXPECT_EQ(pace.thinning(70000), 1u);
  EXPECT_EQ(pace.thinning(10'000'000), 16u);
  for (int i = 0; i < 20; ++i) pace.took(16, 625000, 40ms);  // 64 ns each
  EXPECT_EQ(pace.thinning(10'000'000), 8u);
  for (int i = 0; i < 20; ++i) pace.took(16, 625000, 500ms);
  EXPECT_EQ(pace.thinning(10'000'000), MeshBuffers::cluster_size);
}

TEST(frame_pace, slices_by_what_slices_took) {
  FramePace pace;
  for (int i = 0; i < 20; ++i) pace.took(1, 400000, 40ms);  // 100 ns each
  EXPECT_NEAR(static_cast<double>(pace.triangles_of_slice()), 400000, 100);
  pace.took(1, 10, 1s);  // tells nothing
  pace.took(8, 400000, 1s);
  EXPECT_NEAR(static_cast<double>(pace.triangles_of_slice()), 400000, 100);
}

TEST(frame_pace, refines_by_what_refining_took) {
  FramePace pace;
  EXPECT_NEAR(pace.effort_of_refining(), 1.75e6, 1);
  pace.took_refining(1.75e6, 10500us);  // three times as slow as known: less at once
  EXPECT_NEAR(pace.effort_of_refining(), 0.875e6, 1);
  for (int i = 0; i < 100; ++i) pace.took_refining(0.875e6, 437500ns);
  EXPECT_NEAR(pace.effort_of_refining(), 7e6, 1e4);
  pace.took_refining(0, 1s);  // was none
  EXPECT_NEAR(pace.effort_of_refining(), 7e6, 1e4);
}

// What a part waits for is no cost of what is in it.
TEST(frame_pace, refines_in_no_ever_smaller_parts_where_each_waits_for_a_processor) {
  FramePace pace;
  for (int i = 0; i < 200; ++i) {
    const double effort = pace.effort_of_refining();
    pace.took_refining(effort, 10ms + std::chrono::nanoseconds(static_cast<std::int64_t>(2 * effort)));
  }
  EXPECT_GE(pace.effort_of_refining(), 4.375e5);
}

TEST(frame_pace, the_camera_rests_when_it_has_stood_still) {
  FramePace pace;
  const FramePace::Clock::time_point start;
  EXPECT_FALSE(pace.time_to_rest(start));
  Camera camera;
  pace.see(camera, start);
  EXPECT_EQ(pace.time_to_rest(start + 50ms), 150ms);
  pace.see(camera, start + 100ms);  // the same
  EXPECT_FALSE(pace.time_to_rest(start + 200ms));
  camera.eye.x += 1;
  pace.see(camera, start + 300ms);
  EXPECT_TRUE(pace.time_to_rest(start + 400ms));
}

}  // namespace
}  // namespace ryosen
