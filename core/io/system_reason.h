// Bilingual texts for system errors on files.
#pragma once

#include "core/base/message.h"

namespace ryosen {

// The meaning of an errno value and its remedy, as the end of a sentence: without capital and full stop. Unknown values
// get the system's message in both languages.
Text system_reason(int error);

}  // namespace ryosen
