// Each figure, table, problem and listing of the source texts, and where in the window it is found; or why it is not.
#pragma once

#include <span>
#include <string_view>

namespace ryosen {

struct TextPlace {
  std::string_view text;                // "000"
  std::string_view place_en, place_ja;  // what stands there
  std::string_view lines;               // that show it, separated by "; ", in a new window; empty for none
  std::string_view where_en, where_ja;  // where to look then; without lines how else, or why it is not there
};

// In the order of the texts.
std::span<const TextPlace> text_places();

}  // namespace ryosen
