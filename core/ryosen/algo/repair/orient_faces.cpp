#include "ryosen/algo/repair/orient_faces.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "ryosen/algo/repair/detach_nonmanifold.h"
#include "ryosen/algo/repair/pair_faces.h"
#include "ryosen/algo/repair/seen_area.h"
#include "ryosen/algo/repair/sides_apart.h"
#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/analysis/shells.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/progress.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/ops/orient.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/turn_faces.h"

namespace ryosen {

namespace {

enum class PatchKind : std::uint8_t { closed, open, neither };

class Patches {
 public:
  explicit Patches(const Mesh& mesh)
      : mesh_(mesh), around_(mesh, Neighbourhood::Reach::whole), sets_(mesh.face_slots()) {
    join();
    number();
    judge();
  }

  std::vector<bool> to_turn(Progress& progress) {
    std::vector<bool> turns(kinds_.size(), false);
    turn_shells(turns);
    turn_open(turns, progress);
    if (std::find(turns.begin(), turns.end(), true) == turns.end()) return {};
    std::vector<bool> faces(mesh_.face_slots(), false);
    for (std::uint32_t f = 0; f < faces.size(); ++f) faces[f] = of_face_[f] != no_index && turns[of_face_[f]];
    return faces;
  }

 private:
  // A side of a face at an edge of three faces or more.
  struct CrowdedSide {
    Vertex low, high;
    std::uint32_t patch;
    bool is_forward;
    auto edge() const { return std::tie(low, high, patch); }
  };

  void join() {
    for_each_side(mesh_, [&](Halfedge h) {
      if (const Halfedge other = around_.across(h)) sets_.join(mesh_.face(h).index, mesh_.face(other).index);
    });
  }

  void number() {
    of_face_.assign(mesh_.face_slots(), no_index);
    for (const Face f : live_faces(mesh_)) {
      const std::uint32_t root = sets_.root(f.index);  // the lowest
      if (root == f.index) kinds_.push_back(PatchKind::closed);
      of_face_[f.index] = root == f.index ? static_cast<std::uint32_t>(kinds_.size() - 1) : of_face_[root];
    }
  }

  void judge() {
    std::vector<CrowdedSide> crowded;
    for_each_side(mesh_, [&](Halfedge h) {
      const std::uint32_t patch = of_face_[mesh_.face(h).index];
      const PointEdge faces = around_.edge(h);
      if (!is_finite(mesh_.position(mesh_.from(h))) || faces.is_misoriented()) {
        kinds_[patch] = PatchKind::neither;
      } else if (faces.is_boundary()) {
        open(patch);
      } else if (faces.is_nonmanifold()) {
        const Vertex a = around_.point(mesh_.from(h)), b = around_.point(mesh_.to(h));
        crowded.push_back({std::min(a, b), std::max(a, b), patch, a < b});
      }
    });
    std::sort(crowded.begin(), crowded.end(),
              [](const CrowdedSide& s, const CrowdedSide& t) { return s.edge() < t.edge(); });
    for (std::size_t first = 0, last = 0; first < crowded.size(); first = last) {
      std::ptrdiff_t sum = 0;
      for (; last < crowded.size() && crowded[last].edge() == crowded[first].edge(); ++last)
        sum += crowded[last].is_forward ? 1 : -1;
      if (sum != 0) open(crowded[first].patch);
    }
  }

  void open(std::uint32_t patch) {
    if (kinds_[patch] == PatchKind::closed) kinds_[patch] = PatchKind::open;
  }

  // The patches of a kind that `may` lets through, by face and numbered anew.
  template <class May>
  FaceComponents those(PatchKind kind, May may) const {
    FaceComponents found;
    std::vector<std::uint32_t> number(kinds_.size(), no_index);
    found.of_face.assign(of_face_.size(), no_index);
    for (std::uint32_t f = 0; f < of_face_.size(); ++f) {
      const std::uint32_t patch = of_face_[f];
      if (patch == no_index || kinds_[patch] != kind || !may(f)) continue;
      if (number[patch] == no_index) number[patch] = found.count++;
      found.of_face[f] = number[patch];
    }
    return found;
  }

