#include "render/pass/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/palette.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/geometry/is_finite.h"

namespace ryosen {
namespace {

// As in overlay.vert.
enum Kind { ghost_kind, line_kind, arrow_kind, point_kind };
// As in overlay.frag.
static_assert(enum_count<LineStyle> == 4 && static_cast<int>(LineStyle::dashed) == 1 &&
              static_cast<int>(LineStyle::dash_dot) == 2 && static_cast<int>(LineStyle::dotted) == 3);
static_assert(enum_count<PointShape> == 5 && static_cast<int>(PointShape::ring) == 1 &&
              static_cast<int>(PointShape::cross) == 2 && static_cast<int>(PointShape::diamond) == 3 &&
              static_cast<int>(PointShape::square) == 4);
constexpr std::size_t group_size = 128;

float packed(Kind kind, int style) { return static_cast<float>(kind + 4 * style); }
Kind kind_of(const OverlayElement& element) { return static_cast<Kind>(static_cast<int>(element.texels[2].w) & 3); }

// Above the styles of a line, as overlay.vert reads them.
constexpr int thin_flag = 4, rim_flag = 8;
static_assert(enum_count<LineStyle> <= thin_flag);
constexpr int fade_flag = 8;  // above the shapes of a point
static_assert(enum_count<PointShape> <= fade_flag);

bool has_flag(const OverlayElement& element, int flag) {
  return kind_of(element) != point_kind && ((static_cast<int>(element.texels[2].w) / 4) & flag) != 0;
}
bool thins_out(const OverlayElement& element) { return has_flag(element, thin_flag); }

bool has_finite_places(const OverlayElement& element) {
  for (int i = 0; i < 3; ++i)
    if (!is_finite(glm::vec3(element.texels[i]))) return false;
  return true;
}

}  // namespace

std::span<const glm::vec4> OverlayElement::corners() const {
  const Kind kind = kind_of(*this);
  return std::span(texels).first(kind == ghost_kind ? 3 : kind == point_kind ? 1 : 2);
}

DrawBox OverlayElement::box() const {
  DrawBox result;
  for (const glm::vec4& corner : corners()) result.add(glm::vec3(corner));
  return result;
}

float OverlayElement::length() const {
  return kind_of(*this) == point_kind ? 0 : glm::length(glm::vec3(texels[1]) - glm::vec3(texels[0]));
}

float OverlayElement::reach_px() const {
  const float size = texels[0].w + (has_flag(*this, rim_flag) ? 2.f : 0.f);
  const Kind kind = kind_of(*this);
  if (kind == ghost_kind) return 1;
  if (kind == point_kind) return (size + 2) * 1.5f + 2;
  return kind == arrow_kind ? (2 * size + 3) * 1.5f + 2 : 0.5f * size * 1.5f + 2;
}

OverlayBuffer::Elements OverlayBuffer::converted(const Overlay& overlay, const BufferSpace& space) {
  Elements elements;
  const auto add = [&](std::size_t kind, const OverlayElement& element) {
    if (has_finite_places(element)) elements[kind].push_back(element);
  };
  for (const GhostTriangle& g : overlay.ghosts) {
    add(0, {{{space.from_mesh(g.corners[0]), 0.0f},
             {space.from_mesh(g.corners[1]), g.hidden},
             {space.from_mesh(g.corners[2]), packed(ghost_kind, 0)},
             unit(g.colour)}});
  }
  for (const Line& l : overlay.lines) {
    const glm::vec3 a = space.from_mesh(l.a);
    const int style = static_cast<int>(l.style) + (l.thins_out ? thin_flag : 0) + (l.is_rim ? rim_flag : 0);
    const float kind = packed(l.arrow ? arrow_kind : line_kind, style);
    add(1, {{{a, l.width_px}, {space.from_mesh(l.b), l.hidden}, {a, kind}, unit(l.colour)}});
  }
  for (const Point& p : overlay.points) {
    const glm::vec3 at = space.from_mesh(p.at);
    const float kind = packed(point_kind, static_cast<int>(p.shape) + (p.fades ? fade_flag : 0));
    const glm::vec3 aside = at + glm::vec3(static_cast<float>(p.room * space.scale), 0, 0);
    add(2, {{{at, p.radius_px}, {aside, p.hidden}, {at, kind}, unit(p.colour)}});
  }
  return elements;
}

void OverlayBuffer::set(const Overlay& overlay, const BufferSpace& space, std::vector<TouchedBox>& touched) {
  const Elements fresh = converted(overlay, space);
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    const std::span<const OverlayElement> all = fresh[kind];
    std::uint32_t part = 0;
    for (std::size_t first = 0; first < all.size(); first += group_size)
      put(kind, part++, all.subspan(first, std::min(group_size, all.size() - first)), touched);
    while (!groups_[kind].empty() && groups_[kind].back().part >= part)
      put(kind, groups_[kind].back().part, {}, touched);
  }
}

