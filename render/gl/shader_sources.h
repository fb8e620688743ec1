// The shaders of shaders/, embedded at build time.
#pragma once

#include <string_view>
#include <vector>

namespace ryosen {

// One file of shaders/ under its name there ("surface.vert"), its included files already in place.
struct ShaderSource {
  std::string_view name;
  std::string_view text;
};

const std::vector<ShaderSource>& shader_sources();

}  // namespace ryosen
