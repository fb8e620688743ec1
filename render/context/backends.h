// The two headless backends, one function each.
#pragma once

#include <memory>
#include <string>

#include "render/context/context.h"
#include "render/context/library.h"
#include "ryosen/base/message.h"

namespace ryosen {

// The result of an attempt: a current context, or why there is none.
struct Attempt {
  std::unique_ptr<Context> context;
  std::string library;  // the file that was loaded, empty if none was found
  Text problem;
  bool lacks_memory = false;  // that is the problem
};

Attempt make_osmesa_context();
Attempt make_egl_context();

// Says of an attempt why `what` is not loaded.
void explain(Attempt& attempt, const LoadedLibrary& library, const std::string& what);

}  // namespace ryosen
