#version 330 core
// The faces that have a tint, drawn once more over the surface.
#include "mesh.glsl"
#include "light.glsl"

uniform usamplerBuffer face_tints;  // 0, or the number of its tint from 1 on
uniform vec4 tints[32];     // linear colour and strength
uniform int patterns[32];

SHADED out vec3 tint;  // linear colour
flat out float strength;
flat out int pattern;

void main() {
  Corner corner = read_corner();
  float grazing;
  bool seen_front;
  vec3 light = light_on(corner, grazing, seen_front);
  uint of_face = texelFetch(face_tints, int(corner.face)).r;
  int number = clamp(int(of_face) - 1, 0, 31);
  tint = tints[number].rgb * (0.35 + 0.65 * light);
  strength = tints[number].a;
  pattern = patterns[number];
  gl_Position = of_face == 0u ? nowhere : clip_place(corner);
}
