#include "ryosen/algo/repair/side_effects.h"

#include <algorithm>
#include <map>

#include "ryosen/algo/repair/sides_apart.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/base/count_text.h"

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
  for_each_side(after, [&](Halfedge h) {
    Piece& piece = pieces[components.of_face[after.face(h).index]];
    piece.is_open = piece.is_open || (after.is_outside(twin(h)) && around.edge(h).is_boundary());
  });
  return pieces;
}

// More pairs are of no use to anyone.
constexpr std::size_t most_pairs = 1000000;

}  // namespace

FaceComponents components_of(const Mesh& mesh) {
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  return find_face_components(around);
}

void add_loose_pieces(const FaceComponents& before, const Mesh& after, AlgorithmResult& result) {
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
  std::vector<Element> loose;
  for (const Piece& piece : pieces)
    if (piece.whole != no_index && piece.is_open && main[piece.whole] != &piece) loose.emplace_back(piece.first);
  add_left(result.left_for, loose_reason, std::move(loose));
}

bool tells_of_loose_pieces(const LeftForReason& left) { return left.reason.en == loose_reason.en; }

void add_new_crossings(const Mesh& before, const Mesh& after, AlgorithmResult& result) {
  const SelfIntersections old = find_self_intersections(before, most_pairs);
  SelfIntersections now = find_self_intersections(after, most_pairs);
  std::size_t added = now.count - std::min(now.count, old.count);
  const bool is_exact = now.is_all() && old.is_all();
  if (is_exact)
    added = std::erase_if(
        now.pairs, [&](const FacePair& pair) { return !std::binary_search(old.pairs.begin(), old.pairs.end(), pair); });
  result.crossings = added;
  if (added == 0) return;
  result.text =
      result.text +
      (is_exact ? count_text(added, " One pair of faces meets now that did not.",
                             " # pairs of faces meet now that did not.", "新たに交わる面が # 組あります。")
                : count_text(added, " At least one more pair of faces meets now.",
                             " At least # more pairs of faces meet now.", "交わる面が少なくとも # 組増えました。"));
}

}  // namespace ryosen
