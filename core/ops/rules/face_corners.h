// Two corners of one face, as separate_loop and unite_ring name them: A B [fN] [P-A] [Q-B].
#pragma once

#include <string>

#include "core/base/verdict.h"
#include "core/ops/lines/arguments.h"

namespace ryosen {

// The sides of the face that arrive at the two corners.
struct FaceCorners {
  Halfedge into_a, into_b;
};

// The face may be left out where only one has both corners, the arriving sides where the face visits each once.
FaceCorners read_face_corners(const Mesh& mesh, ArgumentReader& in);
std::string face_corners_text(const Mesh& mesh, const FaceCorners& corners);

// Refuses what has been deleted, corners of no or different faces, and twice the same point.
bool are_corners_of_one_face(const Mesh& mesh, const FaceCorners& corners, Verdict& verdict);

}  // namespace ryosen
