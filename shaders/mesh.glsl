// Reads a mesh from texture buffers: a draw goes through the clusters of a list, or every so many-th triangle of each, and
// vertex number n is corner n % 3 of its triangle number n / 3.
uniform samplerBuffer positions;   // in buffer space
uniform usamplerBuffer triangles;  // three vertex numbers, then face * 8 + edge bits
uniform mat4 clip_from_buffer;
uniform vec4 clip_plane;  // what is kept is on the side where it is above 0
uniform usamplerBuffer cluster_numbers;  // those that are drawn, in their order
uniform int slots;     // of triangles; behind the last the memory may hold anything
uniform int thinning;  // every so many-th triangle is drawn

const int cluster_slots = 128;

const vec4 nowhere = vec4(2.0, 2.0, 2.0, 1.0);  // outside of the view

struct Corner {
  int slot;
  int number;      // 0, 1 or 2
  vec3 places[3];  // of all corners of the triangle
  uint face;
  uint edge_bits;
};

Corner read_corner() {
  Corner corner;
  int drawn = gl_VertexID / 3;
  corner.number = gl_VertexID - 3 * drawn;
  int in_cluster = cluster_slots / thinning;
  int place = drawn / in_cluster;
  corner.slot = int(texelFetch(cluster_numbers, place).r) * cluster_slots + (drawn - place * in_cluster) * thinning;
  uvec4 triangle = corner.slot < slots ? texelFetch(triangles, corner.slot) : uvec4(0u);
  corner.places[0] = texelFetch(positions, int(triangle.x)).xyz;
  corner.places[1] = texelFetch(positions, int(triangle.y)).xyz;
  corner.places[2] = texelFetch(positions, int(triangle.z)).xyz;
  corner.face = triangle.w >> 3u;
  corner.edge_bits = triangle.w & 7u;
  return corner;
}

vec3 place_of(Corner corner) {
  return corner.number == 0 ? corner.places[0] : corner.number == 1 ? corner.places[1] : corner.places[2];
}

// The same expression in every pass, so that equal places get equal depths.
vec4 clip_place(Corner corner) {
  vec4 place = vec4(place_of(corner), 1.0);
  gl_ClipDistance[0] = dot(clip_plane, place);
  return clip_from_buffer * place;
}
