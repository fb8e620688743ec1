// How the time and memory of what works on surfaces grow with their faces.
#pragma once

namespace ryosen::bench {

// A row for each: milliseconds at 1x, 4x and 16x the faces of a torus, the exponent of the growth from the first to the
// last, and the bytes a face of the input that it takes at its peak beside the input.
void print_surface_growth();

}  // namespace ryosen::bench
