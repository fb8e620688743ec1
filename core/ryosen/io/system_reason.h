// Bilingual texts for system errors on files.
#pragma once

#include "ryosen/base/message.h"

namespace ryosen {

// The meaning of an errno value and its remedy, as the end of a sentence: without capital and full stop. Unknown values
// get the system's message in both languages.
Text system_reason(int error);

// Said of a file to be read or written whose name has no letter.
Text empty_name();

}  // namespace ryosen
