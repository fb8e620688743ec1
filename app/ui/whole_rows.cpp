#include "app/ui/whole_rows.h"

#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace ryosen {

void WholeRows::begin(const char* name, float room) {
  constexpr float nearly = 0.5f;
  const bool goes_to_top = std::exchange(goes_to_top_, false);
  if (goes_to_top) first_ = 0;
  bottom_ = ImGui::GetCursorPosY() + room;
  const bool scrolls = places_.size() > 1 && height() > room;
  float shown = room;
  if (scrolls) {
    const float end = *std::prev(std::upper_bound(places_.begin(), places_.end(), first_ + room + nearly));
    if (end > first_) shown = end - first_;
  }
  is_seen_ = ImGui::BeginChild(name, {0, shown}, false, ImGuiWindowFlags_NavFlattened);
  coming_.clear();
  if (!scrolls) first_ = 0;
  if (goes_to_top) ImGui::SetScrollY(0);
  if (goes_to_top || !scrolls) return;
  // On to the next row in the direction in which it was scrolled, no further than to where all others fit.
  const float now = ImGui::GetScrollY();
  const auto last =
      std::min(std::lower_bound(places_.begin(), places_.end(), height() - room - nearly), std::prev(places_.end(), 2));
  const auto next = now < first_ ? std::prev(std::upper_bound(places_.begin(), places_.end(), std::max(now, 0.f)))
                                 : std::lower_bound(places_.begin(), places_.end(), now - nearly);
  first_ = *std::min(next, last);
  if (now != first_) ImGui::SetScrollY(first_);
}

void WholeRows::row() {
  coming_.push_back(coming_.empty() ? 0 : ImGui::GetCursorPosY() - ImGui::GetStyle().CellPadding.y);
}

void WholeRows::row_of_text() { coming_.push_back(coming_.empty() ? 0 : ImGui::GetCursorPosY()); }

void WholeRows::end() {
  if (!coming_.empty()) coming_.push_back(ImGui::GetCursorPosY());
  ImGui::Dummy({0, 0});  // to the whole pitch of the last row, so that it can be scrolled to
  ImGui::EndChild();
  ImGui::SetCursorPosY(bottom_);
  if (is_seen_) places_ = coming_;
}

}  // namespace ryosen
