#version 330 core
// A square of the ground, in two triangles.
uniform mat4 clip_from_buffer;
uniform vec3 middle;
uniform float reach;
uniform float step_size;
out vec2 off;    // from the middle, in reaches
out vec2 steps;  // likewise, in steps

void main() {
  off = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  steps = off * reach / step_size;
  gl_Position = clip_from_buffer * vec4(middle + vec3(off.x, 0.0, off.y) * reach, 1.0);
}
