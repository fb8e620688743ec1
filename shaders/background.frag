#version 330 core
#include "pixel.glsl"
uniform vec3 top_colour;
uniform vec3 bottom_colour;
uniform float height_px;
layout(location = 0) out vec4 colour;
void main() {
  colour = vec4(mix(bottom_colour, top_colour, picture_pixel().y / height_px), 1.0);
}
