#include "app/ui/verdict_layer.h"

#include <algorithm>
#include <vector>

#include "app/editor/session/session.h"
#include "app/ui/overlays.h"

namespace ryosen {

namespace {

constexpr std::uint32_t in_block = 512, most_blocks = no_index / in_block / 2;

std::uint32_t blocks_for(std::uint32_t slots) { return (slots + in_block - 1) / in_block; }

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
  const std::uint32_t first = block * in_block, end = std::min(first + in_block, slots_);
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
  drawn_ = std::min(drawn_, std::min(slots, slots_) / in_block);
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
    const std::uint32_t block = slot / in_block;
    if (block < drawn_ && block != last) draw_block(session.findings(), session.gesturing, renderer, *verdicts, block);
    last = block;
  }
  const std::uint32_t blocks = blocks_for(slots_), before = drawn_;
  const auto is_asked = [&](std::uint32_t block) {
    return verdicts->asked() >= std::min(slots_, (block + 1) * in_block);
  };
  while (drawn_ < blocks && is_asked(drawn_) && (!session.frontend.asks_in_slices || drawn_ < before + most_at_once))
    draw_block(session.findings(), session.gesturing, renderer, *verdicts, drawn_++);
  is_waiting_ = drawn_ < blocks || !verdicts->is_complete();
  if (drawn_ == blocks) renderer.show_layer(Layer::verdicts, true);
}

}  // namespace ryosen