void OverlayBuffer::set_part(std::uint32_t part, const Overlay& overlay, const BufferSpace& space,
                             std::vector<TouchedBox>& touched) {
  const Elements fresh = converted(overlay, space);
  for (std::size_t kind = 0; kind < kinds; ++kind) put(kind, part, fresh[kind], touched);
}

void OverlayBuffer::put(std::size_t kind, std::uint32_t part, std::span<const OverlayElement> fresh,
                        std::vector<TouchedBox>& touched) {
  std::vector<Group>& groups = groups_[kind];
  auto place = std::lower_bound(groups.begin(), groups.end(), part,
                                [](const Group& group, std::uint32_t number) { return group.part < number; });
  if (place == groups.end() || place->part != part) {
    if (fresh.empty()) return;
    place = groups.insert(place, Group{});
    place->part = part;
  }
  const std::span<const OverlayElement> old(elements_.data() + place->first, place->count);
  const auto [old_differs, new_differs] = std::mismatch(old.begin(), old.end(), fresh.begin(), fresh.end());
  const auto head = static_cast<std::size_t>(new_differs - fresh.begin());
  std::size_t tail = 0;
  const std::size_t limit = std::min(old.size(), fresh.size()) - head;
  while (tail < limit && old[old.size() - 1 - tail] == fresh[fresh.size() - 1 - tail]) ++tail;
  for (std::size_t i = head; i < old.size() - tail; ++i) touched.push_back({old[i].box(), old[i].reach_px()});
  for (std::size_t i = head; i < fresh.size() - tail; ++i) touched.push_back({fresh[i].box(), fresh[i].reach_px()});
  if (fresh.empty()) {
    unused_ += place->room;
    groups.erase(place);
    return;
  }
  if (head < std::max(old.size(), fresh.size())) write(*place, fresh, head);
  if (unused_ > 4096 && unused_ > elements_.size() / 2) close_gaps();
}

// Writes the elements from number `from` on; the earlier ones are unchanged.
void OverlayBuffer::write(Group& group, std::span<const OverlayElement> fresh, std::size_t from) {
  if (fresh.size() > group.room) {
    give_room(group, fresh.size());
    from = 0;
  }
  std::copy(fresh.begin() + static_cast<std::ptrdiff_t>(from), fresh.end(),
            elements_.begin() + static_cast<std::ptrdiff_t>(group.first + from));
  gpu_.write(group.first + from, fresh.subspan(from));
  group.count = static_cast<std::uint32_t>(fresh.size());
  group.bounds = {};
  group.thins_out = std::all_of(fresh.begin(), fresh.end(), thins_out);
  group.shows_hidden = group.is_placed = group.has_placed_elements = false;
  group.length = 0;
  for (const OverlayElement& element : fresh) {
    group.length += element.length() / static_cast<float>(fresh.size());
    group.bounds.box.add(element.box());
    group.bounds.reach_px = std::max(group.bounds.reach_px, element.reach_px());
    group.shows_hidden |= element.texels[1].w > 0;
  }
}

