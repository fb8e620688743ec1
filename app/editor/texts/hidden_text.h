// How much is hidden, as a sentence.
#pragma once

#include "ryosen/base/message.h"
#include "ryosen/scene/pick/hidden_elements.h"

namespace ryosen {

Text hidden_text(const HiddenElements& hidden);

}  // namespace ryosen
