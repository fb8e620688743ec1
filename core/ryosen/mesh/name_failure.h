// The failure about a name that means no one living element, the same for every command.
#pragma once

#include <utility>

#include "ryosen/base/result.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

// Usage with the code of what is wrong with the name, or `refused` where the element is gone.
inline Failure failure_of_name(NameError error, Text sentence) {
  if (error == NameError::deleted) return make_failure(ExitCode::refused, "refused", std::move(sentence));
  const Code code = error == NameError::never_existed ? Code("element_unknown")
                    : error == NameError::ambiguous   ? Code("name_ambiguous")
                                                      : Code("line_malformed");
  return make_failure(ExitCode::usage, code, std::move(sentence));
}

}  // namespace ryosen
