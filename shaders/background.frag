#version 330 core
uniform vec3 top_colour;
uniform vec3 bottom_colour;
uniform float height_px;
layout(location = 0) out vec4 colour;
void main() {
  colour = vec4(mix(bottom_colour, top_colour, gl_FragCoord.y / height_px), 1.0);
}