// Moves a group to the end with a new capacity. A group that grew before gets half as much again in reserve.
void OverlayBuffer::give_room(Group& group, std::size_t count) {
  unused_ += group.room;
  const std::size_t room = group.room == 0 ? count : count + count / 2;
  group.first = static_cast<std::uint32_t>(elements_.size());
  group.room = static_cast<std::uint32_t>(room);
  elements_.resize(elements_.size() + room);
  places_.resize(elements_.size());
}

void OverlayBuffer::close_gaps() {
  std::vector<OverlayElement> packed_elements;
  packed_elements.reserve(elements_.size() - unused_);
  for (std::vector<Group>& groups : groups_) {
    for (Group& group : groups) {
      const auto begin = elements_.begin() + group.first;
      group.first = static_cast<std::uint32_t>(packed_elements.size());
      group.room = group.count;
      group.has_placed_elements = false;
      packed_elements.insert(packed_elements.end(), begin, begin + group.count);
    }
  }
  elements_ = std::move(packed_elements);
  places_.resize(elements_.size());
  unused_ = 0;
  gpu_.write(0, elements_);
}

bool OverlayBuffer::has_elements() const {
  return std::any_of(groups_.begin(), groups_.end(), [](const auto& groups) { return !groups.empty(); });
}

void OverlayBuffer::reserve(std::size_t elements) {
  elements_.reserve(elements);
  places_.reserve(elements);
  gpu_.reserve(elements);
}

OverlayBuffer::Share OverlayBuffer::share_inside(const Frame& whole, const PixelRect& rect) const {
  const auto area = [](const PixelRect& r) { return double(r.width()) * double(r.height()); };
  Share share;
  for_each_group([&](const Group& group) {
    const PixelRect& at = place(group, whole.clip_from_buffer, whole.size);
    const PixelRect both = intersection(at, rect);
    if (both.empty()) return;
    const double elements = group.count * area(both) / area(at);
    const glm::vec3 middle = 0.5f * (group.bounds.box.min + group.bounds.box.max);
    const double depth = -(whole.view_from_buffer * glm::vec4(middle, 1)).z;
    const double distance = whole.ortho ? 1 : std::max<double>(depth, whole.near_distance);
    const double length_px = group.length / (double(whole.units_per_pixel) * distance);
    double across_px = display_scale_ * group.bounds.reach_px;
    if (group.thins_out) across_px = std::min(across_px, std::max(0.34 * length_px, double(display_scale_)) + 1);
    const double longest = std::max(both.width(), both.height());
    share.elements += elements;
    share.pixels += elements * across_px * (std::min(length_px, longest) + across_px);
  });
  return share;
}

DrawBox OverlayBuffer::bounds() const {
  DrawBox box;
  for_each_group([&](const Group& group) { box.add(group.bounds.box); });
  return box;
}

const PixelRect& OverlayBuffer::place(const Group& group, const glm::mat4& clip_from_buffer, Size size) const {
  if (!group.is_placed)
    group.place = screen_bounds(group.bounds.box, clip_from_buffer, size, display_scale_ * group.bounds.reach_px);
  group.is_placed = true;
  return group.place;
}

const PixelRect& OverlayBuffer::place(const Group& group, std::uint32_t element, const glm::mat4& clip_from_buffer,
                                      Size size) const {
  if (!group.has_placed_elements)
    for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
      std::array<glm::vec3, 3> corners;
      std::size_t n = 0;
      for (const glm::vec4& corner : elements_[i].corners()) corners[n++] = glm::vec3(corner);
      places_[i] =
          screen_bounds(std::span(corners).first(n), clip_from_buffer, size, display_scale_ * elements_[i].reach_px());
    }
  group.has_placed_elements = true;
  return places_[element];
}

