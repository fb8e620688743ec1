#include "tests/support/render/context.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

namespace ryosen {

Context& test_context() {
  static std::unique_ptr<Context> context = [] {
    Result<std::unique_ptr<Context>> made = make_headless_context(Backend::osmesa);
    if (!made) {
      ADD_FAILURE() << made.failure().message.text.en;
      std::exit(1);
    }
    return std::move(*made);
  }();
  return *context;
}

}  // namespace ryosen

#if defined(__SANITIZE_ADDRESS__)
// What the software renderer allocates once and never frees.
extern "C" const char* __lsan_default_suppressions();
const char* __lsan_default_suppressions() { return "leak:libOSMesa.so\nleak:libEGL.so\nleak:swrast_dri.so\n"; }
#endif
