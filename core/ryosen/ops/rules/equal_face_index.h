// Which faces have another face on their points, for many questions: the faces at a point are read once.
#pragma once

#include <cstdint>
#include <map>
#include <unordered_set>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Meanwhile a face may change that has no equal one, if it has got points that no face asked about has.
class EqualFaceIndex {
 public:
  explicit EqualFaceIndex(const Mesh& mesh) : mesh_(mesh) {}

  // See equal_face(). Cost: the corners of the face, and where no point of it has been read yet those of the faces at
  // its point of lowest valence.
  bool has_equal(Face f);

 private:
  void read_faces_at(Vertex p);

  const Mesh& mesh_;
  std::unordered_set<Vertex> read_;  // points
  std::unordered_set<Face> known_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> count_;  // of faces by their points
};

}  // namespace ryosen
