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
