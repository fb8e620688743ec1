#version 330 core
// The surface once more, with how far from the clipping plane it is.
#include "mesh.glsl"
out float from_plane;  // in buffer space

void main() {
  Corner corner = read_corner();
  gl_Position = clip_place(corner);
  from_plane = dot(clip_plane, vec4(place_of(corner), 1.0));
}
