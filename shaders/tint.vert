#version 330 core
// The faces that carry flags, drawn once more over the surface.
#include "mesh.glsl"
#include "light.glsl"

uniform vec4 tints[7];  // by bit of the flags: linear colour and strength

flat out vec4 tint;
flat out int bit;

void main() {
  Corner corner = read_corner();
  float grazing;
  bool seen_front;
  vec3 light = light_on(corner, grazing, seen_front);
  bit = 0;
  for (int i = 0; i < 7; ++i) {
    if ((corner.flags & (1u << uint(i))) != 0u) bit = i;
  }
  tint = vec4(tints[bit].rgb * (0.35 + 0.65 * light), tints[bit].a);
  gl_Position = corner.flags == 0u ? nowhere : clip_place(corner);
}
