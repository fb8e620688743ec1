#include "ryosen/algo/repair/fill_holes.h"

#include <algorithm>
#include <array>
#include <optional>

#include "ryosen/algo/repair/fill_report.h"
#include "ryosen/algo/repair/patch_crossings.h"
#include "ryosen/algo/repair/plan_patch.h"
#include "ryosen/algo/repair/remove_degenerate.h"
#include "ryosen/algo/repair/side_effects.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/sheets.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

void derive_as_mean(Edit& edit, std::span<const Vertex> sources, Vertex to) {
  const std::vector<double> weights(sources.size(), 1 / static_cast<double>(sources.size()));
  edit.derive(to, sources, weights, Derivation::copies);
}

// Puts a planned patch into the mesh. The faces take the values (material, group) of a face at the loop, new vertices
// the mean of those around them. The boundary vertices may then need Sheets::make_manifold. Cost: the patch and the
// valences at the loop.
void insert_patch(Edit& edit, const HoleLoop& hole, const HolePatch& patch) {
  const std::uint32_t n = patch.corners;
  std::vector<Vertex> loop;
  std::unordered_map<std::uint64_t, Halfedge> halfedges;
  const auto known = [&](std::uint32_t a, std::uint32_t b) -> Halfedge& {
    return halfedges[std::uint64_t{a} << 32u | b];
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    loop.push_back(edit.mesh().from(hole.sides[i]));
    known(i, (i + 1) % n) = hole.sides[i];
  }
  std::vector<Vertex> vertices = loop;
  for (std::uint32_t v = n; v < patch.places.size(); ++v) {
    vertices.push_back(edit.add_vertex(patch.places[v]));
    const auto& [a, b, c] = patch.parents[v - n];
    if (a == no_index)
      derive_as_mean(edit, loop, vertices[v]);
    else
      derive_as_mean(edit, std::array{vertices[a], vertices[b], vertices[c]}, vertices[v]);
  }
  const auto side = [&](std::uint32_t a, std::uint32_t b) {
    if (const Halfedge h = known(a, b)) return h;
    const Halfedge h = edit.add_edge(vertices[a], vertices[b]);
    edit.fresh(edge(h));
    known(a, b) = h;
    known(b, a) = twin(h);
    if (a >= n) edit.set_halfedge(vertices[a], h);
    if (b >= n) edit.set_halfedge(vertices[b], twin(h));
    return h;
  };
  for (const CornerTriangle& t : patch.triangles) {
    const std::array<Halfedge, 3> h{side(t[0], t[1]), side(t[1], t[2]), side(t[2], t[0])};
    const Face f = edit.add_face(h[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      edit.connect(h[k], h[(k + 1) % 3]);
      edit.set_face(h[k], f);
      edit.fresh(h[k]);
    }
    edit.derive(f, edit.mesh().face(twin(hole.sides[0])), Derivation::copies);
  }
  for (Vertex v : loop) hold_outside(edit, v);
}

struct FillValues {
  std::optional<double> most_edges;
  std::string_view shape = "auto";
  bool allows_crossings = false;
};

FillValues values_of(const ParameterValues& values) {
  FillValues read;
  if (values.rows().empty()) return read;
  if (values.has("most_edges")) read.most_edges = static_cast<double>(values.count("most_edges"));
  read.shape = values.choice("shape");
  read.allows_crossings = values.choice("crossing") == "allow";
  return read;
}

class HoleFiller {
 public:
  HoleFiller(Edit& edit, const FillValues& values, std::optional<bool> holds_floats, Progress& progress)
      : edit_(edit), values_(values), holds_floats_(holds_floats), progress_(progress) {}

  // Where holes are filled, further faces without area may be mended.
  void run() {
    join_loops(edit_, {});  // as reading does
    mend();
    do {
      const std::vector<Vertex> joined = part_loops(edit_);  // holes that touch in a point are filled one by one
      read_holes();
      fill_all();
      join_loops(edit_, joined);
    } while (!progress_.is_cancelled() && mend() > 0);
    if (!progress_.is_cancelled()) tell_coinciding_borders(mesh(), holes_);
  }

  AlgorithmResult result() const { return fill_report(mesh(), filled_, holes_); }
  bool has_crossings() const { return filled_.crossing > 0; }

 private:
  const Mesh& mesh() const { return edit_.mesh(); }

  std::vector<Hole> all_holes() const { return find_holes(mesh(), values_.most_edges, progress_); }

  // Removes faces without area at rims that could be filled, and those that then lie there. Returns how many went.
  std::size_t mend() {
    for (std::size_t all = 0;;) {
      std::vector<Face> at_rims;
      for (const Hole& hole : all_holes()) {
        if (hole.cause != WhyOpen::untried) continue;
        for (Halfedge h : loop(mesh(), hole.start)) at_rims.push_back(mesh().face(twin(h)));
      }
      const std::size_t mended = mend_degenerate_faces(edit_, std::move(at_rims), progress_);
      filled_.mended += mended;
      all += mended;
      if (mended == 0 || progress_.is_cancelled()) return all;
    }
  }

  void read_holes() {
    holes_ = all_holes();
    bases_.assign(holes_.size(), {});
    conflicts_.assign(holes_.size(), false);
    rims_ = read_rims(mesh(), holes_, values_.shape, holds_floats_);
    tell_flat_sheets(mesh(), rims_, holes_);
  }

  // Holes that a patch has touched since they were tried are tried again.
  void fill_all() {
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < holes_.size(); ++i)
      if (holes_[i].cause == WhyOpen::untried) open.push_back(i);
    while (!open.empty()) {
      touched_.assign(mesh().vertex_slots(), false);
      for (std::uint32_t i : open) holes_[i] = {holes_[i].start};
      try_all(Takes::clear, open, [](std::uint32_t) { return true; });
      try_all(Takes::first, open, [&](std::uint32_t i) { return conflicts_[i]; });
      if (values_.allows_crossings)
        for (const Takes takes : {Takes::crossing, Takes::self_crossing})
          try_all(takes, open, [&](std::uint32_t i) { return holes_[i].cause == WhyOpen::crosses; });
      if (progress_.is_cancelled()) return;
      std::erase_if(open, [&](std::uint32_t i) { return !is_touched(holes_[i]); });
    }
  }

  bool is_touched(const Hole& hole) const {
    for (Halfedge h : loop(mesh(), hole.start))
      if (touched_[point(mesh(), mesh().from(h)).index]) return true;
    return false;
  }

  // Tries one way after the other on open holes for which this is.
  template <class Is>
  void try_all(Takes takes, std::vector<std::uint32_t>& open, Is is) {
    std::vector<std::uint32_t> chosen;
    std::copy_if(open.begin(), open.end(), std::back_inserter(chosen), is);
    for (std::size_t way = 0; !chosen.empty() && !progress_.is_cancelled(); ++way) {
      std::vector<std::uint32_t> with_way;
      for (std::uint32_t i : chosen)
        if (way < ways_to_fill(rims_.styles[i]).size()) with_way.push_back(i);
      if (with_way.empty()) break;
      try_way(takes, way, with_way);
      std::erase_if(chosen, [&](std::uint32_t i) { return holes_[i].cause == WhyOpen::filled; });
    }
    std::erase_if(open, [&](std::uint32_t i) { return holes_[i].cause == WhyOpen::filled; });
  }

  void try_way(Takes takes, std::size_t way, const std::vector<std::uint32_t>& open) {
    const JoinedCorners joined = joined_corners(mesh(), holes_, open);
    NormalsOfFaces normals;
    // The first way does most of the work; it tells how far it is, later ones only that they live.
    Progress alive([this](double) { return progress_.go_on(); }, {});
    Progress& progress = is_first_ ? progress_ : alive;
    planned_.clear();
    arranged_.clear();
    planned_for_.clear();
    for (std::uint32_t k = 0; k < open.size(); ++k) {
      if (is_first_) progress_.begin_part(k, open.size() + 1);
      if (!progress.go_on()) return;
      plan(takes, way, open[k], {read_hole(mesh(), holes_[open[k]].start, joined, normals), {}}, progress);
      if (progress.is_cancelled()) return;
    }
    if (is_first_) progress_.begin_part(open.size(), open.size() + 1);
    is_first_ = false;
    if (!planned_.empty()) insert_sound(takes, way);
    for (std::uint32_t i : open)
      if (holes_[i].cause == WhyOpen::filled || is_touched(holes_[i])) bases_[i].clear();
  }

  void plan(Takes takes, std::size_t way_number, std::uint32_t i, PlannedPatch planned, Progress& progress) {
    const WayToFill& way = ways_to_fill(rims_.styles[i])[way_number];
    PatchStyle style = rims_.styles[i];
    style.may_cross = takes >= Takes::crossing;
    const HolePatch* const like = arranged_like(i);
    HolePatch arranged;
    PlanResult result;
    if (like) arranged = patch_like(*like, *rims_.equal[i], planned.hole);
    if (!like || !joins_freely(planned.hole, arranged)) {
      arranged = {};
      result = arrange_patch(way, base_of(i, way, planned.hole, progress), planned.hole, style, arranged, progress);
    }
    planned.patch = arranged;
    if (result.cause == WhyOpen::filled) result = finish_patch(way, planned.hole, style, planned.patch, progress);
    if (progress.is_cancelled()) return;
    if (result.cause != WhyOpen::filled) {
      if (result.crossed) note_crossed(i, mesh().face(twin(result.crossed)));
      holes_[i].cause = std::max(holes_[i].cause, result.cause);
      return;
    }
    planned_.push_back(std::move(planned));
    planned_for_.push_back(i);
    arranged_.push_back(rims_.is_like[i] ? std::move(arranged) : HolePatch());
  }

  // The patch that is arranged in this way for the rim that this one equals, if it is of the same style.
  const HolePatch* arranged_like(std::uint32_t i) const {
    if (!rims_.equal[i]) return nullptr;
    const auto at = std::lower_bound(planned_for_.begin(), planned_for_.end(), rims_.equal[i]->as);
    if (at == planned_for_.end() || *at != rims_.equal[i]->as) return nullptr;
    const PatchStyle &own = rims_.styles[i], &other = rims_.styles[*at];
    if (own.fairs != other.fairs || own.plane.has_value() != other.plane.has_value()) return nullptr;
    return &arranged_[static_cast<std::size_t>(at - planned_for_.begin())];
  }

  static bool joins_freely(const HoleLoop& hole, const HolePatch& patch) {
    return std::all_of(patch.triangles.begin(), patch.triangles.end(),
                       [&](const CornerTriangle& t) { return hole.allows(t); });
  }

  void note_crossed(std::uint32_t i, Face crossed) {
    if (!holes_[i].crossed) holes_[i].crossed = crossed;
  }

  // Made once for the ways that begin with it, while no patch touches the hole.
  const HoleTriangles& base_of(std::uint32_t i, const WayToFill& way, const HoleLoop& hole, Progress& progress) {
    for (const Base& base : bases_[i])
      if (base.by == way.triangulate) return base.triangles;
    return bases_[i].emplace_back(Base{way.triangulate, way.triangulate(hole, progress)}).triangles;
  }

  void insert_sound(Takes takes, std::size_t way) {
    const PatchChoice choice = choose_patches(mesh(), planned_, takes, progress_);
    if (progress_.is_cancelled()) return;
    std::vector<Vertex> corners;
    for (std::uint32_t k = 0; k < planned_.size(); ++k) {
      if (!progress_.go_on()) return;
      const std::uint32_t i = planned_for_[k];
      if (choice.crossed[k]) note_crossed(i, choice.crossed[k]);
      if (choice.conflicts[k]) conflicts_[i] = true;
      holes_[i].cause = std::max(holes_[i].cause, choice.cause[k]);
      if (choice.cause[k] != WhyOpen::filled) continue;
      for (Halfedge h : planned_[k].hole.sides) corners.push_back(mesh().from(h));
      insert(takes, way, k);
    }
    Sheets(edit_).make_manifold(corners);
  }

  void insert(Takes takes, std::size_t way_number, std::uint32_t k) {
    const auto& [hole, patch] = planned_[k];
    const PatchStyle& style = rims_.styles[planned_for_[k]];
    const WayToFill& way = ways_to_fill(style)[way_number];
    for (Vertex point : hole.points) touched_[point.index] = true;
    insert_patch(edit_, hole, patch);
    ++(way.fineness == Fineness::bare   ? filled_.bare
       : !style.fairs                   ? filled_.flat
       : way.fineness == Fineness::fair ? filled_.fair
                                        : filled_.unfaired);
    filled_.crossing += takes >= Takes::crossing;
    filled_.faces += patch.triangles.size();
    filled_.vertices += patch.new_vertices();
  }

  Edit& edit_;
  const FillValues& values_;
  std::optional<bool> holds_floats_;  // of the file, if its type tells it
  Progress& progress_;
  bool is_first_ = true;
  std::vector<Hole> holes_;
  Rims rims_;                    // of these
  std::vector<bool> conflicts_;  // by hole: whether its patch and another one excluded each other
  struct Base {
    decltype(WayToFill::triangulate) by;
    HoleTriangles triangles;
  };
  std::vector<std::vector<Base>> bases_;  // by hole
  std::vector<bool> touched_;             // by vertex: points on loops that were filled
  // For the current way: the patches, their holes in ascending order, and the unfinished patches for equal rims.
  std::vector<PlannedPatch> planned_;
  std::vector<std::uint32_t> planned_for_;
  std::vector<HolePatch> arranged_;
  FilledHoles filled_;
};

}  // namespace

AlgorithmResult fill_holes(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const FillValues values = values_of(input.values);
  const std::optional<Mesh> before = values.allows_crossings ? std::optional(edit.mesh()) : std::nullopt;
  HoleFiller filler(edit, values, input.holds_floats, progress);
  filler.run();
  if (progress.is_cancelled()) return {};
  AlgorithmResult result = filler.result();
  if (filler.has_crossings()) add_new_crossings(*before, edit.mesh(), result);
  return result;
}

}  // namespace ryosen
