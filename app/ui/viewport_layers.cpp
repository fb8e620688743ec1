#include "app/ui/viewport_layers.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "app/editor/document/findings.h"
#include "app/editor/session/session.h"
#include "app/editor/views/mesh_view.h"
#include "app/ui/fonts.h"
#include "app/ui/overlays.h"
#include "app/ui/style.h"
#include "render/palette.h"
#include "ryosen/analysis/measures.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/scene/view/packed_normal.h"

namespace ryosen {

LabelLayer::LabelLayer() = default;
LabelLayer::~LabelLayer() = default;

void LabelLayer::set_scale(float scale) {
  if (scale == scale_) return;
  scale_ = scale;
  fonts_.reset();
}

void LabelLayer::load(Renderer& renderer) {
  renderer.set_labels({});
  fonts_ = std::make_unique<ImFontAtlas>();
  load_label_font(*fonts_, std::round(label_font_px * scale_), has_japanese_);
  renderer.set_label_fonts(*fonts_);
}

void LabelLayer::follow(Session& session, Renderer& renderer) {
  const std::span<const LabelSource> sources = label_sources();
  const bool has_any =
      !session.findings().preparing() &&
      std::any_of(sources.begin(), sources.end(), [&](const LabelSource& source) { return source.is_on(session); });
  const auto place = [&](const TextSize& size_of) { return placed_labels(session, size_of, scale_); };
  follow(has_any, place, session.view.settings.theme, renderer);
}

void LabelLayer::follow(const SeenMesh& compared, Renderer& renderer) {
  const auto place = [&](const TextSize& size_of) { return placed_labels(compared, size_of, scale_); };
  follow(!compared.findings.preparing() && has_labels(compared), place, compared.view.settings.theme, renderer);
}

void LabelLayer::follow(bool has_any, const Place& place, Theme theme, Renderer& renderer) {
  if (!has_any && is_empty_) return;
  const auto size_of = [&](const std::string& text) { return label_size(*fonts_, text); };
  std::vector<PlacedLabel> placed;
  if (has_any) {
    if (!fonts_) load(renderer);
    placed = place(size_of);
    const bool is_japanese = std::any_of(placed.begin(), placed.end(),
                                         [](const PlacedLabel& label) { return needs_japanese(label.text.c_str()); });
    if (is_japanese && !has_japanese_) {
      has_japanese_ = true;
      load(renderer);
      placed = place(size_of);
    }
  }
  const Palette& colours = palette(theme);
  std::vector<DrawnLabel> texts;
  for (const PlacedLabel& label : placed) {
    DrawnLabel& text =
        texts.emplace_back(DrawnLabel{label.corner, label.size, label.text, colours.label, colours.label_ground});
    if (!label.ground) continue;
    text.ground = rgb(*label.ground);
    const auto [r, g, b, a] = text.ground;
    text.colour = 0.3 * r + 0.6 * g + 0.1 * b > 130 ? rgb(0x000000) : rgb(0xffffff);
  }
  renderer.set_labels(texts);
  is_empty_ = texts.empty();
}

namespace {

constexpr std::uint32_t block_slots = 512;

std::uint32_t slots_of(const Mesh& mesh, Normals which) {
  return which == Normals::faces ? mesh.face_slots() : mesh.vertex_slots();
}

// What smooth shading has at the vertex, each once.
std::vector<std::uint32_t> normals_at(Findings& findings, Vertex v) {
  const Mesh& mesh = findings.mesh();
  const CornerNormals& normals = findings.corner_normals();
  const SurfaceTriangles& triangles = findings.picker().triangles();
  std::vector<std::uint32_t> packed;
  for (const Face f : faces_around(mesh, v)) {
    if (f.is_none() || findings.hidden().hides(mesh, f)) continue;
    for (const std::uint32_t slot : triangles.slots_of(mesh, f)) {
      const SurfaceTriangle triangle = triangles.at(mesh, slot);
      for (std::size_t k = 0; k < 3; ++k)
        if (triangle.corners[k] == v.index) packed.push_back(normals.packed()[slot][k]);
    }
  }
  sort_unique(packed);
  return packed;
}

}  // namespace

void NormalLines::note(const SeenMesh& seen, const ChangeFeed::Changes& changes, std::span<const std::uint32_t> slots,
                       bool everything) {
  all_stale_ |= everything;
  if (drawn_ == Normals::off || all_stale_) return;
  const auto add = [&](std::uint32_t slot) { stale_.push_back(slot / block_slots); };
  if (drawn_ == Normals::faces)
    for (const std::uint32_t f : changes.faces) add(f);
  else
    for (const std::uint32_t v : changes.vertices) add(v);
  const SurfaceTriangles& triangles = seen.findings.picker().triangles();
  for (const std::uint32_t slot : slots) {
    if (slot >= triangles.slots()) continue;
    const SurfaceTriangle triangle = triangles.at(seen.findings.mesh(), slot);
    if (triangle.face == no_index) continue;
    if (drawn_ == Normals::faces)
      add(triangle.face);
    else
      for (const std::uint32_t v : triangle.corners) add(v);
  }
}

Overlay NormalLines::block(const SeenMesh& seen, std::uint32_t number) const {
  Findings& findings = seen.findings;
  const Mesh& mesh = findings.mesh();
  const std::span<const glm::dvec3> places = seen.places;
  const Rgba colour = with_alpha(palette(theme_).label, 190);
  const std::uint32_t end = std::min((number + 1) * block_slots, slots_of(mesh, drawn_));
  Overlay overlay;
  const auto draw = [&](const glm::dvec3& from, const glm::dvec3& along) {
    if (along == glm::dvec3(0)) return;
    overlay.lines.push_back({from, from + length_ * along, colour, LineStyle::solid, 1.2f, 0});
  };
  Neighbourhood around(mesh);
  for (std::uint32_t i = number * block_slots; i < end; ++i) {
    if (drawn_ == Normals::vertices) {
      const Vertex v(i);
      if (!mesh.is_alive(v) || findings.hidden().hides(mesh, v)) continue;
      for (const std::uint32_t packed : normals_at(findings, v)) draw(places[i], unpacked_normal(packed));
    } else {
      const Face f(i);
      if (!mesh.is_alive(f) || findings.hidden().hides(mesh, f)) continue;
      glm::dvec3 sum(0);
      double corners = 0;
      for (const Vertex v : vertices_around(mesh, f)) sum += places[v.index], ++corners;
      draw(sum / corners, around.normal(f));
    }
  }
  return overlay;
}

void NormalLines::follow(const SeenMesh& seen, Renderer& renderer) {
  const ViewSettings& settings = seen.view.settings;
  const Mesh& mesh = seen.findings.mesh();
  all_stale_ |= drawn_ != settings.normals || theme_ != settings.theme;
  if (all_stale_) {
    if (drawn_ != Normals::off || settings.normals != Normals::off) renderer.set_overlay(Layer::normals, {});
    stale_.clear();
    if (settings.normals != Normals::off) {
      length_ = 0.5 * mean_edge_length(mesh);
      for (std::uint32_t i = 0; i * block_slots < slots_of(mesh, settings.normals); ++i) stale_.push_back(i);
    }
  }
  drawn_ = settings.normals;
  theme_ = settings.theme;
  all_stale_ = false;
  sort_unique(stale_);
  for (const std::uint32_t number : stale_) renderer.set_overlay_part(Layer::normals, number, block(seen, number));
  stale_.clear();
}

namespace {

constexpr std::uint32_t most_blocks = no_index / block_slots / 2;

std::uint32_t blocks_for(std::uint32_t slots) { return (slots + block_slots - 1) / block_slots; }

std::uint32_t elements_of(const ToolVerdicts& verdicts) { return static_cast<std::uint32_t>(verdicts.all().size()); }

}  // namespace

void VerdictLayer::begin(Session& session, Renderer& renderer, const ToolVerdicts* verdicts) {
  renderer.set_overlay(Layer::verdicts, {});
  renderer.show_layer(Layer::verdicts, false);
  is_stale_ = false;
  is_waiting_ = verdicts != nullptr;
  serial_ = verdicts ? verdicts->serial() : 0;
  theme_ = session.view.settings.theme;
  drawn_ = slots_ = 0;
  if (!verdicts) return;
  renderer.reserve_overlay(Layer::verdicts, verdicts->all().size());
  const ElementCounts live = session.mesh().live();
  const bool at_vertices = verdicts->sort() == Element::Kind::vertex;
  room_ = verdicts->sort() == Element::Kind::edge
              ? 0
              : room_of_points(bounds_of(session.mesh().positions()), at_vertices ? live.vertices : live.faces);
}

// The refused ones on top, where elements lie dense.
void VerdictLayer::draw_block(Findings& findings, const Gesturing& gesturing, Renderer& renderer,
                              const ToolVerdicts& verdicts, std::uint32_t block) const {
  const std::uint32_t first = block * block_slots, end = std::min(first + block_slots, slots_);
  const auto draw = [&](ElementVerdict which, std::uint32_t part) {
    renderer.set_overlay_part(
        Layer::verdicts, part,
        verdicts_overlay(findings, gesturing.drawn_positions(), verdicts, which, first, end, theme_, room_));
  };
  draw(ElementVerdict::legal, block);
  draw(ElementVerdict::refused, most_blocks + block);
}

void VerdictLayer::follow_slots(Renderer& renderer, std::uint32_t slots) {
  if (slots == slots_) return;
  for (; drawn_ > blocks_for(slots); --drawn_)
    for (const std::uint32_t part : {drawn_ - 1, most_blocks + drawn_ - 1})
      renderer.set_overlay_part(Layer::verdicts, part, {});
  drawn_ = std::min(drawn_, std::min(slots, slots_) / block_slots);
  slots_ = slots;
}

void VerdictLayer::follow(Session& session, Renderer& renderer) {
  constexpr std::uint32_t most_at_once = 40;  // of a tenth of a millisecond each
  ToolVerdicts* const verdicts = session.selecting.tool_verdicts();
  if (!verdicts && serial_ == 0) return;
  if (is_stale_ || !verdicts || serial_ != verdicts->serial() || theme_ != session.view.settings.theme)
    begin(session, renderer, verdicts);
  if (!verdicts) return;
  follow_slots(renderer, elements_of(*verdicts));
  std::uint32_t last = no_index;
  for (const std::uint32_t slot : verdicts->take_asked_again()) {
    const std::uint32_t block = slot / block_slots;
    if (block < drawn_ && block != last) draw_block(session.findings(), session.gesturing, renderer, *verdicts, block);
    last = block;
  }
  const std::uint32_t blocks = blocks_for(slots_), before = drawn_;
  const auto is_asked = [&](std::uint32_t block) {
    return verdicts->asked() >= std::min(slots_, (block + 1) * block_slots);
  };
  while (drawn_ < blocks && is_asked(drawn_) && (!session.frontend.asks_in_slices || drawn_ < before + most_at_once))
    draw_block(session.findings(), session.gesturing, renderer, *verdicts, drawn_++);
  is_waiting_ = drawn_ < blocks || !verdicts->is_complete();
  if (drawn_ == blocks) renderer.show_layer(Layer::verdicts, true);
}

}  // namespace ryosen
