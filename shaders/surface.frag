#version 330 core
#include "wire.glsl"
#ifdef SMOOTH
smooth in vec3 lit;
#else
flat in vec3 lit;
#endif

#ifdef PAINTED
smooth in vec4 corner_paint;
flat in vec4 side_paint[3];
#ifdef SMOOTH
smooth in float paint_light;
#else
flat in float paint_light;
#endif
uniform int paints_sides;  // 1: the paint belongs to the sides of faces

// What the surface looks like under its paint, where it has some.
vec3 painted(vec3 bare) {
  vec3 away = side_distance_px();
  int side = away.x <= min(away.y, away.z) ? 0 : away.y <= away.z ? 1 : 2;
  vec4 paint = paints_sides == 1 ? side_paint[side] : corner_paint;
  return paint.a > 0.99 ? paint.rgb * paint_light : bare;
}
#endif

uniform vec3 wire_colour;  // linear
uniform float wire_strength;

layout(location = 0) out vec4 colour;

void main() {
#ifdef PAINTED
  vec3 base = painted(lit);
#else
  vec3 base = lit;
#endif
  vec3 wired = mix(base, wire_colour, wire_cover() * wire_strength);
  colour = vec4(sqrt(mix(wired, wire_colour, dot_cover())), 1.0);
}
