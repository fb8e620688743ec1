#include "ryosen/ops/orient.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/rules/turn_faces.h"

namespace ryosen {

constinit const OpInfo Orient::info{
    .id = "orient",
    .name_en = "Orient faces",
    .name_ja = "面の向きを揃える",
    .help_en = "flips faces so that neighbours are consistently oriented where possible",
    .help_ja = "隣り合う面の向きの不一致が減るように、可能ならなくなるように面を裏返す",
    .key = 'O',
    .target = OpTargetKind::none,
    .group = OpGroup::orient,
    .on_selection = OnSelection::none};

namespace {

// The adjacent face across a side, and whether the two are consistently oriented; none unless the edge has exactly two
// faces.
struct Neighbour {
  Face face;
  bool agrees = true;
};

struct OrderedNeighbour {
  Face face;
  Vertex smaller, larger;  // the points of the shared edge
  bool agrees;
  friend auto operator<=>(const OrderedNeighbour&, const OrderedNeighbour&) = default;
};

Neighbour across(Neighbourhood& around, Halfedge side) {
  const Mesh& m = around.mesh();
  if (around.is_single_sheet(side)) return {m.face(twin(side)), true};
  const Halfedge other = around.across(side);
  if (!other) return {};
  return {m.face(other), !around.run_alike(side, other)};
}

// In an order that is invariant under flipping, so that orient is idempotent.
std::vector<OrderedNeighbour> neighbours_in_order(Neighbourhood& around, Face f) {
  const Mesh& m = around.mesh();
  std::vector<OrderedNeighbour> found;
  for (Halfedge side : halfedges_around(m, f)) {
    const Neighbour next = across(around, side);
    if (!next.face) continue;
    const auto [smaller, larger] = std::minmax({around.point(m.from(side)), around.point(m.to(side))});
    found.push_back({next.face, smaller, larger, next.agrees});
  }
  std::sort(found.begin(), found.end());
  return found;
}

// The dual graph of a connected component in compressed form: faces from 0, and per face the neighbours across its
// sides. Each joint of two different faces is listed from both.
struct FaceGraph {
  struct Side {
    std::uint32_t face;
    bool agrees;  // whether the two currently traverse their edge in opposite directions
  };
  std::vector<std::uint32_t> offsets{0};  // per face into sides; faces + 1 entries
  std::vector<Side> sides;

  std::uint32_t size() const { return static_cast<std::uint32_t>(offsets.size() - 1); }
};

// A set of faces of a non-orientable component to flip. The seam is the joints that disagree after flipping.
class Seam {
 public:
  Seam(const FaceGraph& graph, std::vector<bool> turned) : graph_(graph), turned_(std::move(turned)) {}

  const std::vector<bool>& turned() const { return turned_; }
  // The number of joints that disagree. O(joints).
  std::size_t size() const {
    std::size_t twice = 0;
    for (std::uint32_t f = 0; f < graph_.size(); ++f)
      for (std::uint32_t i = graph_.offsets[f]; i < graph_.offsets[f + 1]; ++i) twice += disagrees(f, graph_.sides[i]);
    return twice / 2;
  }

  // Flips patches (faces connected through joints that agree) and single faces while that shortens the seam; at the end
  // there is one patch and no face disagrees with more neighbours than it agrees with. The seam never gets longer; the
  // result is a local optimum. The partition of the faces does not depend on whether all faces were flipped before.
  // Each pass over patches and faces is O(faces + joints).
  void shorten() {
    // Flipping a single face may split its patch, so repeat.
    do join_patches();
    while (turn_faces());
  }

 private:
  bool disagrees(std::uint32_t face, const FaceGraph::Side& side) const {
    return side.agrees == (turned_[face] != turned_[side.face]);
  }
  // Traverses the patches breadth-first, alternating flipped and unflipped across the seam: all joints between two
  // patches disagree, so flipping one of them makes all agree.
  void join_patches() {
    std::vector<bool> seen(graph_.size(), false), flipped(graph_.size(), false);
    std::vector<std::uint32_t> patch, reached;
    std::vector<std::pair<std::uint32_t, bool>> beyond{{0, false}};
    for (std::size_t next = 0; next < beyond.size(); ++next) {
      const auto [start, flip] = beyond[next];
      if (seen[start]) continue;
      seen[start] = true;
      patch.assign(1, start);
      for (std::size_t k = 0; k < patch.size(); ++k) {
        const std::uint32_t f = patch[k];
        flipped[f] = flip;
        for (std::uint32_t i = graph_.offsets[f]; i < graph_.offsets[f + 1]; ++i) {
          const FaceGraph::Side& side = graph_.sides[i];
          if (seen[side.face]) continue;
          if (disagrees(f, side)) {
            beyond.emplace_back(side.face, !flip);
          } else {
            seen[side.face] = true;
            patch.push_back(side.face);
          }
        }
      }
    }
    for (std::uint32_t f = 0; f < graph_.size(); ++f) turned_[f] = turned_[f] != flipped[f];
  }
  // Each flip shortens the seam, so the total queue length is bounded.
  bool turn_faces() {
    std::vector<std::uint32_t> queue(graph_.size());
    std::iota(queue.begin(), queue.end(), 0u);
    std::vector<bool> waits(graph_.size(), true);
    bool any = false;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const std::uint32_t f = queue[next];
      waits[f] = false;
      if (!disagrees_mostly(f)) continue;
      any = true;
      turned_[f] = !turned_[f];
      for (std::uint32_t i = graph_.offsets[f]; i < graph_.offsets[f + 1]; ++i) {
        const std::uint32_t other = graph_.sides[i].face;
        if (waits[other]) continue;
        waits[other] = true;
        queue.push_back(other);
      }
    }
    return any;
  }
  bool disagrees_mostly(std::uint32_t face) const {
    std::uint32_t against = 0;
    for (std::uint32_t i = graph_.offsets[face]; i < graph_.offsets[face + 1]; ++i)
      against += disagrees(face, graph_.sides[i]);
    return 2 * against > graph_.offsets[face + 1] - graph_.offsets[face];
  }

