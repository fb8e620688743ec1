// The drawing context of the test program.
#pragma once

#include "render/context/context.h"

namespace ryosen {

// One OSMesa context for all tests, made on first use and current until the program ends. Fails the running test when
// the library is missing.
Context& test_context();

}  // namespace ryosen
