#version 330 core
#include "mesh.glsl"
uniform mat4 view_from_buffer;
flat out uint slot;
out float depth;
void main() {
  Corner corner = read_corner();
  slot = uint(corner.slot);
  vec3 place = corner.number == 0 ? corner.places[0] : corner.number == 1 ? corner.places[1] : corner.places[2];
  depth = -(view_from_buffer * vec4(place, 1.0)).z;
  gl_Position = clip_place(corner);
}
