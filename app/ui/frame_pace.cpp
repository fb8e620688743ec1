#include "app/ui/frame_pace.h"

#include <algorithm>

#include "render/mesh_buffers.h"

namespace ryosen {

namespace {

double nanoseconds(FramePace::Clock::duration time) { return std::chrono::duration<double, std::nano>(time).count(); }

}  // namespace

void FramePace::see(const Camera& camera, Clock::time_point now) {
  if (camera_ == camera) return;
  camera_ = camera;
  moved_at_ = now;
}

std::optional<FramePace::Clock::duration> FramePace::time_to_rest(Clock::time_point now) const {
  if (!camera_ || now - moved_at_ >= rest_after) return std::nullopt;
  return rest_after - (now - moved_at_);
}

std::uint32_t FramePace::thinning(std::size_t triangles_in_view) const {
  std::uint32_t thinning = 1;
  const double whole_ns = static_cast<double>(triangles_in_view) * moving_ns_;
  const double most_ns = nanoseconds(moving_frame);
  while (thinning < MeshBuffers::cluster_size && whole_ns / thinning > most_ns) thinning *= 2;
  return thinning;
}

std::size_t FramePace::triangles_of_slice() const {
  return std::max<std::size_t>(1, static_cast<std::size_t>(nanoseconds(slice) / resting_ns_));
}

void FramePace::took(std::uint32_t thinning, std::size_t triangles, Clock::duration time) {
  constexpr std::size_t telling = 50000;
  if (triangles < telling) return;
  double& known = thinning > 1 ? moving_ns_ : resting_ns_;
  known = 0.5 * known + 0.5 * nanoseconds(time) / static_cast<double>(triangles);
}

double FramePace::effort_of_refining() const { return nanoseconds(refining_frame) / refining_ns_; }

void FramePace::took_refining(double effort, Clock::duration time) {
  if (effort <= 0) return;
  // On a busy machine each part waits for a processor, however small it is: below this smaller parts take no less time,
  // and there would be thousands of them.
  constexpr double slowest_ns = 8;
  const double now_ns = std::clamp(nanoseconds(time) / effort, 0.01, slowest_ns);
  const double weight = now_ns > refining_ns_ ? 0.5 : 0.1;
  refining_ns_ += weight * (now_ns - refining_ns_);
}

}  // namespace ryosen