  void turn_shells(std::vector<bool>& turns) const {
    const FaceComponents closed = those(PatchKind::closed, [](std::uint32_t) { return true; });
    if (closed.count == 0) return;
    for (const Shell& shell : nest_shells(mesh_, closed).all)
      turns[of_face_[shell.first.index]] = shell.turned == (shell.depth % 2 == 0 ? -1 : 1);
  }

  void turn_open(std::vector<bool>& turns, Progress& progress) {
    if (std::find(kinds_.begin(), kinds_.end(), PatchKind::open) == kinds_.end()) return;
    const FaceComponents components = find_face_components(around_);
    std::vector<bool> has_shell(components.count, false);
    for (std::uint32_t f = 0; f < of_face_.size(); ++f)
      if (of_face_[f] != no_index && kinds_[of_face_[f]] == PatchKind::closed) has_shell[components.of_face[f]] = true;
    const FaceComponents open =
        those(PatchKind::open, [&](std::uint32_t f) { return !has_shell[components.of_face[f]]; });
    if (open.count == 0) return;
    const std::vector<bool> first = turned_to_first();
    const bool is_first = std::find(first.begin(), first.end(), true) == first.end();
    const std::vector<SeenArea> seen =
        is_first ? seen_areas(mesh_, open.of_face, open.count, progress)
                 : seen_areas(Mesh(turn_faces(mesh_, first).columns), open.of_face, open.count, progress);
    for (std::uint32_t f = 0; f < of_face_.size(); ++f) {
      if (open.of_face[f] == no_index) continue;
      SeenArea area = seen[open.of_face[f]];
      if (first[f]) std::swap(area.front, area.behind);
      if (area.is_mostly_behind()) turns[of_face_[f]] = true;
    }
  }

  // Whether the patch of each face is turned in the examined mesh, which is the same one however patches are
  // turned: else another centre, or another way to cut a face into triangles, could turn a patch back.
  std::vector<bool> turned_to_first() {
    std::vector<bool> is_met(kinds_.size(), false), turns(kinds_.size(), false), faces(of_face_.size(), false);
    for (std::uint32_t f = 0; f < of_face_.size(); ++f) {
      const std::uint32_t patch = of_face_[f];
      if (patch == no_index) continue;
      if (!is_met[patch]) turns[patch] = runs_second(Face(f));
      is_met[patch] = true;
      faces[f] = turns[patch];
    }
    return faces;
  }

  // Whether the loop goes on from its lowest point to the higher of the two beside that.
  bool runs_second(Face f) const {
    Vertex lowest, before, behind;
    for (const Halfedge h : halfedges_around(mesh_, f)) {
      const Vertex p = around_.point(mesh_.from(h));
      if (lowest && !(p < lowest)) continue;
      lowest = p;
      before = around_.point(mesh_.from(mesh_.prev(h)));
      behind = around_.point(mesh_.to(h));
    }
    return before < behind;
  }

