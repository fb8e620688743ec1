#version 330 core
#include "mesh.glsl"
#include "light.glsl"

out vec2 barycentric;
flat out vec4 lit;      // linear colour, then the edge bits
out vec3 lit_smoothly;  // the same colour, which goes over from corner to corner

void main() {
  Corner corner = read_corner();
  float grazing;
  bool seen_front;
  vec3 light = light_on(corner, grazing, seen_front);
  vec3 colour = (seen_front ? front_colour : back_colour) * light + rim_colour * grazing * grazing * grazing;
  lit = vec4(colour, float(corner.edge_bits));
  lit_smoothly = colour;
  barycentric = vec2(corner.number == 0 ? 1.0 : 0.0, corner.number == 1 ? 1.0 : 0.0);
  gl_Position = clip_place(corner);
}
