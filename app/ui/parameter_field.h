// The field in which a value of an algorithm is typed or chosen.
#pragma once

#include <string>
#include <string_view>

#include "app/ui/panels.h"

namespace ryosen {

// What Enter does at a list or a check box; the space bar opens or ticks it in any case.
enum class EnterAt { opens, runs };

// Draws it as its row describes it, as wide as the next item; `text` is what it holds. True when Enter was pressed in a
// field of text, or at another one where that `runs`.
bool draw_parameter_field(PanelContext& context, const ParameterRow& row, std::string& text,
                          EnterAt enter = EnterAt::opens);

}  // namespace ryosen
