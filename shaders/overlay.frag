#version 330 core
#include "pixel.glsl"
flat in vec4 colour;
flat in vec4 places;
flat in vec3 measures;

uniform float pixel_scale;   // rendered pixels per pixel at display scale 1
uniform vec4 outline_colour;  // around points

layout(location = 0) out vec4 result;

const int kind_ghost = 0, kind_line = 1, kind_arrow = 2, kind_point = 3;
const int dashed = 1, dash_dot = 2, dotted = 3, style_bits = 3, rim_flag = 8;
const int ring = 1, cross_shape = 2, diamond = 3, square = 4;

// Share of a pixel covered by a shape whose edge is this far away; negative inside.
float coverage(float distance) { return clamp(0.5 - distance, 0.0, 1.0); }

// Distance along the line to the nearest stroke of length `on` around `middle`, repeated.
float to_stroke(float s, float middle, float on, float period) {
  float t = s - middle;
  return abs(t - period * floor(t / period + 0.5)) - 0.5 * on;
}

float line(int code, bool arrow) {
  int style = code & style_bits;
  float rim = (code & rim_flag) != 0 ? pixel_scale : 0.0;  // so much larger
  vec2 p = picture_pixel(), a = places.xy, b = places.zw;
  float extent = length(b - a), half_width = measures.x;
  vec2 along = extent > 1e-4 ? (b - a) / extent : vec2(1.0, 0.0);
  float s = dot(p - a, along), across = abs(dot(p - a, vec2(-along.y, along.x)));
  float head = 0.0;
  float shaft_end = extent;
  if (arrow) {
    float length_px = min(7.0 * half_width + 5.0 * pixel_scale, 0.7 * extent);
    float to_tip = extent - s;
    const vec2 slope = vec2(0.9138, 0.4061);  // of the head's sides, 24 degrees
    head = coverage(max(across * slope.x - to_tip * slope.y, to_tip - length_px) - rim);
    shaft_end = extent - 0.8 * length_px;
  }
  float shaft = coverage(length(vec2(max(max(-s, s - shaft_end), 0.0), across)) - half_width - rim);
  float width = 2.0 * half_width;
  float period = width * (style == dotted ? 2.0 : style == dash_dot ? 6.0 : 3.4);
  // Long lines carry the pattern centred; short ones, which are links of chains, take it from their place on the
  // screen, so that a chain shows the pattern as a whole.
  bool upright = abs(along.y) > abs(along.x);
  float t = extent > 2.5 * period ? s - 0.5 * extent : upright ? p.y : p.x;
  if (style == dashed) shaft *= coverage(to_stroke(t, 0.0, 2.0 * width, period));
  if (style == dash_dot) {
    float dash = to_stroke(t, 0.0, 2.8 * width, period), dot_place = to_stroke(t, 0.5 * period, width, period);
    shaft *= coverage(min(dash, dot_place));
  }
  if (style == dotted) shaft *= coverage(length(vec2(to_stroke(t, 0.0, 0.0, period), across)) - half_width);
  return max(shaft, head);
}

float point_distance(int shape) {
  vec2 p = picture_pixel() - places.xy;
  float radius = measures.x;
  vec2 turned = abs(vec2(p.x + p.y, p.x - p.y)) * 0.7071;
  if (shape == ring) return abs(length(p) - 0.78 * radius) - 0.22 * radius;
  if (shape == cross_shape) return max(min(turned.x, turned.y) - 0.22 * radius, max(turned.x, turned.y) - radius);
  if (shape == diamond) return max(turned.x, turned.y) - 0.75 * radius;
  if (shape == square) return max(abs(p.x), abs(p.y)) - 0.8 * radius;
  return length(p) - radius;
}

void main() {
  int kind = int(measures.y), style = int(measures.z);
  vec4 premultiplied = vec4(colour.rgb * colour.a, colour.a);
  if (kind == kind_ghost) {
    result = premultiplied;
  } else if (kind == kind_point) {
    float distance = point_distance(style);
    float outer = coverage(distance - min(1.3 * pixel_scale, 0.4 * measures.x)) * outline_colour.a * colour.a;
    result = mix(vec4(outline_colour.rgb * outer, outer), premultiplied, coverage(distance));
  } else {
    result = premultiplied * line(style, kind == kind_arrow);
  }
}
