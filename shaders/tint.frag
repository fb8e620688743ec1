#version 330 core
#include "pixel.glsl"
#include "pattern.glsl"
#ifdef SMOOTH
smooth in vec3 tint;
#else
flat in vec3 tint;
#endif
flat in float strength;
flat in int pattern;

uniform float pixel_scale;  // rendered pixels per pixel at display scale 1

layout(location = 0) out vec4 colour;

void main() {
  vec2 at = picture_pixel() / pixel_scale;
  float covered = strength * pattern_share(pattern, at);
  colour = vec4(sqrt(tint) * covered * pattern_light(pattern, at), covered);
}
