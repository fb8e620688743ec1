#include "ryosen/algo/simplify/nearer_farthest.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ryosen/algo/simplify/input_search.h"
#include "ryosen/base/parallel.h"
#include "ryosen/geometry/closest.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();
// Places whose square is more than this share of the largest are looked at, no more of them than these, and each so
// often at most.
constexpr double least_share = 0.25;
constexpr std::size_t most_places = 2000;
constexpr int most_turns = 8;
// So many looks at samples and triangles of the input are enough to find moves: at least, and by the number of samples.
constexpr std::size_t enough_looks = 500'000, looks_per_sample = 8;
// A move brings the largest square around a vertex to less than this share of what it was. All moves of a vertex bring
// the sum of the squares of its samples to at most so many times what it was before them.
constexpr double most_left = 0.9, most_growth = 2;
// A corner that shares less in a place would have to move far to move it.
constexpr double least_corner_share = 0.2;

// A place on a triangle that lies far from the input, by its shares in the corners; the one nearest to a sample, if it
// is that which lies far.
struct FarPlace {
  double square;
  Halfedge corner;  // the first one
  glm::dvec3 shares;
  std::uint32_t sample = no_index;
  glm::dvec3 way{0.0};  // to the input, where it is known
  friend bool operator<(const FarPlace& a, const FarPlace& b) {
    return std::tuple(-a.square, a.corner.index, a.sample, a.shares.x) <
           std::tuple(-b.square, b.corner.index, b.sample, b.shares.x);
  }
};

class Farthest {
 public:
  Farthest(Edit& edit, CollapseSurface& surface, const NearSamples& samples, const Mesh& input, DistanceGuard* guard)
      : mesh_(edit.mesh()),
        surface_(surface),
        samples_(samples),
        input_(input, surface.scale()),
        mover_(edit, surface, guard),
        rounding_(std::max(1e-12, 16 * surface.scale().rounding())),
        most_looks_(std::max(enough_looks, looks_per_sample * samples.size())) {}

  void bring_all_nearer(Progress& progress) {
    const std::vector<FarPlace> places = find(progress);
    if (places.empty()) return;
    // The largest square of a place that stays: no other needs to be less. Places that were not found are below.
    double stays = places.size() == most_places ? places.back().square : least_share * places.front().square;
    for (const FarPlace& place : places) {
      if (place.square <= stays) return;
      for (int turn = 0; turn <= most_turns; ++turn) {
        if (looks_ > most_looks_ || !progress.go_on()) return;
        const FarPlace now = looked_up(place);
        if (now.square <= stays) break;
        if (turn < most_turns && bring_nearer(now)) continue;
        stays = std::min(place.square, now.square);
        break;
      }
    }
  }

  NearerMoves moves() const {
    NearerMoves moves = mover_.moves();
    moves.looks = looks_;
    return moves;
  }

 private:
  using Corners = std::array<glm::dvec3, 3>;
  using Samples = std::vector<std::uint32_t>;

  bool is_triangle_at(Halfedge h) const { return mesh_.face(h) && is_triangle(mesh_, h); }
  std::array<Vertex, 3> vertices_at(Halfedge h) const {
    return {mesh_.from(h), mesh_.to(h), mesh_.from(mesh_.prev(h))};
  }
  Corners corners_at(Halfedge h) const {
    const auto [a, b, c] = vertices_at(h);
    return {surface_.place(a), surface_.place(b), surface_.place(c)};
  }
  glm::dvec3 point_of(const FarPlace& place) const {
    const Corners corners = corners_at(place.corner);
    return place.shares.x * corners[0] + place.shares.y * corners[1] + place.shares.z * corners[2];
  }

  void add_samples(Halfedge h, Samples& around) const {
    if (mesh_.face(h)) samples_.for_each(mesh_.face(h), [&](std::uint32_t i) { around.push_back(i); });
  }
  void find_samples(Vertex v, Samples& around) const {
    around.clear();
    for (const Halfedge h : outgoing(mesh_, v)) add_samples(h, around);
  }

  // The samples about a vertex or the middle of an edge.
  void find_samples(const FarPlace& place, Samples& around) const {
    if (place.shares.x == 1) return find_samples(mesh_.from(place.corner), around);
    around.clear();
    for (const Halfedge side : {place.corner, twin(place.corner)}) add_samples(side, around);
  }

