#include "ryosen/algo/remesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "ryosen/algo/preparation.h"
#include "ryosen/algo/remesh/remesher.h"
#include "ryosen/algo/seams/flat_normals.h"
#include "ryosen/algo/unit_scale.h"
#include "ryosen/analysis/components.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/base/parallel.h"
#include "ryosen/base/resource_limits.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen::remesh {

namespace {

// About how many triangles come of a length of 1, and how many edges of the longest feature; of another length its
// square and itself less.
struct ExpectedSize {
  double triangles = 0, edges = 0;

  double of_length(double length) const { return triangles / (length * length) + edges / length; }
};
ExpectedSize expected_size(const Mesh& mesh, const Sizing& sizing) {
  ExpectedSize size;
  constexpr double of_even = 0.433;  // the area of a triangle whose sides are 1
  const auto share = [&](Vertex v) { return sizing.length_at(v) / sizing.longest(); };
  for (const Face f : live_faces(mesh)) {
    const Halfedge h = mesh.halfedge(f);
    const double area = glm::length(area_normal(corners_of(mesh, h))) / 2;
    if (!std::isfinite(area)) continue;
    for (const Halfedge corner : loop(mesh, h)) {
      const double part = share(mesh.from(corner));
      size.triangles += area / (3 * of_even * part * part);
    }
  }
  for (const Edge e : live_edges(mesh)) {
    const auto [a, b] = ends(mesh, e);
    const double edge = glm::distance(mesh.position(a), mesh.position(b));
    if (std::isfinite(edge)) size.edges = std::max(size.edges, edge / std::min(share(a), share(b)));
  }
  return size;
}

// What there is room for. Elements of a mesh are numbered with 32 bits.
bool fits(double triangles) {
  constexpr double most = 3e8, bytes_per_triangle = 500;
  return triangles < most && may_fit_in_memory(bytes_per_triangle * triangles);
}

// Rounded up to three digits.
std::string length_text(double length) {
  const double step = std::pow(10.0, std::floor(std::log10(length)) - 2);
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", std::ceil(length / step) * step);
  return text;
}

std::optional<Text> fault_of_length(const Mesh& mesh, const Sizing& sizing, double scale) {
  const ExpectedSize size = expected_size(mesh, sizing);
  const auto is_enough = [&](double length) { return fits(size.of_length(length)); };
  if (is_enough(sizing.longest())) return std::nullopt;
  double low = sizing.longest(), high = 2 * low;
  while (!is_enough(high)) low = high, high *= 2;
  for (int step = 0; step < 20; ++step) {
    const double middle = 0.5 * low + 0.5 * high;
    (is_enough(middle) ? high : low) = middle;
  }
  const std::string least = length_text(high / scale);
  return Text{
      "so short a length would make more triangles than there is room for; the shortest that fits here is about " +
          least,
      "この長さでは三角形が多くなりすぎてメモリに収まりません。ここで収まる最小の長さは約 " + least + " です"};
}

// Edges that are left shorter than any that is wanted go, and what grows long beside them is split; where lengths
// differ there are few, since no step has made any.
bool close_up(Remesher& remesher, bool is_adaptive, Progress& progress) {
  constexpr int most_turns = 2, most_removals = 8;
  const auto even_out = [&] {
    return is_adaptive ||
           (remesher.split_long(progress) && remesher.swap_for_valence(progress) && remesher.relax(progress));
  };
  for (int turn = 0; turn < most_turns && !is_adaptive; ++turn)
    if (!(remesher.collapse_short(progress) && even_out())) return false;
  std::size_t left = std::numeric_limits<std::size_t>::max();
  for (int turn = 0; turn < most_removals; ++turn) {
    if (!(remesher.remove_shortest(progress) && even_out() && remesher.swap_slivers(progress))) return false;
    const std::size_t before = std::exchange(left, remesher.short_edges());
    if (left == 0) return true;
    if (left >= before) break;
  }
  return remesher.remove_shortest(progress);
}

bool run_rounds(Remesher& remesher, const Options& options, Progress& progress) {
  const std::size_t rounds = options.rounds;
  for (std::size_t round = 0; round < rounds; ++round) {
    const auto at = [&](std::size_t pass) { return progress.go_on(4 * round + pass, 4 * rounds); };
    if (!(at(0) && remesher.split_long(progress) && at(1) && remesher.collapse_short(progress) && at(2) &&
          remesher.swap_for_valence(progress) && at(3) && remesher.relax(progress)))
      return false;
  }
  remesher.begin_closing();
  return close_up(remesher, options.adaptive, progress);
}

// With the places in the old size, those that did not move to the bit.
MeshColumns unscaled(const Mesh& mesh, const Mesh& before, double scale) {
  MeshColumns columns = mesh.columns();
  for (std::size_t i = 0; i < columns.positions.size(); ++i) {
    const bool is_old = i < before.vertex_slots();
    const glm::dvec3 old = is_old ? before.position(Vertex(i)) : glm::dvec3(0);
    columns.positions[i] = is_old && columns.positions[i] == old * scale ? old : columns.positions[i] / scale;
  }
  return columns;
}

// The pairs of faces that meet; none if there are more, or cancelled.
std::optional<std::vector<FacePair>> crossings_of(const Mesh& mesh, std::size_t most, Progress& progress) {
  auto found = find_few_self_intersections(mesh, most, progress);
  if (!found || !found->is_all()) return std::nullopt;
  return std::move(found->pairs);
}

// Boxes of the part that two faces have in common. Of a line, along it: one box of all would hold what lies far from
// it.
std::vector<Box> pieces_of_common_part(const Mesh& mesh, const FacePair& pair, double length) {
  constexpr double most = 256;
  const TriangleCorners a = corners_of(mesh, mesh.halfedge(pair.first)),
                        b = corners_of(mesh, mesh.halfedge(pair.second));
  const Box all = common_box(a, b);
  const glm::dvec3 way = all.highest - all.lowest, along = glm::cross(unit_normal(mesh, mesh.halfedge(pair.first)),
                                                                      unit_normal(mesh, mesh.halfedge(pair.second)));
  const double pieces = std::clamp(std::ceil(glm::length(way) / length), 1.0, most);
  if (!(glm::dot(along, along) > 0) || !(pieces > 1)) return {all};
  const auto at = [&](double share) {
    glm::dvec3 place;
    for (int axis = 0; axis < 3; ++axis)
      place[axis] = all.lowest[axis] + (along[axis] < 0 ? 1 - share : share) * way[axis];
    return place;
  };
  std::vector<Box> boxes;
  for (double i = 0; i < pieces; ++i) {
    Box piece{at(i / pieces), at(i / pieces)};
    piece.add(at((i + 1) / pieces));
    boxes.push_back(piece);
  }
  return boxes;
}

// The places at which faces meet, and those that lie within a reach of them.
MetPlaces places_of(const Mesh& mesh, std::span<const FacePair> pairs, double reach) {
  Neighbourhood around(mesh);
  std::vector<std::uint32_t> parts = find_face_components(around).of_face;
  std::vector<MetPlaces::Place> places;
  for (const FacePair& pair : pairs)
    for (const Box& common : pieces_of_common_part(mesh, pair, reach))
      places.push_back(
          {{common.lowest - reach, common.highest + reach}, parts[pair.first.index], parts[pair.second.index]});
  return MetPlaces(std::move(parts), places);
}

// What is known of a surface before it changes.
struct Start {
  std::optional<Target> target;
  Features features;
  std::optional<CoveredPoints> points;

