#version 330 core
in vec2 texture_place;
in vec4 colour;  // alpha multiplied in, as in the textures

uniform sampler2D image;

layout(location = 0) out vec4 result;

void main() { result = colour * texture(image, texture_place); }
