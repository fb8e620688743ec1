// The parameter `seams` of algorithms that change faces: what becomes of values at corners, and of the seams between
// them.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/algo/parameters.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// weighed: each algorithm does with seams what it can, and normals of flat faces are none (flat_normals.h). kept: they
// stay. dropped: texture and normals go, colours stay.
enum class SeamMode { weighed, kept, dropped };

// Its row, with what weigh and the others mean to the algorithm.
ParameterRow seams_row(std::string_view help_en, std::string_view help_ja);
SeamMode seam_mode_of(const ParameterValues& values);

// Drops the values that are to go, or takes the normals off flat faces, whose flags it gives (flat_normals.h); where it
// looks for these, equal values come to share their place in the pool. O(corners).
std::vector<std::uint8_t> prepare_seams(Mesh& mesh, SeamMode seams);

// A sentence on what of this mesh was dropped, with a space before it in English; empty where it has nothing to drop.
Text dropped_text(const Mesh& before, SeamMode seams);

}  // namespace ryosen