  const Mesh& mesh_;
  Neighbourhood around_;
  DisjointSets sets_;                   // of faces
  std::vector<std::uint32_t> of_face_;  // patches, by lowest face
  std::vector<PatchKind> kinds_;        // by patch
};

// Tells by face slot whether the patch of the face should turn; empty where none should. A patch is faces
// joined over edges of two faces. One that is closed is turned where its faces do not look outwards at even depth and
// inwards at odd depth inside other closed ones (nest_shells), so all shells that cross look outwards where nothing is
// around them. One that is open is turned where its area seen from behind is more than 1.5 times that from the front
// (seen_areas), unless a closed patch is joined to it. One that disagrees with itself, or has a corner without a place,
// is left. Turning twice does nothing. O(n log n), with what nest_shells and seen_areas cost beside that.
std::vector<bool> faces_to_turn_outwards(const Mesh& mesh, Progress& progress) {
  return Patches(mesh).to_turn(progress);
}

std::vector<Element> misoriented_edges(const Mesh& m) {
  Neighbourhood around(m, Neighbourhood::Reach::whole);
  const auto is_misoriented = row_of(ProblemKind::misoriented_edge).edge;
  std::vector<Element> edges;
  for (const Edge e : live_edges(m))
    if (is_misoriented(around, e)) edges.push_back(e);
  return edges;
}

// Whether turning the face would make it and another triangle on its points a hanging pair.
bool would_hang(Neighbourhood& around, Face f) {
  const Mesh& m = around.mesh();
  if (corner_count(m, f) != 3 || !equal_face(m, f)) return false;
  std::size_t of_two_alike = 0;
  for (Halfedge h : halfedges_around(m, f)) of_two_alike += around.edge(h).is_misoriented();
  return of_two_alike >= 2;
}

// First so that neighbours agree, then outwards.
std::vector<bool> faces_to_turn(const Mesh& m, Progress& progress) {
  std::vector<bool> turned = turned_by_orient(m);
  Neighbourhood around(m);
  for (std::uint32_t f = 0; f < turned.size(); ++f) turned[f] = turned[f] && !would_hang(around, Face(f));
  const bool agrees = std::find(turned.begin(), turned.end(), true) == turned.end();
  const std::vector<bool> outwards = agrees ? faces_to_turn_outwards(m, progress)
                                            : faces_to_turn_outwards(Mesh(turn_faces(m, turned).columns), progress);
  for (std::size_t f = 0; f < outwards.size(); ++f) turned[f] = turned[f] != outwards[f];
  return turned;
}

}  // namespace

std::size_t count_turned_wrong(const Mesh& mesh, Progress& progress) {
  const std::vector<bool> turned = faces_to_turn_outwards(mesh, progress);
  return static_cast<std::size_t>(std::count(turned.begin(), turned.end(), true));
}

AlgorithmResult orient_faces(Edit& edit, const AlgorithmInput&, Progress& progress) {
  const Mesh& m = edit.mesh();
  AlgorithmResult result;
  const std::vector<bool> turned = faces_to_turn(m, progress);
  if (progress.is_cancelled()) return {};
  if (std::find(turned.begin(), turned.end(), true) != turned.end()) {
    Descent descent = edit.new_descent();
    TurnedMesh now = turn_faces(m, turned, &descent);
    if (is_torn(m, Mesh(now.columns))) {
      Mesh apart = m;
      descent = edit.new_descent();
      Edit on_apart(apart, nullptr, &descent);
      detach_nonmanifold(on_apart, {}, progress);
      on_apart.commit();
      const std::vector<bool> turned_apart = faces_to_turn(apart, progress);
      if (progress.is_cancelled()) return {};
      now = turn_faces(apart, turned_apart, &descent);
    }
    result.changed = now.effect.changed.size();
    edit.replace(std::move(now.columns), descent);
  }
  std::vector<Element> left = misoriented_edges(edit.mesh());
  result.left = left.size();
  add_left(result.left_for,
           {"the surface has one side only there, or its faces would lie back to back",
            "そこでは曲面に表裏がないか、裏返すと面が背中合わせに重なるため"},
           std::move(left));
  result.text =
      count_text(result.changed, "One face was turned round or joined to a neighbour",
                 "# faces were turned round or joined to their neighbours", "面を # 枚、裏返すか隣の面とつなぎました");
  if (result.left > 0)
    result.text +=
        count_text(result.left, "; # edge stays misoriented", "; # edges stay misoriented", "（向きの揃わない稜線 #）");
  result.text += Text{".", "。"};
  return result;
}

}  // namespace ryosen
