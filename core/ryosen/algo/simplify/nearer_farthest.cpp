#include "ryosen/algo/simplify/nearer_farthest.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>
#include <vector>

#include "ryosen/algo/simplify/input_search.h"
#include "ryosen/base/parallel.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();
// The square of a distance that may be that of rounding. Places are about 1 in size.
constexpr double rounding = 1e-24;
// Places whose square is at least this share of the largest are looked at, no more of them than these, and each so
// often at most.
constexpr double least_share = 0.25;
constexpr std::size_t most_places = 2000;
constexpr int most_turns = 8;
// So many looks at samples and triangles of the input are enough to find moves, by the number of samples.
constexpr std::size_t looks_per_sample = 4;
// A move brings the largest square around a vertex to less than this share of what it was, and the sum of the squares
// of its samples to at most so many times what it was.
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
  friend bool operator<(const FarPlace& a, const FarPlace& b) {
    return std::tuple(-a.square, a.corner.index, a.sample) < std::tuple(-b.square, b.corner.index, b.sample);
  }
};

class Farthest {
 public:
  Farthest(Edit& edit, CollapseSurface& surface, const NearSamples& samples, const Mesh& input, DistanceGuard* guard)
      : mesh_(edit.mesh()),
        surface_(surface),
        samples_(samples),
        input_(input, surface.scale()),
        mover_(edit, surface, guard) {}

  void bring_all_nearer(Progress& progress) {
    const std::vector<FarPlace> places = find();
    if (places.empty()) return;
    most_looks_ = looks_per_sample * samples_.size();
    double stays = places.back().square;  // that of a place that does
    for (const FarPlace& place : places) {
      if (place.square <= stays || looks_ > most_looks_ || !progress.go_on()) return;
      double square = place.square;
      for (int turn = 0; turn < most_turns && square > stays; ++turn) {
        const double now = bring_nearer(place, stays);
        if (!(now < square)) break;
        square = now;
      }
      stays = std::max(stays, square);
    }
  }

  const NearerMoves& moves() const { return mover_.moves(); }

 private:
  using Corners = std::array<glm::dvec3, 3>;
  using Samples = std::vector<std::uint32_t>;

  bool is_triangle_at(Halfedge h) const { return mesh_.face(h) && mesh_.next(mesh_.next(h)) == mesh_.prev(h); }
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
  static double square_from(const Corners& triangle, const glm::dvec3& place) {
    return squared(way_from_triangle(triangle[0], triangle[1], triangle[2], place));
  }

  void add_samples(Halfedge h, Samples& around) const {
    if (mesh_.face(h)) samples_.for_each(mesh_.face(h), [&](std::uint32_t i) { around.push_back(i); });
  }
  void find_samples(Vertex v, Samples& around) const {
    around.clear();
    for (const Halfedge h : outgoing(mesh_, v)) add_samples(h, around);
  }

  // About a vertex or the middle of an edge.
  void find_samples(const FarPlace& place, Samples& around) const {
    if (place.shares.x == 1) return find_samples(mesh_.from(place.corner), around);
    around.clear();
    for (const Halfedge side : {place.corner, twin(place.corner)}) add_samples(side, around);
  }

  // Of a place from the input, looked for from the nearest of these samples; one whose square is `enough` will do.
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
    std::vector<FarPlace> places;
    double largest;
    Samples around;  // to be reused

