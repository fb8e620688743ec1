#version 330 core
#include "mesh.glsl"
#include "light.glsl"

out vec2 barycentric;
SHADED out vec3 lit;  // linear colour
flat out float edge_bits;
#ifdef PAINTED
uniform usamplerBuffer corner_colours;  // by slot, sRGB in bytes: of the corners, or of the sides behind them
smooth out vec4 corner_paint;           // linear, and whether there is one
flat out vec4 side_paint[3];
SHADED out float paint_light;

vec4 paint_of(uint packed_colour) {
  vec4 bytes = vec4(uvec4(packed_colour, packed_colour >> 8u, packed_colour >> 16u, packed_colour >> 24u) & 0xffu);
  return vec4(bytes.rgb * bytes.rgb / 65025.0, bytes.a / 255.0);
}
#endif

void main() {
  Corner corner = read_corner();
  float grazing;
  bool seen_front;
  vec3 light = light_on(corner, grazing, seen_front);
  lit = (seen_front ? front_colour : back_colour) * light + rim_colour * grazing * grazing * grazing;
  edge_bits = float(corner.edge_bits);
  barycentric = vec2(corner.number == 0 ? 1.0 : 0.0, corner.number == 1 ? 1.0 : 0.0);
#ifdef PAINTED
  uvec4 colours = texelFetch(corner_colours, corner.slot);
  for (int k = 0; k < 3; ++k) side_paint[k] = paint_of(colours[k]);
  corner_paint = side_paint[corner.number];
  paint_light = min(0.6 + 0.4 * dot(light, vec3(0.3333)), 1.0);  // little, so that colours stay those of the legend
#endif
  gl_Position = clip_place(corner);
}
