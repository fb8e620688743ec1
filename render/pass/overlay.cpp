#include "render/pass/overlay.h"

#include <algorithm>
#include <cmath>

#include "render/pass/linear.h"

namespace ryosen {
namespace {

// As in overlay.vert.
enum Kind { ghost_kind, line_kind, arrow_kind, point_kind };
constexpr std::size_t group_size = 128;

float packed(Kind kind, int style) { return static_cast<float>(kind + 4 * style); }
Kind kind_of(const OverlayElement& element) { return static_cast<Kind>(static_cast<int>(element.texels[2].w) & 3); }

bool is_finite(const OverlayElement& element) {
  for (int i = 0; i < 3; ++i) {
    const glm::vec4& t = element.texels[i];
    if (!std::isfinite(t.x) || !std::isfinite(t.y) || !std::isfinite(t.z)) return false;
  }
  return true;
}

std::vector<OverlayElement> converted(const Overlay& overlay, const BufferSpace& space) {
  std::vector<OverlayElement> elements;
  elements.reserve(overlay.ghosts.size() + overlay.lines.size() + overlay.points.size());
  const auto add = [&](const OverlayElement& element) {
    if (is_finite(element)) elements.push_back(element);
  };
  for (const GhostTriangle& g : overlay.ghosts) {
    add({{{space.from_mesh(g.corners[0]), 0.0f},
          {space.from_mesh(g.corners[1]), g.hidden},
          {space.from_mesh(g.corners[2]), packed(ghost_kind, 0)},
          unit(g.colour)}});
  }
  for (const Line& l : overlay.lines) {
    const glm::vec3 a = space.from_mesh(l.a);
    const float kind = packed(l.arrow ? arrow_kind : line_kind, static_cast<int>(l.style));
    add({{{a, l.width_px}, {space.from_mesh(l.b), l.hidden}, {a, kind}, unit(l.colour)}});
  }
  for (const Point& p : overlay.points) {
    const glm::vec3 at = space.from_mesh(p.at);
    const float kind = packed(point_kind, static_cast<int>(p.shape));
    add({{{at, p.radius_px}, {at, p.hidden}, {at, kind}, unit(p.colour)}});
  }
  return elements;
}

}  // namespace

DrawBox OverlayElement::box() const {
  DrawBox result;
  for (int i = 0; i < 3; ++i) result.add(glm::vec3(texels[i]));
  return result;
}

float OverlayElement::reach_px() const {
  const float size = texels[0].w;
  switch (kind_of(*this)) {
    case ghost_kind:
      return 1;
    case point_kind:
      return (size + 2) * 1.5f + 2;
    case arrow_kind:
      return (2 * size + 3) * 1.5f + 2;
    case line_kind:
      break;
  }
  return 0.5f * size * 1.5f + 2;
}

void OverlayBuffer::set(const Overlay& overlay, const BufferSpace& space, std::vector<TouchedBox>& touched) {
  std::vector<OverlayElement> fresh = converted(overlay, space);
  const auto [old_differs, new_differs] = std::mismatch(elements_.begin(), elements_.end(), fresh.begin(), fresh.end());
  const auto head = static_cast<std::size_t>(new_differs - fresh.begin());
  std::size_t tail = 0;
  const std::size_t limit = std::min(elements_.size(), fresh.size()) - head;
  while (tail < limit && elements_[elements_.size() - 1 - tail] == fresh[fresh.size() - 1 - tail]) ++tail;
  for (std::size_t i = head; i < elements_.size() - tail; ++i) {
    touched.push_back({elements_[i].box(), elements_[i].reach_px()});
  }
  for (std::size_t i = head; i < fresh.size() - tail; ++i) touched.push_back({fresh[i].box(), fresh[i].reach_px()});
  elements_ = std::move(fresh);
  gpu_.write(head, {elements_.data() + head, elements_.size() - head});
  regroup(head);
}

void OverlayBuffer::regroup(std::size_t first_changed) {
  groups_.resize((elements_.size() + group_size - 1) / group_size);
  for (std::size_t g = first_changed / group_size; g < groups_.size(); ++g) {
    Group group;
    group.first = static_cast<std::uint32_t>(g * group_size);
    group.count = static_cast<std::uint32_t>(std::min(group_size, elements_.size() - g * group_size));
    for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
      group.bounds.box.add(elements_[i].box());
      group.bounds.reach_px = std::max(group.bounds.reach_px, elements_[i].reach_px());
      group.shows_hidden |= elements_[i].texels[1].w > 0;
    }
    groups_[g] = group;
  }
}

DrawBox OverlayBuffer::bounds() const {
  DrawBox box;
  for (const Group& group : groups_) box.add(group.bounds.box);
  return box;
}

Result<OverlayPass> OverlayPass::make() {
  Result<Program> program = Program::make("overlay.vert", "overlay.frag");
  if (!program) return program.failure();
  return OverlayPass(std::move(*program));
}

OverlayPass::OverlayPass(Program program) : program_(std::move(program)), no_attributes_("overlay") {
  program_.use();
  program_.set("elements", 0);
}

OverlayPass::Selection OverlayPass::select(const Frame& frame, const OverlayBuffer& overlay) {
  const bool partial = frame.rect != PixelRect::all(frame.size);
  const auto touched = [&](const DrawBox& box, float reach_px) {
    const float reach = reach_px * frame.pixel_scale;
    return overlap(screen_bounds(box, frame.clip_from_buffer, frame.size, reach), frame.rect);
  };
  Selection selection;
  const auto add = [&](std::uint32_t first, std::uint32_t count, bool shows_hidden) {
    selection.all.add(6 * first, 6 * count);
    if (shows_hidden) selection.behind.add(6 * first, 6 * count);
  };
  for (const OverlayBuffer::Group& group : overlay.groups()) {
    if (!touched(group.bounds.box, group.bounds.reach_px)) continue;
    if (!partial) {
      add(group.first, group.count, group.shows_hidden);
      continue;
    }
    // Elements of a group may lie far apart, so of a small rectangle each is asked.
    for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
      const OverlayElement& element = overlay.elements()[i];
      if (touched(element.box(), element.reach_px())) add(i, 1, group.shows_hidden);
    }
  }
  return selection;
}

void OverlayPass::draw(const Frame& frame, const OverlayBuffer& overlay) const {
  const Selection selection = select(frame, overlay);
  if (selection.all.empty()) return;
  program_.use();
  program_.set("view_from_buffer", frame.view_from_buffer);
  program_.set("clip_from_view", frame.clip_from_view);
  program_.set("size_px", glm::vec2(frame.size.width, frame.size.height));
  program_.set("pixel_scale", frame.pixel_scale);
  program_.set("perspective", frame.ortho ? 0.0f : 1.0f);
  program_.set("units_per_pixel", frame.units_per_pixel);
  program_.set("near_distance", frame.near_distance);
  program_.set("outline_colour", unit(palette(frame.theme).outline));
  overlay.bind(0);
  glBindVertexArray(no_attributes_.id());
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  if (!selection.behind.empty()) {
    glDepthFunc(GL_GREATER);
    program_.set("hidden_pass", 1.0f);
    selection.behind.draw();
  }
  glDepthFunc(GL_LEQUAL);
  program_.set("hidden_pass", 0.0f);
  selection.all.draw();
}

}  // namespace ryosen