  const FaceGraph& graph_;
  std::vector<bool> turned_;
};

// Chooses the faces to flip.
class Choice {
 public:
  explicit Choice(const Mesh& m)
      : m_(m),
        around_(m, Neighbourhood::Reach::whole),
        seen_(m.face_slots(), false),
        turned_(m.face_slots(), false),
        place_(m.face_slots(), 0) {}

  std::vector<bool> choose() {
    for (const Face f : live_faces(m_)) {
      if (seen_[f.index]) continue;
      if (!flood(f)) shorten_the_seam();
      keep_majority();
    }
    return std::move(turned_);
  }

 private:
  // Collects the component breadth-first and orients each face like the one it is reached from. Returns whether all
  // other neighbours then agree too.
  bool flood(Face start) {
    bool all_agree = true;
    component_.assign(1, start);
    seen_[start.index] = true;
    for (std::size_t i = 0; i < component_.size(); ++i) {
      const Face f = component_[i];
      place_[f.index] = static_cast<std::uint32_t>(i);
      for (const OrderedNeighbour& next : neighbours_in_order(around_, f)) {
        const bool turns = turned_[f.index] != !next.agrees;
        if (!seen_[next.face.index]) {
          seen_[next.face.index] = true;
          turned_[next.face.index] = turns;
          component_.push_back(next.face);
        } else if (turned_[next.face.index] != turns) {
          all_agree = false;
        }
      }
    }
    return all_agree;
  }

  FaceGraph graph_of_component() {
    FaceGraph graph;
    for (Face f : component_) {
      for (const OrderedNeighbour& next : neighbours_in_order(around_, f))
        if (next.face != f) graph.sides.push_back({place_[next.face.index], next.agrees});
      graph.offsets.push_back(static_cast<std::uint32_t>(graph.sides.size()));
    }
    return graph;
  }

  // For a non-orientable component: shortens the seam starting from the current orientation and from the flood, and
  // takes the shorter result if it is shorter than the current seam.
  void shorten_the_seam() {
    const FaceGraph graph = graph_of_component();
    std::vector<bool> flooded;
    for (Face f : component_) flooded.push_back(turned_[f.index]);
    Seam own(graph, std::vector<bool>(component_.size(), false)), other(graph, std::move(flooded));
    const std::size_t before = own.size();
    own.shorten();
    other.shorten();
    const Seam& best = other.size() < own.size() ? other : own;
    const bool is_shorter = best.size() < before;
    for (std::size_t i = 0; i < component_.size(); ++i) turned_[component_[i].index] = is_shorter && best.turned()[i];
  }

  // Flips the smaller of the two sets.
  void keep_majority() {
    const auto is_degenerate = row_of(ProblemKind::degenerate_area).face;
    std::size_t all = 0, count = 0;
    for (Face f : component_) {
      if (is_degenerate(around_, f)) continue;
      ++all;
      count += turned_[f.index];
    }
    if (all == 0)
      for (Face f : component_) ++all, count += turned_[f.index];
    const bool is_even = 2 * count == all;
    if (2 * count < all || (is_even && !turned_[component_[0].index])) return;
    for (Face f : component_) turned_[f.index] = !turned_[f.index];
  }

  const Mesh& m_;
  Neighbourhood around_;
  std::vector<bool> seen_, turned_;
  std::vector<std::uint32_t> place_;  // index of each face in its component
  std::vector<Face> component_;       // the lowest face first
};

}  // namespace

std::vector<bool> turned_by_orient(const Mesh& mesh) { return Choice(mesh).choose(); }

Verdict Orient::check(const Mesh& mesh) const {
  Verdict verdict;
  const std::vector<bool> turned = turned_by_orient(mesh);
  if (std::find(turned.begin(), turned.end(), true) == turned.end()) verdict.refuse(Rule::oriented, {});
  return verdict;
}

OpEffect Orient::apply(Edit& edit) const {
  Descent descent = edit.new_descent();
  TurnedMesh turned = turn_faces(edit.mesh(), turned_by_orient(edit.mesh()), &descent);
  assert(!turned.effect.changed.empty());
  edit.replace(std::move(turned.columns), descent);
  return turned.effect;
}

}  // namespace ryosen
