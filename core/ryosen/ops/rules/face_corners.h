// Reads and prints two corners of one face for separate_loop and unite_ring: A B [fN] [P-A] [Q-B].
#pragma once

#include <string>

#include "ryosen/base/verdict.h"
#include "ryosen/ops/parameters/member_values.h"

namespace ryosen {

// The sides of the face that end at the two corners.
struct FaceCorners {
  Halfedge into_a, into_b;
};

inline constexpr OpParameter face_corner_parameters[] = {
    with_words({"first", "First corner", "最初の角", "the vertex of the first corner", "最初の角の頂点"},
               parameters::required(parameters::element(OpValueKind::vertex, "A"))),
    with_words({"second", "Second corner", "二番目の角", "the vertex of the second corner", "二番目の角の頂点"},
               parameters::required(parameters::element(OpValueKind::vertex, "B"))),
    with_words(
        {"face", "Face", "面", "the face, where several have both corners", "両方の角を持つ面が複数あるときの面"},
        parameters::optional(parameters::element(OpValueKind::face, "fN"))),
    with_words({"into_first", "Side into the first", "最初の角への半稜線",
                "the halfedge that ends at A, where the face visits it several times",
                "面が A を複数回通るとき、A に着く半稜線"},
               parameters::optional(parameters::element(OpValueKind::edge, "P-A"))),
    with_words({"into_second", "Side into the second", "二番目の角への半稜線",
                "the halfedge that ends at B, where the face visits it several times",
                "面が B を複数回通るとき、B に着く半稜線"},
               parameters::optional(parameters::element(OpValueKind::edge, "Q-B")))};

// The face may be omitted if only one has both corners, the incoming sides if the face visits each point once.
FaceCorners read_face_corners(const Mesh& mesh, ArgumentReader& in);
std::string face_corners_text(const Mesh& mesh, const FaceCorners& corners);

// Reads the corners into an operator with two such sides, or prints those of one.
template <class Op>
void read_corners_of(const Mesh& mesh, ArgumentReader& in, void* op) {
  const FaceCorners corners = read_face_corners(mesh, in);
  *static_cast<Op*>(op) = {corners.into_a, corners.into_b};
}
template <class Op>
void print_corners_of(const Mesh& mesh, const void* op, std::string& line) {
  const auto& [into_a, into_b] = *static_cast<const Op*>(op);
  line += " " + face_corners_text(mesh, {into_a, into_b});
}

// Refuses deleted elements, corners of no face or of different faces, and equal points.
bool are_corners_of_one_face(const Mesh& mesh, const FaceCorners& corners, Verdict& verdict);

}  // namespace ryosen
