// What is said of a refused operator for which no script lines were found that make it legal.
#pragma once

#include "core/base/message.h"
#include "core/base/verdict.h"

namespace ryosen {

// That nothing ever helps, where a rule is of that kind; otherwise that the search, which is bounded, has found nothing,
// and what the table of rules names. Without a full stop.
Text without_remedy(const Verdict& verdict);

}  // namespace ryosen
