#version 330 core
// Lines, points and ghost triangles. Vertex number n of a draw is corner n % 6 of the two triangles of element number
// n / 6 of a list.
uniform samplerBuffer elements;  // four texels each, see OverlayElement
uniform usamplerBuffer element_numbers;  // of those that are drawn, in their order
uniform mat4 view_from_buffer;
uniform mat4 clip_from_view;
uniform vec2 size_px;
uniform float pixel_scale;      // rendered pixels per pixel at display scale 1
uniform float perspective;      // 1, or 0 when all rays are parallel
uniform float units_per_pixel;  // in view space, at distance 1 in perspective
uniform float near_distance;
uniform vec4 clip_plane;        // in the space of the elements: what is kept is where it is above 0
uniform float hidden_pass;      // 1 while drawing what the surface hides, else 0

flat out vec4 colour;
flat out vec4 places;    // of the two ends in rendered pixels
flat out vec3 measures;  // half the width or the radius in rendered pixels, kind, style

const int kind_ghost = 0, kind_line = 1, kind_arrow = 2, kind_point = 3;
const int style_bits = 3, thin_flag = 4, rim_flag = 8;  // of lines
const int fade_flag = 8;  // of points
const vec4 nowhere = vec4(2.0, 2.0, 2.0, 1.0);

vec3 view_place(vec3 place) { return (view_from_buffer * vec4(place, 1.0)).xyz; }

// Moves a place towards the eye, so that what lies on the surface is not hidden by it; the pixel stays the same.
vec3 lifted(vec3 place, float pixels) {
  float shift = pixels * pixel_scale * units_per_pixel;
  return perspective > 0.5 ? place * max(1.0 - shift - 1e-5, 0.5) : place + vec3(0.0, 0.0, shift);
}

// What was lifted before the near plane is put on it.
vec4 clip_from(vec3 place) {
  vec4 clip = clip_from_view * vec4(place, 1.0);
  clip.z = max(clip.z, -clip.w);
  return clip;
}

// Pixel, and the depth from -1 to 1.
vec3 on_screen(vec3 place) {
  vec4 clip = clip_from(place);
  return vec3((clip.xy / clip.w * 0.5 + 0.5) * size_px, clip.z / clip.w);
}

vec4 clip_place(vec2 pixel, float depth) { return vec4(pixel / size_px * 2.0 - 1.0, depth, 1.0); }

vec4 ghost(vec4 texel[3], int corner) {
  vec3 a = view_place(texel[0].xyz), b = view_place(texel[1].xyz), c = view_place(texel[2].xyz);
  vec3 normal = cross(b - a, c - a);
  colour.rgb *= 0.7 + 0.3 * abs(normal.z) / max(length(normal), 1e-30);
  measures = vec3(0.0, float(kind_ghost), 0.0);
  vec3 place = corner == 0 ? a : corner == 1 ? b : c;
  return corner > 2 ? nowhere : clip_from(lifted(place, 1.0));
}

