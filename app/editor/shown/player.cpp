#include "app/editor/shown/player.h"

#include <atomic>

#include "app/editor/camera/view_state.h"
#include "app/editor/commands/text/outcomes.h"
#include "app/editor/session/session_camera.h"
#include "app/editor/shown/shown.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

std::uint64_t next_serial() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

}  // namespace

Player::Player() : serial_(next_serial()) {}

void Player::go_to(std::size_t position) {
  position_ = position;
  take_step();
}

void look_as_before(ViewState& view, Framing& framing, const Player& player) {
  if (!player.camera_before) return;
  view.camera = *player.camera_before;
  if (player.was_framed) framing.frame_all();
}

Text end_of(const Player& player) {
  const Text name = player.name();
  return {"The steps of '" + name.en + "' are left.", "「" + name.ja + "」の再生を終えました。"};
}

void begin_playing(const Document& document, ViewState& view, Framing& framing, Shown& shown,
                   const std::shared_ptr<Player>& player) {
  shown.begin(player);
  if (player->begins_with_nothing()) {
    if (document.mesh().live().vertices > 0) player->camera_before = view.camera;
    player->was_framed = framing.is_framed();
    shown.go_to_step(player->size());
    with_places_to_frame(document.mesh(), [&](std::span<const glm::dvec3> places) {
      player->places_at_end.assign(places.begin(), places.end());
    });
    framing.frame_all();
  } else if (framing.is_framed() && view.covered_px != glm::dvec2(0)) {
    framing.frame_all();
  }
  shown.go_to_step(0);
}

void end_playing(ViewState& view, Framing& framing, Shown& shown) {
  if (const std::shared_ptr<Player> player = shown.end_steps()) look_as_before(view, framing, *player);
}

Outcome leave_playing(ViewState& view, Framing& framing, Shown& shown) {
  Outcome outcome = done_with(end_of(*shown.player()));
  end_playing(view, framing, shown);
  return outcome;
}

}  // namespace ryosen
