// The size of the window that tests of the user interface draw.
#pragma once

#include "ryosen/scene/view/size.h"

namespace ryosen::test {

inline constexpr Size window{1280, 720};
inline constexpr Size tall_window{1280, 1400};  // high enough for whole columns

}  // namespace ryosen::test
