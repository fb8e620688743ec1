#version 330 core
flat in vec4 tint;
flat in int bit;

uniform float pixel_scale;  // rendered pixels per pixel of the picture

layout(location = 0) out vec4 colour;

// How much a pixel belongs to the pattern that goes with a bit of the flags: a sign other than the colour.
float pattern() {
  vec2 p = gl_FragCoord.xy / pixel_scale;
  float rising = step(0.5, fract((p.x - p.y) / 10.0));
  float falling = step(0.5, fract((p.x + p.y) / 10.0));
  if (bit == 0) return 0.70 + 0.30 * rising;  // selected
  if (bit == 3) return 0.55 + 0.45 * falling;                    // refused
  if (bit == 4) return 0.50 + 0.50 * abs(rising - falling);      // duplicate: a chessboard on its corner
  if (bit == 5) return 0.50 + 0.50 * step(0.5, fract(p.y / 6.0));  // degenerate
  if (bit == 6) return 0.50 + 0.50 * step(0.5, fract(p.x / 6.0));  // misoriented
  return 1.0;
}

void main() {
  float strength = tint.a * pattern();
  colour = vec4(sqrt(tint.rgb) * strength, strength);
}
