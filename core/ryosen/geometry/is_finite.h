// Whether all coordinates are finite.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ryosen {

inline bool is_finite(const glm::dvec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }
inline bool is_finite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }
inline bool is_finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace ryosen
