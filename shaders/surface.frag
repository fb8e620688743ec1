#version 330 core
#include "wire.glsl"
#ifdef SMOOTH
smooth in vec3 lit;
#else
flat in vec3 lit;
#endif

#ifdef PAINTED
#include "paint.glsl"
#ifdef SMOOTH
smooth in vec3 paint_light;
#else
flat in vec3 paint_light;
#endif
#endif

uniform vec3 wire_colour;  // linear
uniform float wire_strength;

layout(location = 0) out vec4 colour;

void main() {
#ifdef PAINTED
  vec4 paint = paint_here();
  vec3 base = paint.a > 0.99 ? paint.rgb * paint_light : lit;
#else
  vec3 base = lit;
#endif
  vec3 wired = mix(base, wire_colour, wire_cover() * wire_strength);
  colour = vec4(sqrt(mix(wired, wire_colour, dot_cover())), 1.0);
}
