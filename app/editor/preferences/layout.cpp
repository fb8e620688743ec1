#include "app/editor/preferences/layout.h"

#include <algorithm>

namespace ryosen {

std::string Layout::first_open_panel() {
  for (const PanelRow& row : panel_list())
    if (row.place == PanelPlace::over && row.shown_at_first()) return std::string(row.id);
  return {};
}

bool Layout::is_shown(const PanelRow& panel) const {
  if (panel.place == PanelPlace::over) return open_panel == panel.id;
  return panel.shown_at_first() != switched.contains(std::string(panel.id));
}

void Layout::show(const PanelRow& panel, bool on) {
  const std::string id(panel.id);
  const bool is_over = panel.place == PanelPlace::over;
  if (on && !is_over) wanted = id;
  if (is_shown(panel) == on) return;
  if (is_over) {
    open_panel = on ? id : "";
    return;
  }
  if (on != panel.shown_at_first())
    switched.insert(id);
  else
    switched.erase(id);
  if (!on && flyout == id) flyout.clear();
}

PanelPlace Layout::side_of(const PanelRow& panel) const {
  if (!moved.contains(std::string(panel.id))) return panel.place;
  return panel.place == PanelPlace::left ? PanelPlace::right : PanelPlace::left;
}

void Layout::put(const PanelRow& panel, PanelPlace side) {
  if (side == panel.place)
    moved.erase(std::string(panel.id));
  else
    moved.insert(std::string(panel.id));
}

std::size_t Layout::count(PanelPlace side) const {
  const auto rows = panel_list();
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](const PanelRow& row) {
    return row.place != PanelPlace::over && side_of(row) == side && is_shown(row);
  }));
}

std::vector<std::string> Layout::commands() const {
  std::vector<std::string> lines;
  const Layout at_first;
  for (const PanelRow& row : panel_list()) {
    if (row.place == PanelPlace::over) continue;
    const std::string panel = "panel " + std::string(row.id);
    if (is_shown(row) != row.shown_at_first() && row.is_shown_again())
      lines.push_back(panel + (is_shown(row) ? " on" : " off"));
    if (is_folded(row)) lines.push_back(panel + " fold");
    if (side_of(row) != row.place) lines.push_back(panel + (side_of(row) == PanelPlace::left ? " left" : " right"));
  }
  if (left_px != at_first.left_px) lines.push_back("columns left " + std::to_string(left_px));
  if (right_px != at_first.right_px) lines.push_back("columns right " + std::to_string(right_px));
  return lines;
}

}  // namespace ryosen
