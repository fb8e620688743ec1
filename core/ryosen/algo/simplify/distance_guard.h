// Keeps a surface of triangles within a distance of what it was while it changes, both ways: every point of either
// surface has one of the other that near.
//
// Each triangle of the input is listed at the faces by which it was proved to be near. A change proves anew those that
// are listed at faces which change. Each face has a bound of its own distance from the input: a new face is proved near
// the faces that it takes the place of, whose bounds add up, and where that is too much, near the listed triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/algo/simplify/collapse_surface.h"
#include "ryosen/algo/simplify/near_overlay.h"
#include "ryosen/algo/simplify/near_proof.h"

namespace ryosen {

class DistanceGuard {
 public:
  // Guards a mesh as it is, all faces of which are triangles without rings; `most` in units of the mesh. Faces with a
  // corner that is not finite are not measured. The mesh and the scale outlive it. O(n).
  DistanceGuard(const Mesh& mesh, const ScaledPlaces& scale, double most);

  // Returns whether the collapse moves a vertex with more faces than are proved together, which is always refused.
  bool moves_hub(Halfedge h, const glm::dvec3& position) const;

  // Returns whether the collapse that puts both ends of h there might exceed the distance: no proof was found. So do
  // the other questions. A question about a vertex with more than 128 faces that moves is refused at once. Cost: that
  // of the triangles listed at the faces that change, which are more where the distance is large against the faces.
  // Within 0.5 % a face of a smooth sheet takes 2.6 times as long among 80,000 as among 5,000.
  bool collapse_may_exceed(Halfedge h, const glm::dvec3& position);
  bool move_may_exceed(Vertex v, const glm::dvec3& position);
  // The edge lies between two triangles and is turned as by SwapEdge.
  bool swap_may_exceed(Halfedge h);
  // Takes over the change of the last question, which is about to be made.
  void follow();

  // Two triangles would be added on a cycle of edges that is no face, with their corners where those of the cycle are.
  bool filling_may_exceed(const std::array<Halfedge, 3>& sides);
  // Takes over the filling of the last question, which these faces have made.
  void follow_filling(const std::array<Face, 2>& added);
  // Two triangles would go whose sides run against each other, as pairs of these become one edge: against[i] ends where
  // sides[i] begins, and both ends come to that place.
  bool joining_may_exceed(const std::array<Halfedge, 3>& sides, const std::array<Halfedge, 3>& against,
                          const std::array<glm::dvec3, 3>& places);

  // So many faces were looked at and distances from triangles computed so far.
  std::uint64_t looks() const { return proof_.looks() + overlay_.looks() + marked_; }
  // So many pairs of a triangle of the input and a face at which it is listed.
  std::size_t entries() const { return used_entries_; }

 private:
  // More faces are not moved together: each is compared with all others.
  static constexpr std::size_t most_changed = 128;

  // A triangle of the input at a face, in the list of either.
  struct Entry {
    std::uint32_t triangle, face;
    std::uint32_t next_of_face, previous_of_face, next_of_triangle;
  };
  struct Changed {
    Face face;
    TriangleCorners corners;
    double bound = 0;
  };
  struct Moved {
    Vertex vertex;
    glm::dvec3 position;
  };
  // A triangle of the input and its part of near_faces_.
  struct Listed {
    std::uint32_t triangle;
    std::size_t begin = 0, end = 0;
  };

  TriangleCorners corners_of(Face f) const;
  TriangleCorners corners_of_input(std::uint32_t triangle) const;
  bool is_marked(std::uint32_t face) const { return marks_[face] == step_; }
  // Begins a question about a change; what changes is told next.
  void begin_question();
  void mark_changing(Face f);
  void add_target(Face f, const TriangleCorners& corners);
  void add_changed(Face f, const TriangleCorners& corners);
  // Whether more faces meet at a vertex than are moved together. Counts no further than that.
  bool is_hub(Vertex v) const;
  bool moves_hub(std::span<const Moved> moved) const;
  // The faces around these vertices, but those that were marked before, as they are with the vertices moved.
  void move_together(std::span<const Moved> moved);
  void find_listed();
  bool may_exceed();
  // Triangles of the input that are listed at faces which change, as targets.
  std::span<const NearTarget> listed_targets();
  // Whether points tell that there is no proof, before it is looked for.
  bool are_faces_plainly_far();
  bool is_input_plainly_far();
  bool prove_input();
  bool prove_faces();
  bool prove_face(Changed& changed);
  // Hashes nearly all that the answer to a question depends on.
  std::uint64_t key_of(Halfedge h, const glm::dvec3& position) const;
  void add_others(std::uint32_t triangle);
  void list_at(Face face, std::uint32_t triangle);
  // Takes a triangle out of the lists of faces, but for faces that stay and by which it is near again.
  void take_out_of_lists(const Listed& listed);
  void drop(std::uint32_t entry);

  const Mesh& mesh_;
  const ScaledPlaces& scale_;
  double most_;                                          // scaled, less what rounding may add
  std::vector<glm::dvec3> places_;                       // of the input, by vertex slot, scaled
  std::vector<std::array<std::uint32_t, 3>> triangles_;  // of the input
  std::vector<Entry> entries_;
  std::uint32_t free_entry_ = no_index;
  std::size_t used_entries_ = 0;
  std::vector<std::uint32_t> first_of_face_, first_of_triangle_;  // entries
  std::vector<double> bounds_;                                    // by face

  // The change that was asked for last.
  std::vector<std::uint32_t> marks_;                      // by face that changes or goes: the step
  std::vector<std::uint32_t> input_marks_;                // by listed triangle
  std::vector<std::uint32_t> point_marks_, inner_marks_;  // by vertex that is looked at, that is an inner place
  std::uint32_t step_ = 0;
  std::uint64_t marked_ = 0;  // so many faces so far
  std::vector<Face> old_;
  std::vector<Changed> changed_;
  std::vector<NearTarget> targets_;                                      // that input may be near
  std::vector<NearTarget> old_targets_, listed_targets_, both_targets_;  // that new faces may be near
  std::vector<glm::dvec3> new_inner_, old_inner_, listed_inner_;         // around which some of these lie
  std::vector<Face> owners_;                                             // of targets_
  std::vector<Listed> listed_;
  std::vector<Face> near_faces_;
  std::uint32_t last_far_ = no_index;   // a triangle for which a proof has failed
  std::vector<std::uint64_t> refused_;  // a cache: keys of what was refused
  NearProof proof_;
  NearOverlay overlay_;
};

}  // namespace ryosen
