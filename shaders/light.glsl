// Light of three sources that move with the eye, on a surface seen from either side. Colours are linear.
// With SMOOTH the colour goes over from corner to corner; without, a triangle looks like its last corner, and alike all
// triangles of a plane do.
#ifdef SMOOTH
#define SHADED smooth
uniform usamplerBuffer corner_normals;  // by slot, packed as in ryosen/scene/view/packed_normal.h
#else
#define SHADED flat
#endif
uniform mat4 view_from_buffer;          // moves, turns and scales evenly
uniform float perspective;              // 1, or 0 when all rays are parallel
uniform vec3 key_colour;
uniform vec3 fill_colour;
uniform vec3 rim_colour;
uniform vec3 front_colour;
uniform vec3 back_colour;

const vec3 key_direction = normalize(vec3(-0.42, 0.60, 0.68));
const vec3 fill_direction = normalize(vec3(0.80, -0.10, 0.45));

// How much the normal of a surface points to the eye, which sees it at this place.
float facing_eye(vec3 normal, vec3 place) {
  vec3 to_eye = -normalize((view_from_buffer * vec4(place, 1.0)).xyz);
  return dot(normal, mix(vec3(0.0, 0.0, 1.0), to_eye, perspective));
}

#ifdef SMOOTH
// The normal of the surface at the corner; that of its triangle where there is none.
vec3 corner_normal(Corner corner, vec3 of_triangle) {
  uvec4 all = texelFetch(corner_normals, corner.slot);
  uint packed_normal = corner.number == 0 ? all.x : corner.number == 1 ? all.y : all.z;
  vec2 side = (vec2(packed_normal & 0xffffu, packed_normal >> 16u) - 32768.0) / 32767.0;
  vec3 normal = vec3(side, 1.0 - abs(side.x) - abs(side.y));
  float fold = max(-normal.z, 0.0);
  normal.xy -= vec2(normal.x < 0.0 ? -fold : fold, normal.y < 0.0 ? -fold : fold);
  return packed_normal == 0u ? of_triangle : normalize(mat3(view_from_buffer) * normal);
}
#endif

// What it would look like if it were white; seen_front says which side the eye sees.
vec3 light_on(Corner corner, out float grazing, out bool seen_front) {
  vec3 along = corner.places[1] - corner.places[0], across = corner.places[2] - corner.places[0];
  vec3 normal = normalize(mat3(view_from_buffer) * cross(along, across));
  vec3 place = corner.places[2];
  seen_front = facing_eye(normal, place) > 0.0;
#ifdef SMOOTH
  normal = corner_normal(corner, normal);
#endif
  if (!seen_front) normal = -normal;
#ifdef SMOOTH
  grazing = 1.0 - clamp(facing_eye(normal, place_of(corner)), 0.0, 1.0);
#else
  grazing = 1.0 - clamp(normal.z, 0.0, 1.0);
#endif
  float key = max(dot(normal, key_direction), 0.0);
  float fill = max(dot(normal, fill_direction), 0.0);
  float sky = 0.5 + 0.5 * normal.y;
  return 1.05 * key * key_colour + fill * fill_colour + mix(vec3(0.035, 0.032, 0.030), vec3(0.11, 0.125, 0.15), sky);
}
