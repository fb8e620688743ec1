#version 330 core
// The mean of the factor x factor rendered pixels of each pixel of the picture, or of the part of it that is rendered.
uniform sampler2D rendered;
uniform int factor;
uniform ivec2 lower_left;  // of that part in the picture
layout(location = 0) out vec4 colour;
void main() {
  ivec2 corner = (ivec2(gl_FragCoord.xy) - lower_left) * factor;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < factor; ++y) {
    for (int x = 0; x < factor; ++x) sum += texelFetch(rendered, corner + ivec2(x, y), 0);
  }
  colour = sum / float(factor * factor);
}
