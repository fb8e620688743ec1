// The surface while it is simplified: its places, what each vertex has come to stand for, and what may become of an
// edge.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "ryosen/algo/edge_rules.h"
#include "ryosen/algo/seams/seam_mode.h"
#include "ryosen/algo/simplify/attribute_error.h"
#include "ryosen/algo/simplify/quadric.h"
#include "ryosen/base/column_memory.h"
#include "ryosen/geometry/box.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/prefetch.h"

namespace ryosen {

// Places about the middle of a mesh, about 1 in size, so that sums of squares neither overflow nor lose the digits that
// matter, wherever the mesh lies and however large it is.
class ScaledPlaces {
 public:
  explicit ScaledPlaces(std::span<const glm::dvec3> places) {
    const Box box = box_of_finite(places);
    if (box.is_empty()) return;
    const glm::dvec3 half = 0.5 * box.highest - 0.5 * box.lowest;
    const double largest = std::max({half.x, half.y, half.z});
    if (largest > 0) std::frexp(largest, &exponent_);
    down_ = factor(-exponent_);
    up_ = factor(exponent_);
    middle_ = scaled_alone(box.middle());
  }

  // Exact but for the rounding of one subtraction.
  glm::dvec3 scaled(const glm::dvec3& p) const { return scaled_alone(p) - middle_; }
  glm::dvec3 restored(const glm::dvec3& q) const { return shifted(q + middle_, up_, exponent_); }
  // The same without moving the middle to the origin: exact but for what is far smaller than the mesh.
  glm::dvec3 scaled_alone(const glm::dvec3& p) const { return shifted(p, down_, -exponent_); }
  double scaled_length(double length) const { return std::ldexp(length, -exponent_); }
  // The rounding of positions, scaled.
  double rounding() const {
    return 0x1p-52 * (1 + std::max({std::abs(middle_.x), std::abs(middle_.y), std::abs(middle_.z)}));
  }
  double restored_length(double length) const { return std::ldexp(length, exponent_); }

 private:
  // 2^exponent; 0 where a double does not hold it.
  static double factor(int exponent) { return std::abs(exponent) <= 1000 ? std::ldexp(1.0, exponent) : 0; }
  static glm::dvec3 shifted(const glm::dvec3& p, double factor, int exponent) {
    if (factor > 0) return factor * p;
    return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  }

  int exponent_ = 0;
  double down_ = 1, up_ = 1;  // factors
  glm::dvec3 middle_{0.0};    // scaled
};

enum class BoundaryMode { free, weighted, locked };

struct CollapseLimits {
  BoundaryMode boundary = BoundaryMode::weighted;
  SeamMode seams = SeamMode::weighed;                      // weighed, a collapse that moves one costs more
  double error = std::numeric_limits<double>::infinity();  // in units of the mesh
  double turn_rad = 1.5707963267948966;                    // a collapse turns a normal by less; at most a quarter turn
  double smallest_angle_rad = 0;          // no face gets a smaller one, or one smaller than it had where that was less
  std::vector<std::uint8_t> fixed = {};   // by vertex slot: not 0, it stays; empty: none has to
  double colour_weight = 0;               // of colours and texture in the order of collapses (attribute_error.h)
  std::span<const Vertex> on_lines = {};  // something beside the mesh hangs on them, so that they stay, too
};

// Which end an edge may lose.
struct Freedom {
  Halfedge halfedge;                  // from the vertex that goes to the one that stays, as far as it matters
  bool is_anchored = false;           // the one that stays keeps its place
  EdgeRule held_by = EdgeRule::free;  // anchored: why; not possible: under which rule
  bool is_possible = true;
};

// A place for the vertex that stays.
struct Placing {
  glm::dvec3 place;
  double squares;        // the sum of the quadrics of both ends there
  double cost;           // of these and a little for a long edge: what decides the order
  Vertex at = Vertex();  // the end whose place it is
};

class CollapseSurface {
 public:
  // Keeps a reference to the mesh, which changes under it by collapses that are told to merge(). Cost: O(corners), on
  // several threads.
  CollapseSurface(const Mesh& mesh, const CollapseLimits& limits);

  const Mesh& mesh() const { return mesh_; }
  const glm::dvec3& place(Vertex v) const { return states_[v.index].place; }
  const ScaledPlaces& scale() const { return scale_; }
  bool holds_seams() const { return seams_ == SeamMode::kept; }
  bool is_feature(Edge e) const { return !edge_flags_.empty() && edge_flags_[e.index] & feature; }

