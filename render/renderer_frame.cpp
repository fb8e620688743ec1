// Where the planes of a picture lie, and what its passes are told of a picture.
#include <algorithm>
#include <limits>

#include "render/renderer.h"
#include "ryosen/base/parallel.h"
#include "ryosen/geometry/unit_vector.h"

namespace ryosen {
namespace {

// The camera as it stands in buffer space, where no mesh is large or small.
Camera in_buffer(Camera camera, const BufferSpace& space) {
  camera.eye = space.place_from_mesh(camera.eye);
  camera.target = space.place_from_mesh(camera.target);
  if (camera.ortho_height) *camera.ortho_height *= space.scale;
  return camera;
}

glm::dmat4 view_from_buffer(const Camera& camera, const BufferSpace& space) {
  return view_from_mesh(in_buffer(camera, space));
}

struct DepthRange {
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -std::numeric_limits<double>::infinity();

  void add(const DrawBox& box, const glm::dmat4& view) {
    if (box.empty()) return;
    const glm::dvec4 depth_row(view[0][2], view[1][2], view[2][2], view[3][2]);
    for (unsigned i = 0; i < 8; ++i) {
      const glm::dvec4 corner((i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
                              (i & 4) ? box.max.z : box.min.z, 1.0);
      const double depth = -glm::dot(depth_row, corner);
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
  }
};

DepthRange depths_of(std::span<const Cluster> clusters, const glm::dmat4& view) {
  constexpr std::size_t steps_per_cluster = 20;  // of work for each cluster
  const auto count = static_cast<std::uint32_t>(clusters.size());
  std::vector<DepthRange> parts(threads_for(count * steps_per_cluster));
  for_each_part(count, static_cast<unsigned>(parts.size()), [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
    DepthRange range;
    for (std::uint32_t i = begin; i < end; ++i) range.add(clusters[i].box, view);
    parts[t] = range;
  });
  DepthRange all;
  for (const DepthRange& part : parts) {
    all.nearest = std::min(all.nearest, part.nearest);
    all.farthest = std::max(all.farthest, part.farthest);
  }
  return all;
}

}  // namespace

void Renderer::changed(std::span<const TouchedBox> touched) {
  if (planes_stale_ || touched.empty()) return;
  const Frame whole = frame(PixelRect::all(size_), 1);
  DepthRange range;
  for (const TouchedBox& t : touched) {
    dirty_.add(screen_bounds(t.box, whole.clip_from_buffer, size_, display_scale_ * t.reach_px + 1));
    range.add(t.box, glm::dmat4(whole.view_from_buffer));
  }
  // If something moved outside the near and far planes, they must change and everything be redrawn.
  if (range.farthest > far_ || (range.nearest < near_ && range.nearest > 0)) {
    planes_stale_ = true;
    all_changed();
  }
}

void Renderer::place_planes() {
  const glm::dmat4 view = view_from_buffer(camera_, mesh_.space());
  DepthRange range = depths_of(mesh_.clusters(), view);
  for (const OverlayBuffer& overlay : overlays_) range.add(overlay.bounds(), view);
  const Camera camera = in_buffer(camera_, mesh_.space());
  const double target = length_of(camera.target - camera.eye);
  if (!(range.nearest <= range.farthest)) range = {0.5 * target, 1.5 * target};
  const double slack = 0.01 * (range.farthest - range.nearest) + 1e-3 * target;
  far_ = range.farthest + slack;
  near_ = range.nearest - slack;
  if (!camera_.ortho_height) {
    // Perspective needs a near plane in front of the eye, closer as the eye gets closer to its target.
    far_ = std::max(far_, 1e-6 * target);
    near_ = std::max(near_, std::min(0.01 * target, 0.5 * far_));
  }
  for (OverlayBuffer& overlay : overlays_) overlay.forget_places();
  places_.place_all(mesh_.clusters(), thinning_, view, frame(PixelRect::all(size_), 1).clip_from_buffer, size_);
  planes_stale_ = false;
}

Frame Renderer::frame(const PixelRect& rect, int scale) const {
  const double aspect = double(size_.width) / double(size_.height);
  const Camera camera = in_buffer(camera_, mesh_.space());
  const glm::dmat4 view = view_from_buffer(camera_, mesh_.space());
  const glm::dmat4 clip = clip_from_view(camera, aspect, near_, far_);
  Frame f;
  f.clip_from_buffer = glm::mat4(clip * view);
  f.view_from_buffer = glm::mat4(view);
  f.clip_from_view = glm::mat4(clip);
  f.ortho = camera.ortho_height.has_value();
  f.near_distance = static_cast<float>(near_);
  f.size = {size_.width * scale, size_.height * scale};
  f.units_per_pixel = static_cast<float>(units_per_pixel(camera, f.size, 1));
  f.rect = {rect.x0 * scale, rect.y0 * scale, rect.x1 * scale, rect.y1 * scale};
  f.pixel_scale = static_cast<float>(scale);
  f.display_scale = display_scale_;
  f.thinning = thinning_;
  f.is_cut = clip_.has_value();
  if (clip_) {
    const double offset = -clip_->beyond(mesh_.space().origin) * mesh_.space().scale;
    f.clip_plane = glm::vec4(-clip_->normal, offset);
  }
  f.settings = settings_;
  return f;
}

}  // namespace ryosen
