// The edges of faces and the vertices at them, from where a pixel lies in its triangle.
in vec2 barycentric;
flat in float edge_bits;
in float size_here;  // of the triangles around, in pixels

uniform float pixel_scale;  // rendered pixels per pixel at display scale 1
uniform int wire;           // 0: the edges of faces are drawn
uniform int dots;           // 1: vertices are drawn

// How many rendered pixels away the sides of the triangle are, from corner k to k + 1 each; far for those that are no
// edges of the face.
vec3 side_distance_px() {
  vec3 weight = vec3(barycentric, 1.0 - barycentric.x - barycentric.y);
  vec2 gx = dFdx(barycentric), gy = dFdy(barycentric);
  vec3 dx = vec3(gx, -gx.x - gx.y), dy = vec3(gy, -gy.x - gy.y);
  vec3 distance_px = weight * inversesqrt(max(dx * dx + dy * dy, vec3(1e-20)));
  // Side k lies opposite of corner k + 2.
  uint bits = uint(edge_bits);
  return vec3((bits & 1u) == 0u ? 1e6 : distance_px.z, (bits & 2u) == 0u ? 1e6 : distance_px.x,
              (bits & 4u) == 0u ? 1e6 : distance_px.y);
}

// How much is left of what is drawn on triangles, where those around are as small as this to that. A single one among
// smaller ones keeps it where it is much larger, so that it leaves no scratches, nor gaps one that is seen from the side.
float left_at(float none_px, float all_px, float own_size_px) {
  return max(smoothstep(none_px, all_px, size_here), smoothstep(2.0 * all_px, 5.0 * all_px, own_size_px));
}

// How much of the pixel the wireframe covers. It fades where triangles get as small as a few pixels.
float wire_cover() {
  if (wire != 0) return 0.0;
  vec3 distance_px = side_distance_px();
  vec2 gx = dFdx(barycentric), gy = dFdy(barycentric);
  float nearest = min(min(distance_px.x, distance_px.y), distance_px.z) / pixel_scale;
  float size = inversesqrt(max(abs(gx.x * gy.y - gx.y * gy.x), 1e-20)) / pixel_scale;
  return clamp(1.1 - nearest, 0.0, 1.0) * left_at(2.0, 12.0, size);
}

// How much of the pixel the dots of the triangle's corners cover, each the part of its disc that lies in the triangle.
// They fade as the wireframe does, but earlier.
float dot_cover() {
  const float radius_px = 2.6;
  mat2 per_px = mat2(dFdx(barycentric), dFdy(barycentric));
  float area = abs(determinant(per_px));
  if (dots != 1 || area < 1e-12) return 0.0;
  mat2 px = inverse(per_px);
  float nearest = length(px * (barycentric - vec2(1.0, 0.0)));
  nearest = min(nearest, length(px * (barycentric - vec2(0.0, 1.0))));
  nearest = min(nearest, length(px * barycentric));
  float size = inversesqrt(area) / pixel_scale;
  return clamp(radius_px + 0.5 - nearest / pixel_scale, 0.0, 1.0) * left_at(7.0, 16.0, size);
}
