#include "app/ui/texts.h"

#include <array>

namespace ryosen {

const char* text(UiText id, Language language) {
  static constexpr std::array<const char*, 2> rows[] = {
#define RYOSEN_TEXT(id, en, ja) {en, ja},
#include "app/ui/texts.def"
#undef RYOSEN_TEXT
  };
  return rows[static_cast<std::size_t>(id)][language == Language::japanese ? 1 : 0];
}

}  // namespace ryosen
