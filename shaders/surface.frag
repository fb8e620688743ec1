#version 330 core
// Flat shading by two lights that move with the eye, the wireframe, and the tints of the faces' flags.
in vec3 view_position;
in vec2 barycentric;
flat in uint edge_bits;
flat in uint flags;

uniform vec3 front_colour;  // all colours linear
uniform vec3 back_colour;
uniform vec3 key_colour;
uniform vec3 fill_colour;
uniform vec3 rim_colour;
uniform vec3 wire_colour;
uniform float wire_strength;
uniform float pixel_scale;  // rendered pixels per pixel of the picture
uniform float perspective;  // 1, or 0 when all rays are parallel
uniform vec4 tints[7];      // by bit of the flags

layout(location = 0) out vec4 colour;

const vec3 key_direction = normalize(vec3(-0.45, 0.65, 0.62));
const vec3 fill_direction = normalize(vec3(0.75, 0.05, 0.55));

// How much a pixel belongs to the pattern that goes with a bit of the flags: a sign other than the colour.
float pattern(int bit) {
  vec2 p = gl_FragCoord.xy / pixel_scale;
  float rising = step(0.5, fract((p.x + p.y) / 10.0));
  float falling = step(0.5, fract((p.x - p.y) / 10.0));
  if (bit == 0) return 0.65 + 0.35 * rising;                             // selected: stripes rising to the left
  if (bit == 3) return 0.55 + 0.45 * falling;                            // refused: stripes the other way
  if (bit == 4) return 0.5 + 0.5 * abs(rising - falling);                // duplicate: squares on a corner
  if (bit == 5) return 0.5 + 0.5 * step(0.5, fract(p.y / 6.0));          // degenerate: level stripes
  if (bit == 6) return 0.5 + 0.5 * step(0.5, fract(p.x / 6.0));          // misoriented: upright stripes
  return 1.0;
}

vec3 tinted(vec3 base) {
  for (int bit = 0; bit < 7; ++bit) {
    if ((flags & (1u << uint(bit))) != 0u) base = mix(base, tints[bit].rgb, tints[bit].a * pattern(bit));
  }
  return base;
}

// How much of the pixel the wireframe covers. It fades where triangles get as small as a few pixels.
float wire() {
  vec3 weight = vec3(barycentric, 1.0 - barycentric.x - barycentric.y);
  vec2 gx = dFdx(barycentric), gy = dFdy(barycentric);
  vec3 dx = vec3(gx, -gx.x - gx.y), dy = vec3(gy, -gy.x - gy.y);
  vec3 distance_px = weight * inversesqrt(max(dx * dx + dy * dy, vec3(1e-20)));
  // Side k runs from corner k to k + 1, opposite of corner k + 2.
  if ((edge_bits & 1u) == 0u) distance_px.z = 1e6;
  if ((edge_bits & 2u) == 0u) distance_px.x = 1e6;
  if ((edge_bits & 4u) == 0u) distance_px.y = 1e6;
  float nearest = min(min(distance_px.x, distance_px.y), distance_px.z) / pixel_scale;
  float size = inversesqrt(max(abs(gx.x * gy.y - gx.y * gy.x), 1e-20)) / pixel_scale;
  return clamp(1.1 - nearest, 0.0, 1.0) * smoothstep(2.0, 14.0, size);
}

void main() {
  vec3 normal = normalize(cross(dFdx(view_position), dFdy(view_position)));
  vec3 to_eye = normalize(mix(vec3(0.0, 0.0, 1.0), -view_position, perspective));
  vec3 base = tinted(gl_FrontFacing ? front_colour : back_colour);
  float key = max(dot(normal, key_direction), 0.0);
  float fill = max(dot(normal, fill_direction), 0.0);
  float sky = 0.5 + 0.5 * normal.y;
  float grazing = 1.0 - clamp(dot(normal, to_eye), 0.0, 1.0);
  grazing *= grazing * grazing;
  vec3 light = key * key_colour + fill * fill_colour * 0.35 + mix(vec3(0.055), vec3(0.15), sky);
  vec3 lit = base * light + rim_colour * grazing * 0.25;
  lit = mix(lit, wire_colour, wire() * wire_strength);
  colour = vec4(sqrt(lit), 1.0);
}
