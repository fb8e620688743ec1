// The shaders of shaders/, embedded at build time.
#pragma once

#include <string_view>
#include <vector>

namespace ryosen {

// A file of shaders/ by name ("surface.vert"), with includes expanded.
struct ShaderSource {
  std::string_view name;
  std::string_view text;
};

const std::vector<ShaderSource>& shader_sources();

}  // namespace ryosen
