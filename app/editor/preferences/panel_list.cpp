#include "app/editor/preferences/panel_list.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace ryosen {

namespace {

std::vector<PanelRow>& panel_rows() {
  static std::vector<PanelRow> rows{
#define RYOSEN_PANEL(id, place, menu, opened_by, at_first, reads, en, ja, help_en, help_ja, ...) \
  {#id,                                                                                          \
   PanelPlace::place,                                                                            \
   en,                                                                                           \
   ja,                                                                                           \
   PanelMenu::menu,                                                                              \
   PanelOpener::opened_by,                                                                       \
   PanelAtFirst::at_first,                                                                       \
   PanelReads::reads,                                                                            \
   help_en,                                                                                      \
   help_ja __VA_OPT__(, ) __VA_ARGS__},
#include "app/editor/preferences/panels.def"
#undef RYOSEN_PANEL
  };
  return rows;
}

}  // namespace

std::span<const PanelRow> panel_list() { return panel_rows(); }

const PanelRow* find_panel(std::string_view id) { return find_row(panel_rows(), id); }

const PanelRow& panel_opened_by(PanelOpener opener) {
  const std::span<const PanelRow> rows = panel_list();
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const PanelRow& r) { return r.opened_by == opener; });
  assert(row != rows.end());
  return *row;
}

std::string panel_ids() { return joined_ids(panel_list(), ", "); }

ScopedPanel::ScopedPanel(const PanelRow& row) : id_(row.id) {
  assert(!find_panel(id_) && "every panel has an id of its own");
  panel_rows().push_back(row);
}

ScopedPanel::~ScopedPanel() {
  std::erase_if(panel_rows(), [&](const PanelRow& row) { return row.id == id_; });
}

}  // namespace ryosen
