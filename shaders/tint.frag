#version 330 core
#ifdef SMOOTH
smooth in vec3 tint;
#else
flat in vec3 tint;
#endif
flat in float strength;
flat in int pattern;

uniform float pixel_scale;  // rendered pixels per pixel of the picture

layout(location = 0) out vec4 colour;

const int diagonal = 1, chessboard = 2, horizontal = 3, vertical = 4;

// How much a pixel belongs to the pattern: a sign other than the colour.
float share() {
  vec2 p = gl_FragCoord.xy / pixel_scale;
  float rising = step(0.5, fract((p.x - p.y) / 10.0));
  float falling = step(0.5, fract((p.x + p.y) / 10.0));
  if (pattern == diagonal) return 0.55 + 0.45 * rising;
  if (pattern == chessboard) return 0.50 + 0.50 * abs(rising - falling);  // on its corner
  if (pattern == horizontal) return 0.50 + 0.50 * step(0.5, fract(p.y / 6.0));
  if (pattern == vertical) return 0.50 + 0.50 * step(0.5, fract(p.x / 6.0));
  return 1.0;
}

void main() {
  float covered = strength * share();
  colour = vec4(sqrt(tint) * covered, covered);
}
