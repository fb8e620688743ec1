// Why the system did not do what was asked of a file, in both languages.
#pragma once

#include "core/base/message.h"

namespace ryosen {

// What an error number (errno) means and what helps against it, as the rest of a sentence: without a capital and without
// the stop. A number that is not known here gets the words of the system in both languages.
Text system_reason(int error);

}  // namespace ryosen
