// The field in which a value of an algorithm is typed or chosen.
#pragma once

#include <string>

#include "app/ui/panels.h"

namespace ryosen {

// Draws it as its row describes it, as wide as the next item; `text` is what it holds. True when Enter was pressed in a
// field of text.
bool draw_parameter_field(PanelContext& context, const ParameterRow& row, std::string& text);

}  // namespace ryosen
