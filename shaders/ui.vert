#version 330 core
layout(location = 0) in vec2 position;  // in pixels from the upper left corner
layout(location = 1) in vec2 place;     // in the texture
layout(location = 2) in vec4 tint;

uniform vec2 size_px;

out vec2 texture_place;
out vec4 colour;

void main() {
  texture_place = place;
  colour = vec4(tint.rgb * tint.a, tint.a);
  gl_Position = vec4(position.x / size_px.x * 2.0 - 1.0, 1.0 - position.y / size_px.y * 2.0, 0.0, 1.0);
}
