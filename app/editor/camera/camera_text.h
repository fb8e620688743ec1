// Text forms of cameras and pixels, for scripts and the command line.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "ryosen/base/message.h"
#include "ryosen/scene/view/camera.h"

namespace ryosen {

// {"eye":[x,y,z],"target":[x,y,z],"up":[x,y,z],"fov_y_deg":35,"ortho_height":null}; missing keys keep the value of
// `base`. None, with an error message, for anything else or a degenerate camera.
std::optional<Camera> camera_from_json(std::string_view json, const Camera& base, Text& error);

// "640,360", also with fractions.
std::optional<glm::dvec2> parse_pixel(std::string_view text);
std::string format_pixel(glm::dvec2 pixel);

}  // namespace ryosen
