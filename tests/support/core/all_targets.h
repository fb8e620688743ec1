// Every way in which a mesh can be written.
#pragma once

#include <vector>

#include "ryosen/io/formats.h"

namespace ryosen::test {

inline std::vector<WriteOptions> all_targets() {
  std::vector<WriteOptions> targets;
  for (const Format& format : formats()) {
    if (!format.write) continue;
    if (format.variants.empty()) targets.push_back({&format, Encoding::automatic});
    for (const FormatVariant& variant : format.variants) targets.push_back({&format, variant.encoding});
  }
  return targets;
}

}  // namespace ryosen::test