  Start(const Mesh& triangles, const Sizing& sizing, const Options& options) {
    do_beside([&] { target.emplace(triangles, sizing); },
              [&] {
                features = find_features(triangles, options.feature_angle_rad, options.seams);
                for (const Vertex v : options.on_lines) features.vertices[v.index] = Features::held;
                points.emplace(triangles, features, sizing.shortest());
              });
  }
};

// Remeshing in attempts, each of which watches more closely than the one before.
class Attempts {
 public:
  Attempts(const Mesh& triangles, const Options& options, const Start& known)
      : start_(triangles), options_(options), known_(known), watched_(options.length) {}

  // Until no faces meet that did not.
  void run(Remeshed& result, Progress& progress, Descent* descent) {
    constexpr int most = 4;
    for (int attempt = 0; attempt < most; ++attempt) {
      Mesh work = start_;
      Descent descent_now = descent ? *descent : Descent();
      Edit edit(work, nullptr, &descent_now);
      SurfaceKeeper keeper(work, *known_.points, watched_, met_);
      Remesher remesher(edit, known_.features, *known_.target, keeper);
      result.is_cancelled = !run_rounds(remesher, options_, progress);
      if (!result.is_cancelled) remesher.take_values(start_);
      result.held_by_seams = remesher.held_by_seams();
      edit.commit();
      result.refused = keeper.refused();
      if (result.is_cancelled || !watches_more(work, attempt + 2 == most, progress)) {
        result.is_cancelled |= progress.is_cancelled();
        result.columns = std::move(work).columns();
        if (descent) *descent = std::move(descent_now);
        return;
      }
    }
  }

