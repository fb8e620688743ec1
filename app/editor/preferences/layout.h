// How the panels lie beside and over the view: what the commands `panel`, `columns`, `menu` and `values` change.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "app/editor/preferences/panel_list.h"

namespace ryosen {

// How wide a column may be, in pixels at scale 1.
inline constexpr int least_column_px = 200, most_column_px = 640;

struct Layout {
  // Ids of panels.
  std::set<std::string> switched;  // shown where their rows say hidden, or hidden where they say shown
  std::set<std::string> folded;    // to their headers
  std::set<std::string> moved;     // to the other side than their rows say
  std::string flyout;              // of tabs, the one that is open over the view; empty for none
  std::string wanted;              // somebody asked for this one just now: its column scrolls to it; empty for none
  // Of the columns, at scale 1.
  int left_px = 240, right_px = 292;
  std::string open_panel = first_open_panel();  // the one that lies over the view; empty for none
  const MenuRow* asked_menu = nullptr;          // the window opens it for the keyboard in its next frame
  // The ids of the algorithm or the operator whose values the panel of values asks for: one of them is empty.
  std::string asked_algorithm, asked_operator;

  bool is_shown(const PanelRow& panel) const;
  // One over the view takes the place of the one that was open.
  void show(const PanelRow& panel, bool on);
  PanelPlace side_of(const PanelRow& panel) const;
  void put(const PanelRow& panel, PanelPlace side);
  bool is_folded(const PanelRow& panel) const { return folded.contains(std::string(panel.id)); }
  // Of the left or the right column.
  int& width_px(PanelPlace side) { return side == PanelPlace::left ? left_px : right_px; }
  int width_px(PanelPlace side) const { return side == PanelPlace::left ? left_px : right_px; }
  // Panels shown on a side.
  std::size_t count(PanelPlace side) const;
  bool is_empty(PanelPlace side) const { return count(side) == 0; }

  // The commands that bring it about, beginning with a layout as at first. What is open over the view is not kept.
  std::vector<std::string> commands() const;

 private:
  static std::string first_open_panel();
};

}  // namespace ryosen
