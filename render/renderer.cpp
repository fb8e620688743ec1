#include "render/renderer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "ryosen/base/parallel.h"
#include "ryosen/geometry/unit_vector.h"

namespace ryosen {

namespace {

constexpr PixelFormat picture_formats[] = {PixelFormat::rgba8};

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
    for (std::size_t i = 0; i < 8; ++i) {
      const double depth = -glm::dot(depth_row, glm::dvec4(glm::dvec3(box.corner(i)), 1.0));
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

Result<std::unique_ptr<Renderer>> Renderer::make() {
  std::optional<Failure> failure;
  std::unique_ptr<Renderer> made(new Renderer(failure));
  if (failure) return std::move(*failure);
  return made;
}

Renderer::Renderer(std::optional<Failure>& failure)
    : passes_{SurfacePass(failure), CutPass(failure),     XrayPass(failure), BackgroundPass(failure), GridPass(failure),
              OverlayPass(failure), ResolvePass(failure), IdsPass(failure),  LabelsPass(failure)},
      overlays_{OverlayBuffer("normals"),  OverlayBuffer("account"),  OverlayBuffer("highlights"),
                OverlayBuffer("verdicts"), OverlayBuffer("question"), OverlayBuffer("selection"),
                OverlayBuffer("links"),    OverlayBuffer("measures"), OverlayBuffer("steps"),
                OverlayBuffer("hover"),    OverlayBuffer("handles"),  OverlayBuffer("axes")},
      rendered_("rendered", picture_formats, true),
      resolved_("resolved", picture_formats, false),
      fine_("fine", picture_formats, true) {
  is_shown_.fill(true);
  if (!failure) resize(size_);
}

void Renderer::all_changed() {
  waiting_.clear();
  dirty_.clear();
  dirty_.add(PixelRect::all(size_));
}

void Renderer::resize(Size size, int supersample) {
  size_ = {std::max(size.width, 1), std::max(size.height, 1)};
  supersample_ = std::clamp(supersample, 1, 8);
  rendered_.resize({size_.width * supersample_, size_.height * supersample_});
  if (supersample_ > 1) resolved_.resize(size_);
  glm::ivec2 most{0};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, &most.x);
  can_refine_ =
      supersample_ < Refinement::samples && std::max(size_.width, size_.height) <= most.x / Refinement::samples;
  refinement_.begin(size_);
  planes_stale_ = true;
  all_changed();
}

void Renderer::set_settings(const ViewSettings& settings) { follow(settings, settings_); }

void Renderer::set_display_scale(float scale) {
  if (follow(scale, display_scale_))
    for (OverlayBuffer& overlay : overlays_) overlay.set_display_scale(scale);
}

void Renderer::set_clip(const std::optional<ClipPlane>& plane) { follow(plane, clip_); }

void Renderer::set_transparent(bool transparent) { follow(transparent, transparent_); }

void Renderer::set_camera(const Camera& camera) {
  if (follow(camera, camera_)) planes_stale_ = true;
}

void Renderer::set_thinning(std::uint32_t thinning) {
  if (follow(thinning, thinning_)) planes_stale_ = true;  // the clusters are placed by it
}

void Renderer::set_tints(std::span<const DrawnTint> tints) {
  if (std::equal(tints.begin(), tints.end(), tints_.begin(), tints_.end())) return;
  tints_.assign(tints.begin(), tints.end());
  all_changed();
}

void Renderer::set_overlay(Layer layer, const Overlay& overlay) {
  std::vector<TouchedBox> touched;
  overlays_[static_cast<std::size_t>(layer)].set(overlay, mesh_.space(), touched);
  if (is_shown_[static_cast<std::size_t>(layer)]) changed(touched);
}

void Renderer::show_layer(Layer layer, bool shown) {
  bool& is_shown = is_shown_[static_cast<std::size_t>(layer)];
  if (std::exchange(is_shown, shown) != shown && overlays_[static_cast<std::size_t>(layer)].has_elements())
    all_changed();
}

void Renderer::reserve_overlay(Layer layer, std::size_t elements) {
  overlays_[static_cast<std::size_t>(layer)].reserve(elements);
}

void Renderer::set_labels(std::span<const DrawnLabel> texts) {
  for (const PixelRect& rect : passes_.labels.set(texts)) dirty_.add(intersection(rect, PixelRect::all(size_)));
}

void Renderer::set_overlay_part(Layer layer, std::uint32_t part, const Overlay& overlay) {
  std::vector<TouchedBox> touched;
  overlays_[static_cast<std::size_t>(layer)].set_part(part, overlay, mesh_.space(), touched);
  if (is_shown_[static_cast<std::size_t>(layer)]) changed(touched);
}

void Renderer::set_mesh(const TriangleSource& source) {
  const Box box = bounds_of(source.positions);
  mesh_.set(source, box.lowest, box.highest);
  std::vector<TouchedBox> nothing_left;
  for (OverlayBuffer& overlay : overlays_) overlay.set({}, mesh_.space(), nothing_left);
  planes_stale_ = true;
  all_changed();
}

void Renderer::update_mesh(const TriangleSource& source, std::span<const std::uint32_t> vertices,
                           std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> faces) {
  const MeshChange change = mesh_.update(source, vertices, triangles, faces);
  if (planes_stale_) return;
  const Frame whole = frame(PixelRect::all(size_), 1);
  places_.place(mesh_.clusters(), change.clusters, whole.clip_from_buffer, size_);
  std::vector<TouchedBox> touched;
  for (const DrawBox& box : change.boxes) touched.push_back({box, 0});
  changed(touched);
}

void Renderer::follow_camera() {
  if (!planes_stale_) return;
  place_planes();
  all_changed();
}

void Renderer::follow_ground() {
  if (settings_.ground == GroundGrid::on) follow(ground_below(mesh_.bounds(), mesh_.space()), ground_);
}

std::size_t Renderer::triangles_in_view() {
  follow_camera();
  return places_.triangles_inside(mesh_.clusters(), PixelRect::all(size_));
}

Image Renderer::read_pixels() const {
  Image image(size_);
  picture().read(0, PixelRect::all(size_), image.pixels.data());
  if (!transparent_) return image;
  for (Rgba& p : image.pixels) {
    if (p[3] == 0 || p[3] == 255) continue;
    for (std::size_t c = 0; c < 3; ++c)
      p[c] = static_cast<std::uint8_t>(std::min(255, (int(p[c]) * 255 + p[3] / 2) / p[3]));
  }
  return image;
}

IdImage Renderer::read_ids() {
  follow_camera();
  const Frame f = frame(PixelRect::all(size_), 1);
  const Framebuffer& target = passes_.ids.draw(f, mesh_, places_.inside(mesh_.clusters(), PixelRect::all(size_)));
  const auto count = static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height);
  IdImage image{size_, std::vector<std::uint32_t>(count), std::vector<std::uint32_t>(count, no_index),
                std::vector<float>(count)};
  target.read(0, f.rect, image.triangle.data());
  target.read(1, f.rect, image.depth.data());
  const std::vector<std::uint32_t> faces = mesh_.faces_of_slots();
  for (std::size_t i = 0; i < count; ++i) {
    image.depth[i] = static_cast<float>(image.depth[i] / mesh_.space().scale);
    if (image.triangle[i] == 0) {
      image.triangle[i] = no_index;
      continue;
    }
    const std::uint32_t slot = image.triangle[i] - 1;
    image.triangle[i] = mesh_.source_of_slot(slot);
    image.face[i] = faces[slot];
  }
  return image;
}

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
