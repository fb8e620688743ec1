// How much of a large mesh a window draws at once: a part of the triangles while the camera moves, slices of the rest
// when it does not.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "ryosen/scene/view/camera.h"

namespace ryosen {

// Goes by what drawing has cost so far; without a clock of its own, so that the same reports give the same answers.
class FramePace {
 public:
  using Clock = std::chrono::steady_clock;

  // A frame while the camera moves is meant to take so long, and one of the slices behind it.
  static constexpr std::chrono::milliseconds moving_frame{100}, slice{40};
  // The camera moves until it has stood still for so long.
  static constexpr std::chrono::milliseconds rest_after{200};

  // Tells where the camera is; a first one counts as moved.
  void see(const Camera& camera, Clock::time_point now);
  // The time until it rests; none if it does.
  std::optional<Clock::duration> time_to_rest(Clock::time_point now) const;

  // Every so many-th of the triangles in view is what a moving frame draws: a power of two up to that of a cluster.
  std::uint32_t thinning(std::size_t triangles_in_view) const;
  // The triangles of a slice, 1 or more.
  std::size_t triangles_of_slice() const;
  // A frame, thinned so, drew so many triangles in this time. Few triangles tell nothing.
  void took(std::uint32_t thinning, std::size_t triangles, Clock::duration time);

  // A frame that refines the picture is meant to take so long; a bit more than twice as much is not too much.
  static constexpr std::chrono::microseconds refining_frame{3500};
  // How much effort it has time for, as the view counts it.
  double effort_of_refining() const;
  // One of so much effort took this time. What is slower than known counts at once.
  void took_refining(double effort, Clock::duration time);

 private:
  std::optional<Camera> camera_;
  Clock::time_point moved_at_;
  double moving_ns_ = 130, resting_ns_ = 130;  // per triangle; at first what a software renderer needs on two cores
  double refining_ns_ = 2;                     // of each unit of effort; at first what a slow machine needs
};

}  // namespace ryosen
