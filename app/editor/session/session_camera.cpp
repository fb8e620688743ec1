#include "app/editor/session/session_camera.h"

#include "app/editor/preferences/preference_values.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/player.h"

namespace ryosen {

Covered Framing::covered() const {
  Covered covered;
  if (view_.shows_axes) covered.corner = room_of_axes(view_.size, session_.preferences.size_scale());
  if (!session_.is_comparing()) {
    covered.left = view_.covered_px.x;
    covered.right = view_.covered_px.y;
  }
  if (session_.shown.player()) covered.above = caption_px(session_.preferences);
  return covered;
}

CoveredShares Framing::covered_shares() const { return shares_beside(covered(), view_.size); }

Camera Framing::of_all(const Camera& from) const {
  if (session_.shown.shows(ShownBy::step) && !session_.shown.player()->places_at_end.empty())
    return fitted_beside(covered(), from, session_.shown.player()->places_at_end, view_.size);
  const Findings* const against = session_.findings().against;
  if (against) return framing({&session_.mesh(), &against->mesh()}, from, view_.size, covered());
  return framing({&session_.mesh()}, from, view_.size, covered());
}

}  // namespace ryosen
