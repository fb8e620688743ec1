// The menus of the bar, in their order. What is in them is the window's.
#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

namespace ryosen {

struct MenuRow {
  std::string_view id;  // as the command `menu` says it
  std::string_view title_en, title_ja;
};

inline constexpr MenuRow menu_bar[] = {
    {"file", "File", "ファイル"}, {"edit", "Edit", "編集"}, {"select", "Select", "選択"},
    {"view", "View", "表示"},     {"add", "Add", "追加"},   {"help", "Help", "ヘルプ"},
};

// Null where there is none.
inline const MenuRow* find_menu(std::string_view id) {
  const auto at =
      std::find_if(std::begin(menu_bar), std::end(menu_bar), [&](const MenuRow& row) { return row.id == id; });
  return at == std::end(menu_bar) ? nullptr : at;
}

// "file|edit|..."
inline std::string menu_ids() {
  std::string ids;
  for (const MenuRow& row : menu_bar) ids.append(ids.empty() ? "" : "|").append(row.id);
  return ids;
}

}  // namespace ryosen
