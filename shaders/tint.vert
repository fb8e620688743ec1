#version 330 core
// The faces that have a tint, drawn once more over the surface.
#include "mesh.glsl"
#include "light.glsl"

uniform vec4 tints[32];     // linear colour and strength
uniform int patterns[32];

flat out vec4 tint;
out vec3 tint_smoothly;  // the same colour, which goes over from corner to corner
flat out int pattern;

void main() {
  Corner corner = read_corner();
  float grazing;
  bool seen_front;
  vec3 light = light_on(corner, grazing, seen_front);
  int number = clamp(int(corner.tint) - 1, 0, 31);
  tint = vec4(tints[number].rgb * (0.35 + 0.65 * light), tints[number].a);
  tint_smoothly = tint.rgb;
  pattern = patterns[number];
  gl_Position = corner.tint == 0u ? nowhere : clip_place(corner);
}
