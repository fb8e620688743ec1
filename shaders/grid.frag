#version 330 core
in vec2 off;
in vec2 steps;
uniform vec2 line_at_middle;  // how many steps from a tenth line the middle is, along X and along Z
uniform vec2 zero_at_middle;  // and how many from where they are 0
uniform float pixel_scale;    // rendered pixels per pixel at display scale 1
uniform vec4 line_colour;
uniform vec3 x_colour;  // of the line along X
uniform vec3 z_colour;
layout(location = 0) out vec4 colour;

// How much of the pixel lines cover that are so far away, in steps; they fade where there are many to a pixel.
vec2 covered(vec2 away, vec2 per_px, float width_px) {
  vec2 away_px = away / max(per_px, vec2(1e-12)) / pixel_scale;
  return clamp(0.5 * width_px + 0.5 - away_px, 0.0, 1.0);
}
vec2 left_of(vec2 per_px, float period) { return 1.0 - smoothstep(0.08, 0.3, per_px * pixel_scale / period); }

void main() {
  vec2 per_px = fwidth(steps);
  vec2 here = line_at_middle + steps;
  vec2 each = covered(abs(here - round(here)), per_px, 1.0) * left_of(per_px, 1.0);
  vec2 tenth = covered(abs(here - 10.0 * round(here / 10.0)), per_px, 1.4) * left_of(per_px, 10.0);
  vec2 zero = covered(abs(zero_at_middle + steps), per_px, 2.0) * left_of(per_px, 10.0);
  float strength = max(0.5 * max(each.x, each.y), max(tenth.x, tenth.y));
  vec4 painted = vec4(line_colour.rgb, 1.0) * line_colour.a * strength;
  painted = mix(painted, vec4(x_colour, 1.0), 0.8 * zero.y);  // Z is 0 along X
  painted = mix(painted, vec4(z_colour, 1.0), 0.8 * zero.x);
  colour = painted * (1.0 - smoothstep(0.3, 1.0, length(off)));
}
