#include "ryosen/algo/repair/loose_pieces.h"

#include <map>

namespace ryosen {

namespace {

const Text loose_reason{"loose pieces that came off; select linked takes each whole, to be looked at or deleted",
                        "切り離された部分。select linked で全体を選択し、確認や削除ができます"};

struct Piece {
  Face first;
  std::size_t faces = 0;
  std::uint32_t whole = no_index;  // the component of its first face before
  bool is_open = false;
};

std::vector<Piece> pieces_of(const FaceComponents& before, const Mesh& after) {
  Neighbourhood around(after, Neighbourhood::Reach::whole);
  const FaceComponents components = find_face_components(around);
  std::vector<Piece> pieces(components.count);
  for (std::uint32_t f = 0; f < components.of_face.size(); ++f) {
    if (components.of_face[f] == no_index) continue;
    Piece& piece = pieces[components.of_face[f]];
    if (piece.faces++ == 0) piece.first = Face(f);
    if (piece.whole == no_index && f < before.of_face.size()) piece.whole = before.of_face[f];
  }
  for (std::uint32_t i = 0; i < after.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (!after.is_alive(h) || after.is_outside(h)) continue;
    Piece& piece = pieces[components.of_face[after.face(h).index]];
    piece.is_open = piece.is_open || (after.is_outside(twin(h)) && around.edge(h).is_boundary());
  }
  return pieces;
}

}  // namespace

std::vector<Face> find_loose_pieces(const FaceComponents& before, const Mesh& after) {
  const std::vector<Piece> pieces = pieces_of(before, after);
  std::map<std::uint32_t, const Piece*> main;  // by component before
  for (const Piece& piece : pieces) {
    if (piece.whole == no_index) continue;
    const Piece*& best = main[piece.whole];
    const auto is_better = [&] {
      if (piece.is_open != best->is_open) return best->is_open;
      return piece.faces > best->faces;
    };
    if (!best || is_better()) best = &piece;
  }
  std::vector<Face> loose;
  for (const Piece& piece : pieces)
    if (piece.whole != no_index && piece.is_open && main[piece.whole] != &piece) loose.push_back(piece.first);
  return loose;
}

FaceComponents components_of(const Mesh& mesh) {
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  return find_face_components(around);
}

void add_loose_pieces(const FaceComponents& before, const Mesh& after, AlgorithmResult& result) {
  const std::vector<Face> loose = find_loose_pieces(before, after);
  add_left(result.left_for, loose_reason, {loose.begin(), loose.end()});
}

bool tells_of_loose_pieces(const LeftForReason& left) { return left.reason.en == loose_reason.en; }

}  // namespace ryosen
