// What of the growth of the forms' work is drawn together.
#pragma once

#include <span>

#include "app/ui/log_plot.h"
#include "ryosen/base/message.h"
#include "ryosen/textbook/forms/growth/growth.h"

namespace ryosen {

enum class GrowthAxis { count, time };

// The curves of a kind, of queries those of one relation.
LogPlot growth_plot(std::span<const forms::GrowthCurve> curves, forms::GrowthOf of, forms::Relation relation,
                    GrowthAxis axis, Language language);

}  // namespace ryosen