  // Points of a weighted boundary stay on it: edges that lead into the surface go to them, as long as they are kept.
  bool keeps_boundaries() const { return keeps_boundaries_; }
  void keep_boundaries(bool keeps) { keeps_boundaries_ = keeps; }

  Freedom freedom(Halfedge h) const;
  // The lowest place for this edge, or that of its anchor.
  Placing lowest(const Freedom& freedom) const;
  double lowest_cost(Halfedge h) const;
  // Both ends and the middle, lowest cost first; where it is anchored none beside the anchor.
  std::array<Placing, 3> others(const Freedom& freedom) const;
  Placing at_place(const Freedom& freedom, const glm::dvec3& place, Vertex at = {}) const;

  // A distance in scaled units: the root of the mean squared distance from the planes of both ends.
  double error_of(Halfedge h, const Placing& placing) const;
  double error_limit() const { return error_; }
  // A cost by how far the ends come to lie from the new faces, or these from those of now: planes do not tell where a
  // part ends. 0 where that would take long, at a hub or a polygon.
  double cost_of_gap(Halfedge h, const Placing& placing) const;
  // Whether nothing keeps the vertex in its place.
  bool is_free(Vertex v) const { return !hold(v, true); }
  // Whether it stands for others or has moved.
  bool has_changed(Vertex v) const { return states_[v.index].merges > 0; }
  // The same as is_free(), nor any line that it lies on: of a boundary, a seam, or a border of a material or group.
  bool is_amid_surface(Vertex v) const;
  bool limits_error() const { return error_ < std::numeric_limits<double>::infinity(); }
  // What a face is to look along beside its own normal, which is no rule: where collapses that spoil this come last,
  // small turns do not add up to a large one.
  enum class Minds {
    input,   // the faces that its corners stand for; at boundaries and kept seams clearly
    lines,   // the same, of faces with two corners or more on a boundary alone
    nothing  // the same, of faces with two locked corners or more alone
  };
  // Whether a face would turn too far or lose its area, or look against what it minds. Judged to the bit of what is
  // written where a face is so small that scaling may lose its shape.
  bool turns_face(Halfedge h, const Placing& placing, Minds minds = Minds::nothing) const;
  // That of a placing, in units of the mesh; to the bit that of an end where it is one.
  glm::dvec3 position_of(const Placing& placing) const {
    return placing.at ? mesh_.position(placing.at) : scale_.restored(placing.place);
  }
  // Whether a triangle does not clearly look the way of all that its corners stand for, or that is itself folded.
  bool may_look_against_input(Face f) const;
  // A vertex alone, moved: its error, scaled, and whether a face around it would lose its area, get too small an angle
  // or turn too far; but for one that is to turn.
  double error_of_move(Vertex v, const glm::dvec3& position) const;
  bool move_spoils_face(Vertex v, const glm::dvec3& position, Face mended) const;
  // Whether a face around it would look less along what its corners stand for, and not clearly along that.
  bool move_tilts_face(Vertex v, const glm::dvec3& position) const;
  // Whether one would get too small an angle.
  bool narrows_face(Halfedge h, const glm::dvec3& place) const;

  // Whether an edge between two triangles is no crease, and nothing keeps any vertex of both in its place.
  bool may_swap(Halfedge h) const;
  // Whether a face would turn too far, lose its area or get too small an angle if it were swapped.
  bool swap_spoils_face(Halfedge h) const;

  // Before each collapse: what it makes of the faces of many corners.
  void follow_large_faces(Halfedge h, const Placing& placing);
  // `kept` now stands for `gone` too and has come to the position.
  void merge(Vertex gone, Vertex kept, const glm::dvec3& position);
  // A vertex alone has come to the position.
  void move(Vertex v, const glm::dvec3& position);
  // A new vertex, the next one by its number, stands for what another one stands for.
  void add_copy(Vertex copy, Vertex of);
  // Edges were added, at none of which values differ.
  void add_edges() {
    if (!edge_flags_.empty()) edge_flags_.resize(mesh_.edge_slots());
  }
  // An edge that took the place of another one between the same points.
  void take_over(Edge stays, Edge goes) {
    if (!edge_flags_.empty()) edge_flags_[stays.index] |= static_cast<std::uint8_t>(edge_flags_[goes.index] & feature);
  }

  // The squares that colours and texture add to those of an edge; null where none takes part.
  AttributeError* values() { return values_ ? &*values_ : nullptr; }
  const AttributeError* values() const { return values_ ? &*values_ : nullptr; }

