// How different two colours look, also to those who do not see all of them.
#pragma once

#include "render/colour.h"

namespace ryosen::test {

// CIE L*a*b*, white D65.
struct Lab {
  double l, a, b;
};

enum class Sight { usual, deuteranopia, protanopia };

// An opaque colour as that sight has it [Machado09], at full severity.
Lab lab_as_seen(Rgba colour, Sight sight);

// CIEDE2000 with all weights 1 [Sharma05].
double ciede2000(const Lab& first, const Lab& second);

}  // namespace ryosen::test
