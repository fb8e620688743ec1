// Equal values of corners made one: what operators know a chart of values by.
#pragma once

#include "ryosen/mesh/edit.h"

namespace ryosen {

// Corners with the same value in two places of a pool refer to the first of them. O(corners).
void share_equal_values(Edit& edit);

}  // namespace ryosen