  // What the ends of an edge have become: where it is the same as before, so are their places and what they stand for.
  struct History {
    Vertex a, b;
    std::uint16_t merges_of_a, merges_of_b;
    friend bool operator==(const History&, const History&) = default;
  };
  History history(Halfedge h) const { return history(mesh_.from(h), mesh_.to(h)); }
  History history(Vertex a, Vertex b) const { return {a, b, states_[a.index].merges, states_[b.index].merges}; }

  // While one lives nothing changes, and what is learnt of a hub is kept: how far it may move without turning a face,
  // and which faces turn. So edges of a hub are asked one after the other without walking around it for each.
  class Standstill {
   public:
    explicit Standstill(const CollapseSurface& surface) : surface_(surface) { surface_.is_still_ = true; }
    ~Standstill() {
      surface_.is_still_ = false;
      surface_.hubs_.clear();
    }
    Standstill(const Standstill&) = delete;
    Standstill& operator=(const Standstill&) = delete;

   private:
    const CollapseSurface& surface_;
  };

  // So many corners of faces were looked at so far to see what collapses would make of them.
  std::uint64_t looked_at() const { return looked_at_; }

  void prefetch_ends(Edge e) const;
  void prefetch_place(Vertex v) const { prefetch_cell(states_.data(), v.index); }

 private:
  // All that is asked of a vertex, in two lines of the cache.
  struct State {
    glm::dvec3 place{0.0};
    glm::vec3 normal{0.0f};  // the sum of those of all faces that it stands for, by their areas
    std::uint8_t flags = 0;
    std::uint16_t merges = 0;  // so many, as far as they fit
    Quadric quadric;
  };
  static_assert(sizeof(State) == 128);
  enum VertexFlag : std::uint8_t {
    fixed = 1,
    on_locked_boundary = 2,
    on_feature = 4,
    pinned = 8,
    seam_end = 16,
    seam_tip = 32
  };
  enum EdgeFlag : std::uint8_t { feature = 1 };

  // A face of so many corners that its area is kept and changed with its corners.
  struct LargeFace {
    glm::dvec3 area_vector;
    std::size_t corners, changes = 0;  // changes since it was summed
  };

  void find_large_faces();
  void find_features();
  void sum_planes();
  void sum_planes_at(Vertex v);
  // Whether one seam alone ends at a vertex, within the surface.
  bool is_tip(Vertex v) const;
  void add_edge_plane(Quadric& sum, Halfedge h, double weight) const;
  // Twice the area of a face along its normal, with the ends of an edge at a place.
  glm::dvec3 area_vector(Face f, Vertex a, Vertex b, const glm::dvec3& place) const;
  glm::dvec3 area_vector(Face f) const;
  // The same, corner by corner.
  glm::dvec3 summed_area_vector(Face f, Vertex a, Vertex b, const glm::dvec3& place) const;
  Placing lowest_with_values(const Freedom& freedom, const Quadric& distances) const;
  Placing lowest_on_flat(const Freedom& freedom, const Quadric& sum, const glm::dvec3& place) const;
  std::optional<EdgeRule> hold(Vertex v, bool along_feature) const;
  bool turns_too_far(const glm::dvec3& before, const glm::dvec3& after) const;
  bool turns_small_face(Halfedge corner, const glm::dvec3& position) const;
  // What is known of a vertex of many edges, while it is still.
  struct HubFacts {
    double safe_move = 0;               // so far it may move, scaled, and no face around it turns too far
    std::array<Halfedge, 16> turned{};  // corners of faces that did by other moves, the last ones
    std::uint32_t turns = 0;
  };
  HubFacts* facts_of_hub(Vertex v) const;
  // Calls look(face corner) for what changes its shape until it returns true. Of a vertex of many edges
  // facts_of(vertex) is asked for what may tell it sooner.
  template <class Look, class FactsOf>
  bool any_changed_corner(Halfedge h, const glm::dvec3& place, Look look, FactsOf facts_of) const;
  // How far a vertex may move, scaled, such that no face around it turns too far; 0 where it takes more to tell.
  double safe_move(Vertex v) const;

  const Mesh& mesh_;
  ScaledPlaces scale_;
  BoundaryMode boundary_;
  bool keeps_boundaries_;
  SeamMode seams_;
  double error_, turn_cosine_, angle_cosine_;
  ColumnVector<State> states_;            // by vertex
  std::vector<std::uint8_t> edge_flags_;  // none where there is no seam
  std::optional<AttributeError> values_;
  std::unordered_map<Face, LargeFace> large_faces_;
  mutable std::uint64_t looked_at_ = 0;
  mutable bool is_still_ = false;
  mutable std::unordered_map<Vertex, HubFacts> hubs_;
};

}  // namespace ryosen
