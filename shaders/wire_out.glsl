// Passes a triangle on to wire.glsl. Behind mesh.glsl and light.glsl.
uniform samplerBuffer cluster_sizes;  // of triangles in buffer space, by cluster
uniform float units_per_pixel;        // in view space, at distance 1 in perspective
uniform float pixel_scale;            // rendered pixels per pixel at display scale 1
out vec2 barycentric;
flat out float edge_bits;
out float size_here;  // of the triangles around, in pixels

void pass_wire(Corner corner) {
  edge_bits = float(corner.edge_bits);
  barycentric = vec2(corner.number == 0 ? 1.0 : 0.0, corner.number == 1 ? 1.0 : 0.0);
  float distance = mix(1.0, -(view_from_buffer * vec4(place_of(corner), 1.0)).z, perspective);
  float size = texelFetch(cluster_sizes, corner.slot / cluster_slots).r;
  size_here = size / (units_per_pixel * pixel_scale * max(distance, 1e-6));
}
