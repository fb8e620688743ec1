#version 330 core
#include "pixel.glsl"
#include "wire.glsl"
#include "pattern.glsl"
#ifdef PAINTED
#include "paint.glsl"
#endif
flat in float film;
flat in float nearness;
flat in vec4 tint;
flat in int pattern;

// What is added to the ground, or taken from it.
uniform vec3 film_colour;
uniform vec3 line_colour;
uniform float takes_light;  // 1: taken

layout(location = 0) out vec4 colour;

void main() {
  float line = max(wire_cover(), dot_cover()) * nearness;
  float tinted = tint.a * pattern_share(pattern, picture_pixel() / pixel_scale);
  vec3 of_tint = takes_light > 0.5 ? 1.0 - tint.rgb : tint.rgb;
  vec3 of_film = film_colour;
#ifdef PAINTED
  vec4 paint = paint_here();
  if (paint.a > 0.99) of_film = 0.3 * (takes_light > 0.5 ? 1.0 - sqrt(paint.rgb) : sqrt(paint.rgb));
#endif
  vec3 layer = film * of_film + line * line_colour + 0.45 * tinted * of_tint;
  colour = vec4(layer, max(max(layer.r, layer.g), layer.b));
}
