#version 330 core
in float from_plane;
uniform float pixel_scale;  // rendered pixels per pixel at display scale 1
uniform vec4 line_colour;
layout(location = 0) out vec4 colour;

const float width_px = 2.0;

void main() {
  float per_px = fwidth(from_plane);
  // A face that lies in the plane is not cut by it.
  float away_px = per_px < 1e-7 ? 1e6 : from_plane / per_px / pixel_scale;
  colour = line_colour * clamp(width_px + 0.5 - away_px, 0.0, 1.0);
}
