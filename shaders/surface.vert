#version 330 core
#include "mesh.glsl"
#include "light.glsl"

out vec2 barycentric;
SHADED out vec3 lit;  // linear colour
flat out float edge_bits;

void main() {
  Corner corner = read_corner();
  float grazing;
  bool seen_front;
  vec3 light = light_on(corner, grazing, seen_front);
  lit = (seen_front ? front_colour : back_colour) * light + rim_colour * grazing * grazing * grazing;
  edge_bits = float(corner.edge_bits);
  barycentric = vec2(corner.number == 0 ? 1.0 : 0.0, corner.number == 1 ? 1.0 : 0.0);
  gl_Position = clip_place(corner);
}
