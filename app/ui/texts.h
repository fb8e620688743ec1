// UI texts in both languages that several panels use: their rows are in texts.def. Commands, operators, rules, keys and
// problems have their own; what only one panel says stands there, by PanelContext::text(en, ja).
#pragma once

#include "ryosen/base/message.h"

namespace ryosen {

enum class UiText {
#define RYOSEN_TEXT(id, en, ja) id,
#include "app/ui/texts.def"
#undef RYOSEN_TEXT
};

// Never null; static storage.
const char* text(UiText id, Language language);

}  // namespace ryosen
