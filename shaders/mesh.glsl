// Reads a mesh from texture buffers: vertex number n of a draw is corner n % 3 of the triangle in slot n / 3.
uniform samplerBuffer positions;   // relative to the origin of the buffers
uniform usamplerBuffer triangles;  // three vertex numbers, then face * 8 + edge bits
uniform usamplerBuffer face_flags;

const uint flag_hidden = 128u;
const vec4 nowhere = vec4(2.0, 2.0, 2.0, 1.0);  // outside of the view