 private:
  bool watches_more(const Mesh& made, bool all, Progress& progress) {
    constexpr std::size_t most_before = 100000, most_after = 20 * most_before;  // the same crossing on smaller faces
    if (watched_.is_all()) return false;
    // First how many did before: too many are made out sooner there.
    if (!before_) before_ = crossings_of(start_, most_before, progress);
    if (!before_) return false;
    const auto pairs = crossings_of(made, most_after, progress);
    if (!pairs || pairs->empty()) return false;
    if (watched_.is_empty()) met_ = places_of(start_, *before_, options_.length);
    bool is_new = false;
    for (const FacePair& pair : *pairs) {
      const TriangleCorners a = corners_of(made, made.halfedge(pair.first)),
                            b = corners_of(made, made.halfedge(pair.second));
      if (met_.hold(a, b)) continue;
      Box both = box_of(a);
      both.add(box_of(b));
      watched_.add(both);
      is_new = true;
    }
    if (is_new && all) watched_.add_all();
    return is_new && !progress.is_cancelled();
  }

  const Mesh& start_;
  const Options& options_;
  const Start& known_;
  WatchedPlaces watched_;
  std::optional<std::vector<FacePair>> before_ = {};  // that met before
  MetPlaces met_;                                     // where they did
};

}  // namespace

Remeshed remeshed(const Mesh& mesh, const Options& options, Progress& progress, Descent* descent) {
  Remeshed result;
  result.is_cancelled = !progress.go_on(0, options.rounds);
  if (result.is_cancelled) return result;
  const double scale = unit_scale(mesh.positions());
  Options own = options;
  own.length *= scale;
  own.tolerance *= scale;
  MeshColumns columns = mesh.columns();
  for (glm::dvec3& p : columns.positions) p *= scale;
  Mesh triangles(std::move(columns));
  const std::vector<std::uint8_t> flat = prepare_seams(triangles, options.seams);
  Descent own_descent;
  if (!flat.empty() && !(descent && descent->is_recording())) descent = &(own_descent = Descent(mesh));
  Edit edit(triangles, nullptr, descent);
  const std::vector<Face> polygons = polygons_of_mesh(triangles);
  result.cut_faces = polygons.size();
  if ((result.fault = cut_faces(edit, polygons))) return result;
  share_equal_values(edit);
  edit.commit();
  const Sizing sizing(triangles, {own.length, own.adaptive, own.tolerance});
  if ((result.fault = fault_of_length(triangles, sizing, scale))) return result;
  const Start start(triangles, sizing, own);
  Attempts(triangles, own, start).run(result, progress, descent);
  if (result.is_cancelled) return result;
  Mesh made(unscaled(Mesh(std::move(result.columns)), mesh, scale));
  if (!flat.empty()) put_flat_normals(made, flags_of_parts(flat, made, *descent), mesh);
  result.columns = std::move(made).columns();
  return result;
}

}  // namespace ryosen::remesh