  // The distance of a place from the input, searched from the nearest of these samples; one whose square is `enough`
  // will do.
  InputSearch::Near from_input(const glm::dvec3& place, const Samples& around, double enough = 0) const {
    double least = unknown;
    std::uint32_t nearest = no_index;
    for (const std::uint32_t i : around) {
      const glm::dvec3 way = place - samples_.sample(i).place;
      if (!(squared(way) < least)) continue;
      least = squared(way);
      nearest = i;
      if (least <= enough) return {way, least};  // samples are on the input
    }
    if (nearest == no_index) return {};
    const Halfedge corner = samples_.corner_of_input(nearest);
    return corner ? input_.nearest(place, corner, enough) : InputSearch::Near();
  }

  // Far places among those of a part of the elements.
  struct Found {
    double largest;
    double rounding;  // a square; what is less is none
    std::vector<FarPlace> places = {};
    Samples around = {};  // to be reused

    double enough() const { return std::max(least_share * largest, rounding); }
    void add(const FarPlace& place) {
      if (!(place.square > enough() && place.square < unknown)) return;
      largest = std::max(largest, place.square);
      places.push_back(place);
    }
    // Leaves the farthest ones, as many as are looked at.
    void drop_lower() {
      std::erase_if(places, [&](const FarPlace& place) { return !(place.square > enough()); });
      if (places.size() <= most_places) return;
      std::nth_element(places.begin(), places.begin() + most_places, places.end());
      places.resize(most_places);
    }
  };
  // Asks look(i, found) for each i below the count, and adds what is found, as far as it is not cancelled.
  template <class Look>
  void find_among(std::uint32_t count, Found& all, Progress& progress, const Look& look) const {
    constexpr std::uint32_t piece = 1 << 16;
    const unsigned threads = threads_for(count);
    for (std::uint32_t first = 0; first < count && progress.go_on(); first += piece) {
      std::vector<Found> parts(threads, Found{all.largest, all.rounding});
      for_each_part(std::min(piece, count - first), threads,
                    [&](unsigned part, std::uint32_t begin, std::uint32_t end) {
                      for (std::uint32_t i = begin; i < end; ++i) look(first + i, parts[part]);
                    });
      for (const Found& part : parts)
        for (const FarPlace& place : part.places) all.add(place);
      all.drop_lower();
    }
  }

  // The farthest first; none where it was cancelled.
  std::vector<FarPlace> find(Progress& progress) const {
    Found all{0, rounding_ * rounding_};
    find_among(mesh_.face_slots(), all, progress,
               [&](std::uint32_t i, Found& found) { look_at_samples(Face(i), found); });
    find_among(mesh_.edge_slots(), all, progress,
               [&](std::uint32_t i, Found& found) { look_at_middle(Edge(i), found); });
    find_among(mesh_.vertex_slots(), all, progress, [&](std::uint32_t i, Found& found) { look_at(Vertex(i), found); });
    if (progress.is_cancelled()) return {};
    std::sort(all.places.begin(), all.places.end());
    return std::move(all.places);
  }
  void look_at_samples(Face f, Found& found) const {
    if (!mesh_.is_alive(f) || !is_triangle_at(mesh_.halfedge(f))) return;
    const Halfedge h = mesh_.halfedge(f);
    const Corners corners = corners_at(h);
    samples_.for_each(f, [&](std::uint32_t i) {
      const double square = square_from_triangle(corners, samples_.sample(i).place);
      if (square > found.enough())
        found.add({square, h, nearest_on_triangle(corners, samples_.sample(i).place).barycentric, i});
    });
  }
  void look_from(FarPlace place, Found& found) const {
    find_samples(place, found.around);
    place.square = from_input(point_of(place), found.around, found.enough()).square;
    found.add(place);
  }
  void look_at_middle(Edge e, Found& found) const {
    if (!mesh_.is_alive(e) || mesh_.is_wire(e)) return;
    const Halfedge h = is_triangle_at(halfedge(e)) ? halfedge(e) : twin(halfedge(e));
    if (!is_triangle_at(h)) return;
    look_from(FarPlace{0, h, {0.5, 0.5, 0}}, found);
  }
  void look_at(Vertex v, Found& found) const {
    if (!mesh_.is_alive(v) || mesh_.is_isolated(v)) return;
    for (const Halfedge h : outgoing(mesh_, v)) {
      if (!is_triangle_at(h)) continue;
      return look_from(FarPlace{0, h, {1, 0, 0}}, found);
    }
  }

