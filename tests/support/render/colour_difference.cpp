#include "tests/support/render/colour_difference.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace ryosen::test {

namespace {

double linear_of(std::uint8_t byte) {
  const double c = byte / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// Rows times linear red, green and blue.
glm::dvec3 times(const double (&rows)[3][3], const glm::dvec3& v) {
  glm::dvec3 result;
  for (int i = 0; i < 3; ++i) result[i] = rows[i][0] * v.x + rows[i][1] * v.y + rows[i][2] * v.z;
  return result;
}

constexpr double without_green[3][3] = {
    {0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};
constexpr double without_red[3][3] = {
    {0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}};
constexpr double xyz_from_rgb[3][3] = {
    {0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}};

double sine(double degrees) { return std::sin(degrees * std::numbers::pi / 180); }
double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }
double hue_of(double a, double b) {
  const double degrees = std::atan2(b, a) * 180 / std::numbers::pi;
  return degrees < 0 ? degrees + 360 : degrees;
}
// Goes to 1 for colours that are far from grey.
double saturation(double chroma) {
  const double seventh = std::pow(chroma, 7);
  return std::sqrt(seventh / (seventh + std::pow(25.0, 7)));
}

}  // namespace

Lab lab_as_seen(Rgba colour, Sight sight) {
  glm::dvec3 rgb(linear_of(colour[0]), linear_of(colour[1]), linear_of(colour[2]));
  if (sight == Sight::deuteranopia) rgb = times(without_green, rgb);
  if (sight == Sight::protanopia) rgb = times(without_red, rgb);
  for (int i = 0; i < 3; ++i) rgb[i] = std::clamp(rgb[i], 0.0, 1.0);
  const glm::dvec3 xyz = times(xyz_from_rgb, rgb);
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const double x = f(xyz.x / 0.95047), y = f(xyz.y), z = f(xyz.z / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double ciede2000(const Lab& first, const Lab& second) {
  const double mean_chroma = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2;
  const double stretch = 1.5 - 0.5 * saturation(mean_chroma);
  const double a1 = stretch * first.a, a2 = stretch * second.a;
  const double c1 = std::hypot(a1, first.b), c2 = std::hypot(a2, second.b);
  const double h1 = hue_of(a1, first.b), h2 = hue_of(a2, second.b);
  const bool has_hues = c1 * c2 != 0;
  double turn = has_hues ? h2 - h1 : 0;
  if (turn > 180) turn -= 360;
  if (turn < -180) turn += 360;
  double hue = h1 + h2;
  if (has_hues && std::abs(h1 - h2) <= 180)
    hue /= 2;
  else if (has_hues)
    hue = (hue < 360 ? hue + 360 : hue - 360) / 2;
  const double lightness = (first.l + second.l) / 2 - 50, chroma = (c1 + c2) / 2;
  const double t =
      1 - 0.17 * cosine(hue - 30) + 0.24 * cosine(2 * hue) + 0.32 * cosine(3 * hue + 6) - 0.20 * cosine(4 * hue - 63);
  const double by_lightness =
      (second.l - first.l) / (1 + 0.015 * lightness * lightness / std::sqrt(20 + lightness * lightness));
  const double by_chroma = (c2 - c1) / (1 + 0.045 * chroma);
  const double by_hue = 2 * std::sqrt(c1 * c2) * sine(turn / 2) / (1 + 0.015 * chroma * t);
  const double blue = 30 * std::exp(-std::pow((hue - 275) / 25, 2));
  const double rotation = -sine(2 * blue) * 2 * saturation(chroma);
  return std::sqrt(by_lightness * by_lightness + by_chroma * by_chroma + by_hue * by_hue +
                   rotation * by_chroma * by_hue);
}

}  // namespace ryosen::test
