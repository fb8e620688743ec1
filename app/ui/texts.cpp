#include "app/ui/texts.h"

namespace ryosen {

namespace {

struct TextRow {
  const char *en, *ja;
};
constexpr TextRow text_rows[] = {
#define RYOSEN_TEXT(id, en, ja) {en, ja},
#include "app/ui/texts.def"
#undef RYOSEN_TEXT
};

}  // namespace

const char* text(UiText id, Language language) {
  const TextRow& row = text_rows[static_cast<std::size_t>(id)];
  return language == Language::japanese ? row.ja : row.en;
}

}  // namespace ryosen
