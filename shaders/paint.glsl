// What a pixel of the surface is painted with. Behind wire.glsl.
smooth in vec4 corner_paint;
flat in vec4 side_paint[3];
uniform int paints_sides;  // 1: the paint belongs to the sides of faces

// Linear; alpha is above 0.99 where there is paint.
vec4 paint_here() {
  if (paints_sides != 1) return corner_paint;
  vec3 away = side_distance_px();
  return side_paint[away.x <= min(away.y, away.z) ? 0 : away.y <= away.z ? 1 : 2];
}
