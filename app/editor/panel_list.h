// What the editor knows of the window's panels: their ids and titles, and where they lie. What is in them is the window's.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ryosen {

// In a column beside the view until it is hidden, or over the view, one at a time.
enum class PanelPlace { left, right, over };

struct PanelRow {
  std::string_view id;
  PanelPlace place;
  std::string_view title_en, title_ja;
};

// The lines of panels.def in their order, behind them what was added. Valid until another is added or taken away.
std::span<const PanelRow> panel_list();
const PanelRow* find_panel(std::string_view id);
// "tools, highlights, ...": what the command `panel` may name.
std::string panel_ids();

// One panel more for as long as this lives: for programs with panels of their own. The row's texts must live as long.
class ScopedPanel {
 public:
  explicit ScopedPanel(const PanelRow& row);
  ~ScopedPanel();
  ScopedPanel(const ScopedPanel&) = delete;
  ScopedPanel& operator=(const ScopedPanel&) = delete;

 private:
  std::string_view id_;
};

}  // namespace ryosen