vec4 line(vec3 from, vec3 to, float width, int kind, int corner) {
  vec3 a = view_place(from), b = view_place(to);
  vec2 kept = vec2(dot(clip_plane, vec4(from, 1.0)), dot(clip_plane, vec4(to, 1.0)));
  float limit = -near_distance * 1.0001;
  if (perspective > 0.5 && (a.z > limit || b.z > limit)) {
    if (a.z > limit && b.z > limit) return nowhere;
    float share = (limit - a.z) / (b.z - a.z);
    vec3 cut = mix(a, b, share);
    float kept_there = mix(kept.x, kept.y, share);
    if (a.z > limit) a = cut, kept.x = kept_there; else b = cut, kept.y = kept_there;
  }
  if (perspective > 0.5) kept /= vec2(-a.z, -b.z);  // what is linear on the screen, as places are there
  float half_width = 0.5 * width * pixel_scale;
  int code = int(measures.z);
  float reach = (kind == kind_arrow ? 4.0 * half_width + 3.0 * pixel_scale : half_width) + 1.0;
  // The head of an arrow reaches far to both sides at one depth: on a steep face the surface would hide half of it.
  if ((code & rim_flag) != 0) reach += pixel_scale;
  float lift = 2.0 + 0.5 * width + (kind == kind_arrow ? reach / pixel_scale : 0.0);
  vec3 pa = on_screen(lifted(a, lift)), pb = on_screen(lifted(b, lift));
  vec2 along = pb.xy - pa.xy;
  float length_px = max(length(along), 1e-4);
  measures.z = float(code & (style_bits | rim_flag));
  if ((code & thin_flag) != 0) {
    measures.x = min(half_width, max(0.17 * length_px, 0.5 * pixel_scale));
    reach -= half_width - measures.x;
  }
  along = length_px > 1e-4 ? along / length_px : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  bool at_end = corner == 1 || corner == 2 || corner == 4;
  float side = corner == 0 || corner == 1 || corner == 3 ? -1.0 : 1.0;
  vec3 end = at_end ? pb : pa;
  places = vec4(pa.xy, pb.xy);
  float kept_beyond = (kept.y - kept.x) / length_px * reach;
  gl_ClipDistance[0] = at_end ? kept.y + kept_beyond : kept.x - kept_beyond;
  return clip_place(end.xy + across * side * reach + along * (at_end ? reach : -reach), end.z);
}

// A point shrinks to about a third of its room in mesh space, but not out of sight, unless it fades as the dots of the
// surface do.
float radius_within(float radius, float room, vec3 place, bool fades) {
  float distance = perspective > 0.5 ? -place.z : 1.0;
  float room_px = room / (units_per_pixel * pixel_scale * max(distance, 1e-9));
  if (fades) return radius * smoothstep(7.0, 16.0, room_px);
  return room > 0.0 ? clamp(0.3 * room_px, min(1.5, radius), radius) : radius;
}

vec4 point(vec3 at, float radius, int corner) {
  vec3 place = view_place(at);
  if (perspective > 0.5 && place.z > -near_distance) return nowhere;
  vec3 p = on_screen(lifted(place, 2.0 + 0.7 * radius));
  float reach = (radius + 2.0) * pixel_scale + 1.0;
  float x = corner == 1 || corner == 2 || corner == 4 ? 1.0 : -1.0;
  float y = corner == 0 || corner == 1 || corner == 3 ? -1.0 : 1.0;
  places = vec4(p.xy, p.xy);
  return clip_place(p.xy + reach * vec2(x, y), p.z);
}

void main() {
  int listed = gl_VertexID / 6;
  int corner = gl_VertexID - 6 * listed;
  int element = int(texelFetch(element_numbers, listed).r);
  vec4 texel[3];
  for (int i = 0; i < 3; ++i) texel[i] = texelFetch(elements, 4 * element + i);
  colour = texelFetch(elements, 4 * element + 3);
  int kind = int(texel[2].w) & 3;
  float size = texel[0].w, hidden = texel[1].w;
  measures = vec3(0.5 * size * pixel_scale, float(kind), floor(texel[2].w / 4.0));
  places = vec4(0.0);
  vec3 place = kind != kind_ghost ? texel[0].xyz : texel[min(corner, 2)].xyz;
  gl_ClipDistance[0] = dot(clip_plane, vec4(place, 1.0));  // of a line by `line`
  if (kind == kind_ghost) {
    gl_Position = ghost(texel, corner);
  } else if (kind == kind_point) {
    int shape = int(measures.z);
    bool fades = (shape & fade_flag) != 0;
    measures.z = float(shape & (fade_flag - 1));
    size = radius_within(size, length(texel[1].xyz - texel[0].xyz), view_place(texel[0].xyz), fades);
    measures.x = size * pixel_scale;
    gl_Position = size > 0.0 ? point(texel[0].xyz, size, corner) : nowhere;
  } else {
    gl_Position = line(texel[0].xyz, texel[1].xyz, size, kind, corner);
  }
  if (hidden_pass > 0.5) {
    colour.a *= hidden;
    if (hidden <= 0.0) gl_Position = nowhere;
  }
}
