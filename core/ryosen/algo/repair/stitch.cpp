#include "ryosen/algo/repair/stitch.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "ryosen/algo/repair/detach_nonmanifold.h"
#include "ryosen/algo/repair/new_crossings.h"
#include "ryosen/algo/repair/t_junctions.h"
#include "ryosen/algo/repair/weld_points.h"
#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/point_in_edge.h"
#include "ryosen/ops/split_edge.h"

namespace ryosen {

namespace {

// The junctions of a mesh put in on a copy.
class Stitching {
 public:
  Stitching(const Mesh& before, const NearPoints& near, const Reach& reach, const std::vector<TJunction>& junctions)
      : mesh(before), reach_(reach), is_concerned_(before.vertex_slots(), false) {
    Edit edit(mesh, nullptr);
    take_bow_ties_apart(edit, junctions);
    mark_places(near, junctions);
    for (const TJunction& junction : junctions) put_in(edit, junction);
    edit.commit();
  }

  // Returns for each junction whether one of its parts was joined.
  std::vector<bool> weld(Progress& progress) {
    Edit edit(mesh, nullptr);
    std::vector<Edge> joined = weld_near_points(edit, {reach_.distance, reach_.used, &is_concerned_}, progress).joined;
    edit.commit();
    sort_unique(joined);
    std::vector<bool> is_joined;
    for (const auto& parts : parts_)
      is_joined.push_back(std::any_of(parts.begin(), parts.end(), [&](Edge e) {
        return e && std::binary_search(joined.begin(), joined.end(), e);
      }));
    return is_joined;
  }

  Mesh mesh;

 private:
  // Gives each fan at a junction a point of its own, since only points of one fan are welded.
  static void take_bow_ties_apart(Edit& edit, const std::vector<TJunction>& junctions) {
    std::vector<Vertex> bow_ties;
    for (const TJunction& junction : junctions) bow_ties.push_back(point(edit.mesh(), junction.point));
    sort_unique(bow_ties);
    Neighbourhood around(edit.mesh());
    std::erase_if(bow_ties, [&](Vertex p) { return around.star(p).has_nonmanifold_edge; });
    detach_points(edit, std::move(bow_ties), {});
  }

  // All points at the places of the junctions and of the ends of their sides.
  void mark_places(const NearPoints& near, const std::vector<TJunction>& junctions) {
    std::vector<bool> is_place(mesh.vertex_slots(), false);
    for (const TJunction& junction : junctions)
      for (const Vertex v : {junction.point, mesh.from(junction.side), mesh.to(junction.side)})
        is_place[near.first[near.point_of[v.index].index].index] = true;
    for (std::uint32_t i = 0; i < is_concerned_.size(); ++i)
      is_concerned_[i] = near.point_of[i] && is_place[near.first[near.point_of[i].index].index];
  }

  // Points of one side come from its end to its start, so the side is always the part at the start.
  void put_in(Edit& edit, const TJunction& junction) {
    if (parts_.empty() || junction.side != side_) {
      end_of_side_ = 1;
      last_ = no_index;
    }
    side_ = junction.side;
    const SplitEdge op{side_, end_of_side_ > 0 ? junction.share / end_of_side_ : 0, mesh.position(junction.point)};
    parts_.emplace_back();
    if (reach_.distance > 0 && !op.warnings(mesh).empty()) return;
    OpEffect effect;
    put_point_into(edit, side_, op.along, *op.place, CutTriangles::yes, effect);
    is_concerned_.resize(mesh.vertex_slots(), true);
    Edge behind;
    for (const Element& made : effect.created)
      if (made.kind == Element::Kind::edge && mesh.is_boundary(made.edge())) behind = made.edge();
    parts_.back() = {edge(side_), behind};
    if (last_ != no_index) parts_[last_][0] = behind;
    last_ = static_cast<std::uint32_t>(parts_.size() - 1);
    end_of_side_ = junction.share;
  }

  Reach reach_;
  std::vector<bool> is_concerned_;  // by vertex: what may be welded
  Halfedge side_;
  double end_of_side_ = 1;                  // the share of the original one at which it ends now
  std::uint32_t last_ = no_index;           // the junction at which it ends
  std::vector<std::array<Edge, 2>> parts_;  // by junction; none: it was not put in
};

struct Stitched {
  Mesh mesh;
  std::size_t points = 0;
};

// Puts in what can be joined; nothing where there is nothing.
std::optional<Stitched> stitch_once(const Mesh& mesh, const Reach& reach, Progress& progress) {
  constexpr int patient = 3, most_tries = 8;
  const NearPoints near = find_near_points(mesh, reach);
  std::vector<TJunction> junctions = find_t_junctions(mesh, near, reach.distance);
  for (int tries = 0; tries < most_tries && !junctions.empty() && progress.go_on(); ++tries) {
    Stitching stitching(mesh, near, reach, junctions);
    const std::vector<bool> is_joined = stitching.weld(progress);
    if (progress.is_cancelled()) return std::nullopt;
    std::vector<Halfedge> in_vain;
    std::vector<TJunction> rest;
    for (std::size_t i = 0; i < junctions.size(); ++i)
      is_joined[i] ? rest.push_back(junctions[i]) : in_vain.push_back(junctions[i].side);
    if (in_vain.empty()) return Stitched{std::move(stitching.mesh), junctions.size()};
    if (tries >= patient)  // then all at their sides, so that this ends soon
      std::erase_if(rest,
                    [&](const TJunction& j) { return std::binary_search(in_vain.begin(), in_vain.end(), j.side); });
    junctions = std::move(rest);
  }
  return std::nullopt;
}

}  // namespace

AlgorithmResult stitch(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const Reach reach{input.values.length("distance"), input.used_elsewhere};
  AlgorithmResult result;
  std::optional<Mesh> stitched;
  while (auto more = stitch_once(stitched ? *stitched : edit.mesh(), reach, progress)) {
    result.changed += more->points;
    stitched = std::move(more->mesh);
  }
  if (progress.is_cancelled()) return {};
  result.text = count_text(result.changed, "One vertex was put into the edge it lies on.",
                           "# vertices were put into the edges they lie on.",
                           "稜線の上にある頂点を # 個、その稜線に入れて縫合しました。");
  if (!stitched) return result;
  if (reach.distance > 0 && progress.go_on()) add_new_crossings(edit.mesh(), *stitched, result);
  edit.replace(stitched->columns());
  return result;
}

}  // namespace ryosen
