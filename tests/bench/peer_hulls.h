// The convex hulls of Qhull and CGAL behind plain functions. Only benchmarks use them.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

namespace ryosen::bench {

// The number of extreme points as the peer finds them; 0 where it gives up.
std::size_t qhull_vertices(std::span<const glm::dvec3> points);
std::size_t cgal_vertices(std::span<const glm::dvec3> points);

}  // namespace ryosen::bench