    double enough() const { return least_share * largest; }
    void add(const FarPlace& place) {
      if (!(place.square > std::max(enough(), rounding) && place.square < unknown)) return;
      largest = std::max(largest, place.square);
      places.push_back(place);
    }
  };
  // Asks look(i, found) for each i below the count, and adds what is found.
  template <class Look>
  void find_among(std::uint32_t count, Found& all, const Look& look) const {
    const unsigned threads = threads_for(count);
    std::vector<Found> parts(threads, Found{{}, all.largest, {}});
    for_each_part(count, threads, [&](unsigned part, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) look(i, parts[part]);
    });
    for (const Found& part : parts)
      for (const FarPlace& place : part.places) all.add(place);
  }

  // The farthest first.
  std::vector<FarPlace> find() const {
    Found all{{}, 0, {}};
    find_among(mesh_.face_slots(), all, [&](std::uint32_t i, Found& found) { look_at_samples(Face(i), found); });
    find_among(mesh_.edge_slots(), all, [&](std::uint32_t i, Found& found) { look_at_middle(Edge(i), found); });
    find_among(mesh_.vertex_slots(), all, [&](std::uint32_t i, Found& found) { look_at(Vertex(i), found); });
    std::erase_if(all.places, [&](const FarPlace& place) { return !(place.square > all.enough()); });
    std::sort(all.places.begin(), all.places.end());
    if (all.places.size() > most_places) all.places.resize(most_places);
    return std::move(all.places);
  }
  void look_at_samples(Face f, Found& found) const {
    if (!mesh_.is_alive(f) || !is_triangle_at(mesh_.halfedge(f))) return;
    const Halfedge h = mesh_.halfedge(f);
    const Corners corners = corners_at(h);
    samples_.for_each(f, [&](std::uint32_t i) {
      const double square = square_from(corners, samples_.sample(i).place);
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

  // The largest square around a vertex at a place, or one that is `enough`.
  double largest_around(Vertex v, const glm::dvec3& p, double enough = unknown) {
    looks_ += around_.size();
    double largest = 0;
    const auto look = [&](const glm::dvec3& place) {
      const InputSearch::Near near = from_input(place, around_, largest);
      largest = std::max(largest, near.square);
      looks_ += near.asked;
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
      double least = unknown;
      for (const Corners& corners : ring_) {
        least = std::min(least, square_from(corners, samples_.sample(i).place));
        if (least <= largest) break;
      }
      largest = std::max(largest, least);
      if (largest >= enough) break;
    }
    return largest;
  }
  double sum_around(Vertex v, const glm::dvec3& p) const {
    double sum = 0;
    for (const Halfedge h : outgoing(mesh_, v)) {
      if (!is_triangle_at(h)) continue;
      const Corners corners{p, surface_.place(mesh_.to(h)), surface_.place(mesh_.from(mesh_.prev(h)))};
      samples_.for_each(mesh_.face(h), [&](std::uint32_t i) {
        const auto [place, area] = samples_.sample(i);
        sum += area * square_from(corners, place);
      });
    }
    return sum;
  }

  // Moves the corner by which the place comes nearest: the largest square around it then, or unknown. Where the place
  // is as near already as `enough`, nothing moves.
  double bring_nearer(const FarPlace& place, double enough) {
    const Corners corners = corners_at(place.corner);
    glm::dvec3 shares = place.shares, way;
    if (place.sample != no_index) {
      const glm::dvec3 sample = samples_.sample(place.sample).place;
      const NearestPlace near = nearest_on_triangle(corners, sample);
      shares = near.barycentric;
      way = sample - near.place;
    } else {
      find_samples(place, around_);
      way = -from_input(point_of(place), around_).way;
    }
    if (squared(way) <= enough) return squared(way);
    double least = unknown;
    Vertex best;
    glm::dvec3 to{0.0};
    const std::array<Vertex, 3> vertices = vertices_at(place.corner);
    for (int k = 0; k < 3; ++k) {
      const Vertex v = vertices[k];
      if (shares[k] < least_corner_share || !surface_.is_amid_surface(v) || is_hub(mesh_, v)) continue;
      find_samples(v, around_);
      double wanted = std::min(least, most_left * largest_around(v, corners[k]));
      const double most_sum = most_growth * sum_around(v, corners[k]);
      for (const double stride : {1.0, 0.5, 0.25}) {
        const glm::dvec3 position = surface_.scale().restored(corners[k] + stride / shares[k] * way);
        const glm::dvec3 there = surface_.scale().scaled(position);
        const double largest = largest_around(v, there, wanted);
        if (!(largest < wanted) || sum_around(v, there) > most_sum || !mover_.may_move(v, position)) continue;
        wanted = least = largest;
        best = v;
        to = position;
      }
    }
    return best && mover_.move(best, to) ? least : unknown;
  }

  const Mesh& mesh_;
  const CollapseSurface& surface_;
  const NearSamples& samples_;
  InputSearch input_;
  VertexMover mover_;
  Samples around_;                          // the samples at the faces around a vertex
  std::vector<Corners> ring_;               // the triangles around it
  std::size_t looks_ = 0, most_looks_ = 0;  // at samples and triangles of the input, for moves
};

}  // namespace

NearerMoves move_farthest(Edit& edit, CollapseSurface& surface, const NearSamples& samples, const Mesh& input,
                          DistanceGuard* guard, Progress& progress) {
  Farthest farthest(edit, surface, samples, input, guard);
  farthest.bring_all_nearer(progress);
  return farthest.moves();
}

}  // namespace ryosen
