#version 330 core
// The surface as a film that one sees through.
#include "mesh.glsl"
#include "light.glsl"
#include "wire_out.glsl"

uniform usamplerBuffer face_tints;  // 0, or the number of its tint from 1 on
uniform vec4 tints[32];             // colour and strength
uniform int patterns[32];

#ifdef PAINTED
#include "paint_out.glsl"
#endif
flat out float film;      // how thick it is for the eye
flat out float nearness;  // of its edges: those on the far side are fainter
flat out vec4 tint;       // colour and strength
flat out int pattern;

void main() {
  Corner corner = read_corner();
  vec3 along = corner.places[1] - corner.places[0], across = corner.places[2] - corner.places[0];
  vec3 normal = mat3(view_from_buffer) * cross(along, across);
  normal /= max(length(normal), 1e-30);
  bool seen_front = facing_eye(normal, corner.places[2]) > 0.0;
  float grazing = 1.0 - abs(normal.z);  // the same all over a plane
  film = 0.4 + 0.9 * grazing * grazing;
  nearness = seen_front ? 1.0 : 0.6;
  uint of_face = texelFetch(face_tints, int(corner.face)).r;
  int number = clamp(int(of_face) - 1, 0, 31);
  tint = of_face == 0u ? vec4(0.0) : tints[number];
  pattern = patterns[number];
  pass_wire(corner);
#ifdef PAINTED
  pass_paint(corner);
#endif
  gl_Position = clip_place(corner);
}
