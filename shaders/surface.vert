#version 330 core
#include "mesh.glsl"
#include "light.glsl"
#include "wire_out.glsl"

SHADED out vec3 lit;  // linear colour
#ifdef PAINTED
#include "paint_out.glsl"
SHADED out vec3 paint_light;
uniform float paint_floor;  // how much of the paint is seen without light, so that colours stay those of a legend; below 0: as
                            // much as of the surface
#endif

void main() {
  Corner corner = read_corner();
  float grazing;
  bool seen_front;
  vec3 light = light_on(corner, grazing, seen_front);
  lit = (seen_front ? front_colour : back_colour) * light + rim_colour * grazing * grazing * grazing;
  pass_wire(corner);
#ifdef PAINTED
  pass_paint(corner);
  paint_light = paint_floor < 0.0 ? light + rim_colour * grazing * grazing * grazing
                                  : vec3(min(mix(dot(light, vec3(0.3333)), 1.0, paint_floor), 1.0));
#endif
  gl_Position = clip_place(corner);
  // Of two faces in one place the one that is seen from its front is seen, not by turns one and the other.
  const float behind = 8e-6;
  if (!seen_front) gl_Position.z += behind * gl_Position.w;
}
