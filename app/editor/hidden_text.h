// How much is hidden, as a sentence.
#pragma once

#include "core/base/message.h"
#include "core/pick/hidden_elements.h"

namespace ryosen {

Text hidden_text(const HiddenElements& hidden);

}  // namespace ryosen
