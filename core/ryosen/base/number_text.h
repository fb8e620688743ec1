// Parses and prints numbers and positions.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace ryosen {

// Parses a finite number that spans the whole text.
std::optional<double> parse_double(std::string_view text);
// The shortest decimal that reads back as the same double.
std::string format_double(double value);

// Parses X,Y,Z; none if it is not three finite numbers.
std::optional<glm::dvec3> parse_place(std::string_view text);
std::string format_place(const glm::dvec3& place);

// A hash in 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace ryosen
