// Passes the paint of a triangle on to paint.glsl.
uniform usamplerBuffer corner_colours;  // by slot, sRGB in bytes: of the corners, or of the sides behind them
smooth out vec4 corner_paint;           // linear, and whether there is one
flat out vec4 side_paint[3];

vec4 paint_of(uint packed_colour) {
  vec4 bytes = vec4(uvec4(packed_colour, packed_colour >> 8u, packed_colour >> 16u, packed_colour >> 24u) & 0xffu);
  return vec4(bytes.rgb * bytes.rgb / 65025.0, bytes.a / 255.0);
}

void pass_paint(Corner corner) {
  uvec4 colours = texelFetch(corner_colours, corner.slot);
  for (int k = 0; k < 3; ++k) side_paint[k] = paint_of(colours[k]);
  corner_paint = side_paint[corner.number];
}
