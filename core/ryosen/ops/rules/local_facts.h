// A cache of what rules ask of whole stars and whole faces, for asking about many edges of one mesh.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Valid while the mesh does not change, but for what is forgotten. The first question about a vertex or face costs its
// valence or its corners.
class LocalFacts {
 public:
  // See mesh/copies.h.
  bool has_several_fans(const Mesh& mesh, Vertex v);
  // See rules/face_lists.h.
  bool is_one_simple_loop(const Mesh& mesh, Face f);
  bool has_equal_face(const Mesh& mesh, Face f);
  // `is_new` tells whether they were counted for it.
  std::uint32_t corner_count(const Mesh& mesh, Face f, bool* is_new = nullptr);
  void forget(Face f);
  // A simple loop whose corners are known has one less, and no other face is on its points.
  void lost_corner(Face f);
  // One of two faces has taken the other in, is a simple loop of so many corners, and no other face is on its points.
  void united(Face stays, Face goes, std::uint32_t corners);

 private:
  std::unordered_map<Vertex, bool> several_fans_;
  std::unordered_map<Face, bool> one_simple_loop_, equal_face_;
  std::unordered_map<Face, std::uint32_t> corner_count_;
};

}  // namespace ryosen
