// Large meshes that benchmarks make themselves.
#pragma once

#include <cstdint>

#include "ryosen/indexed/indexed.h"

namespace ryosen::bench {

// A torus of 2 * rows * columns triangles, points and faces row by row, so that neighbours lie close together.
IndexedMesh torus(std::uint32_t rows, std::uint32_t columns);

// The same surface with points and faces in random order (the same on every run).
IndexedMesh shuffled(IndexedMesh mesh);

}  // namespace ryosen::bench
