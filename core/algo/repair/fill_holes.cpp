#include "core/algo/repair/fill_holes.h"

#include <algorithm>
#include <optional>
#include <set>

#include "core/algo/repair/insert_patch.h"
#include "core/algo/repair/patch_crossings.h"
#include "core/algo/repair/plan_patch.h"
#include "core/base/count_text.h"
#include "core/geometry/is_finite.h"
#include "core/geometry/single_precision.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/mesh/names.h"
#include "core/ops/rules/sheets.h"

namespace ryosen {

namespace {

bool are_all_floats(std::span<const glm::dvec3> places) {
  return std::all_of(places.begin(), places.end(),
                     [](const glm::dvec3& p) { return !is_finite(p) || to_single(p) == p; });
}

// The edges that patches make between points of loops.
class EdgesMade {
 public:
  // Adds those of a patch, unless one of them is there.
  bool add(const PlannedPatch& planned) {
    const auto& [hole, patch] = planned;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const CornerTriangle& t : patch.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
        const bool is_side = b == a + 1 || (a == 0 && b == patch.corners - 1);
        if (b < patch.corners && !is_side) edges.push_back(std::minmax(hole.points[a], hole.points[b]));
      }
    sort_unique(edges);
    if (std::any_of(edges.begin(), edges.end(), [&](const auto& edge) { return made_.contains(edge); })) return false;
    made_.insert(edges.begin(), edges.end());
    return true;
  }

 private:
  std::set<std::pair<std::uint32_t, std::uint32_t>> made_;
};

// Gives every fan of faces a vertex of its own, as reading does: their borders are loops of their own then.
Edit& with_fans_apart(Edit& edit) {
  Sheets sheets(edit);
  for (std::uint32_t i = 0; i < edit.mesh().vertex_slots(); ++i)
    if (edit.mesh().is_alive(Vertex(i)) && count_fans(edit.mesh(), Vertex(i)) > 1) sheets.separate(Vertex(i));
  return edit;
}

class HoleFiller {
 public:
  HoleFiller(Edit& edit, std::optional<double> most_edges, Progress& progress)
      : edit_(with_fans_apart(edit)),
        progress_(progress),
        snaps_to_floats_(are_all_floats(edit.mesh().positions())),
        holes_(find_holes(edit.mesh(), most_edges, points_of_vertices(edit.mesh()), progress)),
        bases_(holes_.size()) {}

  // Holes that a patch has touched since they were tried are tried again.
  void run() {
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < holes_.size(); ++i)
      if (holes_[i].cause == WhyOpen::untried) open.push_back(i);
    while (!open.empty()) {
      touched_.assign(mesh().vertex_slots(), false);
      for (std::uint32_t i : open) holes_[i].cause = WhyOpen::untried;
      for (const WayToFill& way : ways_to_fill()) {
        if (!open.empty()) try_way(way, open);
        if (progress_.is_cancelled()) return;
      }
      std::erase_if(open, [&](std::uint32_t i) { return !is_touched(holes_[i]); });
    }
    tell_coinciding_borders(mesh(), holes_);
  }

  AlgorithmResult result() const {
    AlgorithmResult result{filled_, 0, {}};
    result.text = count_text(filled_, "One hole was filled", "# holes were filled", "穴を # 個ふさぎました");
    if (filled_ > 0) {
      result.text = result.text + count_text(faces_, " by # triangle", " by # triangles", "（三角形 #");
      if (vertices_ > 0)
        result.text = result.text + count_text(vertices_, " and # new vertex", " and # new vertices", "、新しい頂点 #");
      result.text.ja += "）";
    }
    for (const WhyOpenRow& row : reasons_to_stay_open()) add_left(row, result);
    if (result.left > 0) {
      result.text.en += "; " + std::to_string(result.left) + " could not be";
      result.text.ja += "。ふさげない穴 " + std::to_string(result.left);
    }
    const bool is_only = result.left_for.size() == 1;
    std::string_view between_en = ": ", between_ja = "：";
    for (const LeftForReason& left : result.left_for) {
      result.text.en +=
          std::string(between_en) + clause(left, is_only, left.reason.en, "because ", ", ", " and # more");
      result.text.ja += std::string(between_ja) + clause(left, is_only, left.reason.ja, "", "、", "、ほか #");
      between_en = "; ";
      between_ja = "、";
    }
    result.text.en += ".";
    result.text.ja += "。";
    return result;
  }

 private:
  const Mesh& mesh() const { return edit_.mesh(); }

  bool is_touched(const Hole& hole) const {
    for (Halfedge h : loop(mesh(), hole.start))
      if (touched_[point(mesh(), mesh().from(h)).index]) return true;
    return false;
  }

