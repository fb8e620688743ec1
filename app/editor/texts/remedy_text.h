// The text for a refused operator without a remedy.
#pragma once

#include "ryosen/base/message.h"
#include "ryosen/base/verdict.h"

namespace ryosen {

// Says that nothing can help, if a rule is of that kind; otherwise that the bounded search found nothing, with the
// general remedies of the rules. Without a full stop.
Text without_remedy(const Verdict& verdict);

}  // namespace ryosen
