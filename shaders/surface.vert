#version 330 core
#include "mesh.glsl"

uniform mat4 clip_from_mesh;
uniform mat4 view_from_mesh;

out vec3 view_position;
out vec2 barycentric;
flat out uint edge_bits;
flat out uint flags;

void main() {
  int slot = gl_VertexID / 3;
  int corner = gl_VertexID - 3 * slot;
  uvec4 triangle = texelFetch(triangles, slot);
  uint vertex = corner == 0 ? triangle.x : corner == 1 ? triangle.y : triangle.z;
  vec4 position = vec4(texelFetch(positions, int(vertex)).xyz, 1.0);
  flags = texelFetch(face_flags, int(triangle.w >> 3u)).r;
  edge_bits = triangle.w & 7u;
  barycentric = vec2(corner == 0 ? 1.0 : 0.0, corner == 1 ? 1.0 : 0.0);
  view_position = (view_from_mesh * position).xyz;
  gl_Position = (flags & flag_hidden) != 0u ? nowhere : clip_from_mesh * position;
}