  void try_way(const WayToFill& way, std::vector<std::uint32_t>& open) {
    const std::vector<std::uint32_t> points = points_of_vertices(mesh());
    const JoinedCorners joined = joined_corners(mesh(), holes_, open, points);
    NormalsOfFaces normals;
    // The first way does most of the work; it tells how far it is, later ones only that they live.
    Progress alive([this](double) { return progress_.go_on(); }, {});
    Progress& progress = is_first_ ? progress_ : alive;
    std::vector<PlannedPatch> planned;
    std::vector<std::uint32_t> planned_for;
    for (std::uint32_t k = 0; k < open.size(); ++k) {
      if (is_first_) progress_.begin_part(k, open.size() + 1);
      if (!progress.go_on()) return;
      Hole& hole = holes_[open[k]];
      PlannedPatch plan{read_hole(mesh(), hole.start, points, joined, normals), {}};
      const HoleTriangles& base = base_of(open[k], way, plan.hole, progress);
      const WhyOpen cause = plan_patch(way, base, plan.hole, snaps_to_floats_, plan.patch, progress);
      if (progress.is_cancelled()) return;
      if (cause != WhyOpen::filled) {
        hole.cause = std::max(hole.cause, cause);
        continue;
      }
      planned.push_back(std::move(plan));
      planned_for.push_back(open[k]);
    }
    if (is_first_) progress_.begin_part(open.size(), open.size() + 1);
    is_first_ = false;
    if (!planned.empty()) insert_sound(planned, planned_for);
    for (std::uint32_t i : open)
      if (holes_[i].cause == WhyOpen::filled || is_touched(holes_[i])) bases_[i].clear();
    std::erase_if(open, [&](std::uint32_t i) { return holes_[i].cause == WhyOpen::filled; });
  }

  // Made once for the ways that begin with it, while no patch touches the hole.
  const HoleTriangles& base_of(std::uint32_t i, const WayToFill& way, const HoleLoop& hole, Progress& progress) {
    for (const Base& base : bases_[i])
      if (base.by == way.triangulate) return base.triangles;
    return bases_[i].emplace_back(Base{way.triangulate, way.triangulate(hole, progress)}).triangles;
  }

  // Of patches that exclude each other the first is taken.
  void insert_sound(const std::vector<PlannedPatch>& planned, const std::vector<std::uint32_t>& planned_for) {
    PatchCrossings crossings = find_patch_crossings(mesh(), planned, progress_);
    if (progress_.is_cancelled()) return;
    EdgesMade made;
    std::vector<Vertex> corners;
    auto pair = crossings.pairs.begin();
    for (std::uint32_t k = 0; k < planned.size(); ++k) {
      if (!progress_.go_on()) return;
      const auto& [hole, patch] = planned[k];
      Hole& which = holes_[planned_for[k]];
      const bool is_sound = !crossings.crosses[k], adds_edges = is_sound && made.add(planned[k]);
      const WhyOpen cause = !is_sound ? WhyOpen::crosses : !adds_edges ? WhyOpen::edge_exists : WhyOpen::filled;
      which.cause = std::max(which.cause, cause);
      for (; pair != crossings.pairs.end() && pair->first == k; ++pair)
        if (adds_edges) crossings.crosses[pair->second] = true;
      if (!adds_edges) continue;
      for (Halfedge h : hole.sides) corners.push_back(mesh().from(h));
      for (std::uint32_t point : hole.points) touched_[point] = true;
      insert_patch(edit_, hole, patch);
      ++filled_;
      faces_ += patch.triangles.size();
      vertices_ += patch.new_vertices();
    }
    Sheets(edit_).settle(corners);
  }

  void add_left(const WhyOpenRow& row, AlgorithmResult& result) const {
    LeftForReason left{row.text(), {}};
    for (const Hole& hole : holes_) {
      if (hole.cause != row.cause) continue;
      Edge lowest = edge(hole.start);
      for (Halfedge h : loop(mesh(), hole.start)) lowest = std::min(lowest, edge(h));
      left.elements.emplace_back(lowest);
    }
    result.left += left.elements.size();
    if (!left.elements.empty()) result.left_for.push_back(std::move(left));
  }

  // "3 because every patch has a face without area (0-1, 4-8, 9-12)"
  std::string clause(const LeftForReason& left, bool is_only, const std::string& reason, std::string_view because,
                     std::string_view comma, std::string_view more) const {
    constexpr std::size_t most_names = 3;
    const std::size_t named = std::min(most_names, left.elements.size());
    std::string names;
    for (std::size_t i = 0; i < named; ++i)
      names += (i > 0 ? std::string(comma) : "") + name_of(mesh(), left.elements[i]);
    if (named < left.elements.size()) names += with_number(more, left.elements.size() - named);
    // The number has been told where there is one reason alone.
    const std::string counted = is_only ? "" : std::to_string(left.elements.size()) + " " + std::string(because);
    return counted + reason + " (" + names + ")";
  }

  Edit& edit_;
  Progress& progress_;
  bool snaps_to_floats_;
  bool is_first_ = true;
  std::vector<Hole> holes_;
  struct Base {
    decltype(WayToFill::triangulate) by;
    HoleTriangles triangles;
  };
  std::vector<std::vector<Base>> bases_;  // by hole
  std::vector<bool> touched_;             // by vertex: points on loops that were filled
  std::size_t filled_ = 0, faces_ = 0, vertices_ = 0;
};

}  // namespace

AlgorithmResult fill_holes(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  std::optional<double> most_edges;
  if (input.values.has("most_edges")) most_edges = static_cast<double>(input.values.count("most_edges"));
  HoleFiller filler(edit, most_edges, progress);
  filler.run();
  return progress.is_cancelled() ? AlgorithmResult() : filler.result();
}

}  // namespace ryosen
