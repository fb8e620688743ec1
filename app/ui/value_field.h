// A field for a value, as the row of its parameter describes it.
#pragma once

#include <string>

#include "app/ui/panels.h"
#include "core/algo/parameters.h"

namespace ryosen {

// Shows and changes the value as it is written. True when Enter was pressed in a field of text.
bool value_field(PanelContext& context, const ParameterRow& row, std::string& text);

}  // namespace ryosen
