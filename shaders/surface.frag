#version 330 core
#include "wire.glsl"
#ifdef SMOOTH
smooth in vec3 lit;
#else
flat in vec3 lit;
#endif

uniform vec3 wire_colour;  // linear
uniform float wire_strength;

layout(location = 0) out vec4 colour;

void main() {
  vec3 wired = mix(lit, wire_colour, wire_cover() * wire_strength);
  colour = vec4(sqrt(mix(wired, wire_colour, dot_cover())), 1.0);
}
