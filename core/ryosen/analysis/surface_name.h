// The name of a connected surface by the classification theorem.
#pragma once

#include <optional>

#include "ryosen/analysis/figures.h"
#include "ryosen/base/message.h"

namespace ryosen {

// "sphere", "torus", "Moebius strip", "Klein bottle", ..., else the numbers of handles or crosscaps and of boundary
// loops. None if the figures are not those of one manifold component.
std::optional<Text> surface_name(const Figures& figures);

}  // namespace ryosen