void OverlayBuffer::set_display_scale(float scale) {
  display_scale_ = scale;
  forget_places();
}

void OverlayBuffer::forget_places() {
  for_each_group([](const Group& group) { group.is_placed = group.has_placed_elements = false; });
}

OverlayPass::OverlayPass(std::optional<Failure>& failure) : program_(failure, "overlay.vert", "overlay.frag") {
  if (failure) return;
  program_.use();
  program_.set("elements", 0);
  program_.set("element_numbers", 1);
}

OverlayPass::Selection OverlayPass::select(const Frame& frame, const OverlayBuffer& overlay) {
  const bool partial = frame.rect != PixelRect::all(frame.size);
  const int scale = static_cast<int>(frame.pixel_scale);
  const Size size{frame.size.width / scale, frame.size.height / scale};
  // In picture pixels, like the cached bounds.
  const PixelRect rect{frame.rect.x0 / scale, frame.rect.y0 / scale, (frame.rect.x1 + scale - 1) / scale,
                       (frame.rect.y1 + scale - 1) / scale};
  Selection selection;
  std::uint32_t thinning = 1;
  if (frame.thinning > 1) {
    constexpr std::size_t most_moving = 30000;
    std::size_t many = 0;
    overlay.for_each_group([&](const OverlayBuffer::Group& group) { many += group.thins_out ? group.count : 0; });
    thinning = static_cast<std::uint32_t>(many / most_moving) + 1;
  }
  std::vector<std::uint32_t> behind;
  const auto add = [&](std::uint32_t element, bool shows_hidden) {
    selection.numbers.push_back(element);
    if (shows_hidden) behind.push_back(element);
  };
  overlay.for_each_group([&](const OverlayBuffer::Group& group) {
    if (!overlap(overlay.place(group, frame.clip_from_buffer, size), rect)) return;
    const std::uint32_t step = group.thins_out ? thinning : 1;
    const std::uint32_t end = group.first + (partial ? group.count : (group.count + step - 1) / step);
    // Elements of a group may be far apart, so test each one against a partial rectangle.
    for (std::uint32_t i = group.first; i < end; ++i)
      if (!partial || overlap(overlay.place(group, i, frame.clip_from_buffer, size), rect)) add(i, group.shows_hidden);
  });
  selection.behind = behind.size();
  selection.numbers.insert(selection.numbers.begin(), behind.begin(), behind.end());
  return selection;
}

void OverlayPass::draw(const Frame& frame, const OverlayBuffer& overlay, Of of) {
  const Selection selection = select(frame, overlay);
  if (selection.numbers.empty()) return;
  use_for(frame, program_);
  program_.set("clip_from_view", frame.clip_from_view);
  program_.set("size_px", glm::vec2(frame.size.width, frame.size.height));
  program_.set("near_distance", frame.near_distance);
  program_.set("outline_colour", unit(palette(frame.settings.theme).outline));
  // To switch the clipping off is not enough: llvmpipe goes on with it in the next draw.
  const bool is_cut = frame.is_cut && of == Of::mesh;
  program_.set("clip_plane", is_cut ? frame.clip_plane : glm::vec4(0, 0, 0, 1));
  if (is_cut) glEnable(GL_CLIP_DISTANCE0);
  overlay.bind(0);
  drawn_.bind(selection.numbers, 1);
  const auto issue = [](std::size_t first, std::size_t end) {
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(6 * first), static_cast<GLsizei>(6 * (end - first)));
  };
  glBindVertexArray(no_attributes_.id());
  set_drawing(Blend::over, GL_GREATER);
  if (selection.behind > 0) {
    program_.set("hidden_pass", 1.0f);
    issue(0, selection.behind);
  }
  glDepthFunc(GL_LEQUAL);
  program_.set("hidden_pass", 0.0f);
  issue(selection.behind, selection.numbers.size());
  glDisable(GL_CLIP_DISTANCE0);
}

}  // namespace ryosen