  // A far place as it is now. A sample may have come to be nearest to another triangle about it.
  FarPlace looked_up(FarPlace place) {
    if (place.sample == no_index) {
      find_samples(place, around_);
      const InputSearch::Near near = from_input(point_of(place), around_);
      looks_ += around_.size() + near.asked;
      place.way = -near.way;
      place.square = near.square;
      return place;
    }
    const glm::dvec3 sample = samples_.sample(place.sample).place;
    const Halfedge corner = place.corner;
    place.square = square_from_triangle(corners_at(corner), sample);
    for (const Vertex v : vertices_at(corner)) {
      if (is_hub(mesh_, v)) continue;
      for (const Halfedge h : outgoing(mesh_, v)) {
        if (!is_triangle_at(h)) continue;
        ++looks_;
        const double square = square_from_triangle(corners_at(h), sample);
        if (!(square < place.square)) continue;
        place.square = square;
        place.corner = h;
      }
    }
    const NearestPlace near = nearest_on_triangle(corners_at(place.corner), sample);
    place.shares = near.barycentric;
    place.way = sample - near.place;
    return place;
  }

  // The largest square around a vertex at a place, or one that is `enough`.
  double largest_around(Vertex v, const glm::dvec3& p, double enough = unknown) {
    double largest = 0;
    const auto look = [&](const glm::dvec3& place) {
      const InputSearch::Near near = from_input(place, around_, largest);
      largest = std::max(largest, near.square);
      looks_ += around_.size() + near.asked;
    };
    look(p);
    ring_.clear();
    for (const Halfedge h : outgoing(mesh_, v)) {
      if (largest >= enough) return largest;
      const glm::dvec3& x = surface_.place(mesh_.to(h));
      look((p + x) / 2.0);
      if (is_triangle_at(h)) ring_.push_back({p, x, surface_.place(mesh_.from(mesh_.prev(h)))});
    }
    for (const std::uint32_t i : around_) {
      if (largest >= enough) break;
      double least = unknown;
      for (const Corners& corners : ring_) {
        ++looks_;
        least = std::min(least, square_from_triangle(corners, samples_.sample(i).place));
        if (least <= largest) break;
      }
      largest = std::max(largest, least);
    }
    return largest;
  }
  double sum_around(Vertex v, const glm::dvec3& p) {
    looks_ += around_.size();
    double sum = 0;
    for (const Halfedge h : outgoing(mesh_, v)) {
      if (!is_triangle_at(h)) continue;
      const Corners corners{p, surface_.place(mesh_.to(h)), surface_.place(mesh_.from(mesh_.prev(h)))};
      samples_.for_each(mesh_.face(h), [&](std::uint32_t i) {
        const auto [place, area] = samples_.sample(i);
        sum += area * square_from_triangle(corners, place);
      });
    }
    return sum;
  }

  struct Move {
    double largest;  // around the vertex then
    Vertex vertex;
    glm::dvec3 position;
  };
  // Moves the corner whose surroundings come nearest by a move along the way of the place; whether there is one.
  bool bring_nearer(const FarPlace& place) {
    std::vector<Move> moves;
    const std::array<Vertex, 3> vertices = vertices_at(place.corner);
    for (int k = 0; k < 3; ++k) {
      const Vertex v = vertices[k];
      if (place.shares[k] < least_corner_share || !surface_.is_amid_surface(v) || is_hub(mesh_, v)) continue;
      const glm::dvec3 here = surface_.place(v);
      find_samples(v, around_);
      const double wanted = most_left * largest_around(v, here);
      const double most_sum = most_growth * first_sums_.try_emplace(v, sum_around(v, here)).first->second;
      for (const double stride : {1.0, 0.5, 0.25}) {
        const glm::dvec3 position = surface_.scale().restored(here + stride / place.shares[k] * place.way);
        const glm::dvec3 there = surface_.scale().scaled(position);
        if (!mover_.may_move(v, position) || sum_around(v, there) > most_sum) continue;
        if (const double largest = largest_around(v, there, wanted); largest < wanted)
          moves.push_back({largest, v, position});
      }
    }
    std::stable_sort(moves.begin(), moves.end(), [](const Move& a, const Move& b) { return a.largest < b.largest; });
    return std::any_of(moves.begin(), moves.end(),
                       [&](const Move& move) { return mover_.move(move.vertex, move.position); });
  }

  const Mesh& mesh_;
  const CollapseSurface& surface_;
  const NearSamples& samples_;
  InputSearch input_;
  VertexMover mover_;
  double rounding_;            // what may be the distance of equal places
  Samples around_;             // the samples at the faces around a vertex
  std::vector<Corners> ring_;  // the triangles around it
  std::unordered_map<Vertex, double> first_sums_;
  std::size_t looks_ = 0, most_looks_;  // at samples and triangles, for moves
};

}  // namespace

NearerMoves move_farthest(Edit& edit, CollapseSurface& surface, const NearSamples& samples, const Mesh& input,
                          DistanceGuard* guard, Progress& progress) {
  if (!samples.cover_input()) return {};
  Farthest farthest(edit, surface, samples, input, guard);
  farthest.bring_all_nearer(progress);
  return farthest.moves();
}

}  // namespace ryosen
