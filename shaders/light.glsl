// Light of three sources that move with the eye, on a flat triangle seen from either side. Colours are linear.
uniform mat4 view_from_buffer;  // moves, turns and scales evenly
uniform float perspective;      // 1, or 0 when all rays are parallel
uniform vec3 key_colour;
uniform vec3 fill_colour;
uniform vec3 rim_colour;
uniform vec3 front_colour;
uniform vec3 back_colour;

const vec3 key_direction = normalize(vec3(-0.42, 0.60, 0.68));
const vec3 fill_direction = normalize(vec3(0.80, -0.10, 0.45));

// What a white triangle would look like; seen_front says which side the eye sees.
vec3 light_on(Corner corner, out float grazing, out bool seen_front) {
  vec3 along = corner.places[1] - corner.places[0], across = corner.places[2] - corner.places[0];
  vec3 normal = normalize(mat3(view_from_buffer) * cross(along, across));
  vec3 to_eye = -normalize((view_from_buffer * vec4(corner.places[2], 1.0)).xyz);
  float facing = dot(normal, mix(vec3(0.0, 0.0, 1.0), to_eye, perspective));
  seen_front = facing > 0.0;
  if (!seen_front) normal = -normal;
  grazing = 1.0 - min(abs(facing), 1.0);
  float key = max(dot(normal, key_direction), 0.0);
  float fill = max(dot(normal, fill_direction), 0.0);
  float sky = 0.5 + 0.5 * normal.y;
  return 1.05 * key * key_colour + fill * fill_colour + mix(vec3(0.035, 0.032, 0.030), vec3(0.11, 0.125, 0.15), sky);
}
