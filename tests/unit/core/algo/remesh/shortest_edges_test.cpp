// Remeshing makes no edge that is much shorter than any that is wanted, however the faces lie.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <set>

#include "ryosen/algo/remesh/features.h"
#include "ryosen/algo/remesh/remesh.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/triangle_corners.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/swap_edge.h"
#include "ryosen/ops/triangulate.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen::test {
namespace {

constexpr double angle_rad = std::numbers::pi / 4, rounding = 1 - 1e-9;

struct Segment {
  glm::dvec3 a, b;
  double length() const { return glm::distance(a, b); }
};
Segment segment_of(const Mesh& mesh, Edge e) {
  const auto [a, b] = ends(mesh, e);
  return {mesh.position(a), mesh.position(b)};
}
template <class Is>
std::vector<Segment> segments_of(const Mesh& mesh, Is is) {
  std::vector<Segment> found;
  for (Edge e(0); e.index < mesh.edge_slots(); ++e.index)
    if (mesh.is_alive(e) && is(e)) found.push_back(segment_of(mesh, e));
  return found;
}

std::array<double, 3> coordinates(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

double distance_from(const Segment& segment, const glm::dvec3& p) {
  const glm::dvec3 along = segment.b - segment.a;
  const double square = glm::dot(along, along);
  const double t = square > 0 ? std::clamp(glm::dot(p - segment.a, along) / square, 0.0, 1.0) : 0;
  return glm::distance(p, segment.a + t * along);
}

// The boundary and features of a mesh, and the points on them: they must stay.
class KeptLines {
 public:
  explicit KeptLines(const Mesh& mesh) {
    const remesh::Features features = remesh::find_features(mesh, angle_rad);
    lines_ = segments_of(mesh, [&](Edge e) { return features.edges[e.index] != 0; });
    for (Vertex v(0); v.index < mesh.vertex_slots(); ++v.index)
      if (mesh.is_alive(v) && features.vertices[v.index]) points_.insert(coordinates(mesh.position(v)));
  }

  bool hold(const glm::dvec3& p) const { return points_.contains(coordinates(p)); }
  // One line holds both points.
  bool hold(const glm::dvec3& a, const glm::dvec3& b) const {
    const double near = 1e-9 * (1 + glm::length(a));
    return std::any_of(lines_.begin(), lines_.end(), [&](const Segment& line) {
      return distance_from(line, a) <= near && distance_from(line, b) <= near;
    });
  }

 private:
  std::vector<Segment> lines_;
  std::set<std::array<double, 3>> points_;
};

// Edges of a result that are no pieces of kept lines, nor lead from one kept point to another.
std::vector<Segment> made_edges(const KeptLines& kept, const Mesh& after,
                                double below = std::numeric_limits<double>::infinity()) {
  std::vector<Segment> found =
      segments_of(after, [&](Edge e) { return !after.is_wire(e) && segment_of(after, e).length() < below; });
  std::erase_if(found, [&](const Segment& edge) {
    return (kept.hold(edge.a) && kept.hold(edge.b)) || kept.hold(edge.a, edge.b);
  });
  return found;
}

double shortest(const std::vector<Segment>& edges) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& edge : edges) least = std::min(least, edge.length());
  return least;
}

Mesh remeshing_of(const Mesh& mesh, const std::string& words) {
  Mesh made = mesh;
  Journal journal;
  const AlgorithmResult result = run_algorithm(made, journal, "remesh " + words);
  EXPECT_FALSE(result.fault) << words << ": " << result.fault->en;
  return made;
}

double diagonal(const Mesh& mesh) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (Vertex v(0); v.index < mesh.vertex_slots(); ++v.index)
    if (mesh.is_alive(v)) low = glm::min(low, mesh.position(v)), high = glm::max(high, mesh.position(v));
  return glm::distance(low, high);
}

Mesh triangles_of(Mesh mesh) {
  if (!Triangulate{}.check(mesh).legal()) return mesh;
  Edit edit(mesh, nullptr);
  Triangulate{}.apply(edit);
  edit.commit();
  return mesh;
}

// No edge under 4/5 of L/8, or under the shortest there was.
void expect_no_short_edges(const Mesh& mesh, double share, std::size_t rounds) {
  const double length = share * diagonal(mesh), before = shortest(segments_of(mesh, [](Edge) { return true; }));
  const double least = std::min(0.8 * length / 8, before) * rounding;
  const std::string words = "rounds=" + std::to_string(rounds) + " length=" + std::to_string(100 * share) + "%";
  EXPECT_GE(shortest(made_edges(KeptLines(mesh), remeshing_of(mesh, words + " adaptive=on"))), least) << words;
  EXPECT_GE(shortest(made_edges(KeptLines(mesh), remeshing_of(mesh, words))), least) << words;
}

Mesh with_places(const Mesh& mesh, const std::function<glm::dvec3(const glm::dvec3&)>& change) {
  MeshColumns columns = mesh.columns();
  for (glm::dvec3& p : columns.positions) p = change(p);
  return Mesh(std::move(columns));
}

TEST(RemeshShortest, of_a_flat_tetrahedron_and_what_is_like_it) {
  const Mesh flat = report_mesh("flat_tetra.obj");
  const Mesh made = remeshing_of(flat, "length=35% adaptive=on rounds=1");
  EXPECT_LT(made.live().faces, 2000u);
  const double c = std::cos(0.7), s = std::sin(0.7);
  const std::vector<Mesh> all{
      flat,
      with_places(flat, [&](const glm::dvec3& p) { return glm::dvec3(c * p.x - s * p.y, s * p.x + c * p.y, p.z); }),
      with_places(flat, [](const glm::dvec3& p) { return glm::dvec3(p.y, p.x, p.z); }),
      with_places(flat, [](const glm::dvec3& p) { return 1e6 * p + glm::dvec3(1e6, 0, 0); }),
      with_places(flat, [](const glm::dvec3& p) { return 1e-6 * p; }),
      with_places(flat, [](const glm::dvec3& p) { return glm::dvec3(p.x, 3 * p.y, p.z); }),
      with_places(made_by("icosahedron"), [](const glm::dvec3& p) { return glm::dvec3(p.x, p.y, 0); })};
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(i);
    expect_no_short_edges(all[i], 0.6, 1 + i % 3);
  }
}

// Faces of random meshes in a plane lie over one another.
TEST(RemeshShortest, of_faces_over_one_another) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const SeededMesh seeded = seeded_mesh(seed);
    Dice dice(seed);
    const Mesh triangles = triangles_of(make_mesh(seeded.faces, seeded.points));
    const Mesh flat = with_places(triangles, [&](const glm::dvec3&) {
      const double x = dice.unit(), y = dice.unit();
      return glm::dvec3(x, y, seed % 3 == 0 ? 0.3 * x : 0);
    });
    expect_no_short_edges(flat, 0.7, 1 + seed % 2);
  }
}

TEST(RemeshShortest, of_books_fans_and_slivers) {
  for (const UglyFamily& family : ugly_families()) {
    SCOPED_TRACE(family.id);
    expect_no_short_edges(from_indexed(family.make(12)), 0.3, 1);
  }
}

std::size_t short_edges(const Mesh& mesh, double share, const std::string& further = "") {
  const double least = 0.8 * share * diagonal(mesh) * rounding / (further.empty() ? 1 : 8);
  return made_edges(KeptLines(mesh), remeshing_of(mesh, "length=" + std::to_string(100 * share) + "%" + further), least)
      .size();
}

TEST(RemeshShortest, no_made_edge_of_a_shape_is_short) {
  for (const char* const shape : {"sphere", "torus radius=2 tube=0.6", "cube size=2", "cylinder", "cone"})
    for (const double share : {0.04, 0.07}) {
      SCOPED_TRACE(shape);
      const Mesh mesh = made_by(shape);
      EXPECT_EQ(short_edges(mesh, share), 0u) << share;
      EXPECT_EQ(short_edges(mesh, share, " adaptive=on"), 0u) << share;
    }
  for (const char* const name : {"torus.off", "ball.off", "klein_bottle.off", "moebius.off"})
    for (const double share : {0.05, 0.1}) {
      SCOPED_TRACE(name);
      EXPECT_EQ(short_edges(asset_mesh(name), share), 0u) << share;
      EXPECT_EQ(short_edges(asset_mesh(name), share, " adaptive=on"), 0u) << share;
    }
}

TEST(RemeshShortest, no_made_edge_is_short_at_many_lengths) {
  const std::vector<std::string> lines{
      "icosahedron", "octahedron", "cube size=2", "cone", "cylinder", "sphere", "torus radius=2 tube=0.6"};
  for (const std::string& line : lines)
    for (const double share : {0.05, 0.08, 0.13, 0.2, 0.3}) {
      if (line.starts_with("torus") && share > 0.15) continue;
      EXPECT_EQ(short_edges(made_by(line), share), 0u) << line << " " << share;
    }
  for (const double share : {0.03, 0.08, 0.2}) {
    Mesh box = made_by("cube size=2");
    Journal journal;
    run_algorithm(box, journal, "scale factor=0.03 axis=0,1,0");
    EXPECT_EQ(short_edges(box, share), 0u) << share;
    EXPECT_EQ(short_edges(box, share, " adaptive=on"), 0u) << share;
  }
}

// The middle of an edge of many sheets can leave it in none: no step may bring another such point near it.
TEST(RemeshShortest, no_made_edge_is_short_where_sheets_meet) {
  for (const char* const name : {"projective_plane.off", "three_tri_edge.off", "moebius.off"})
    for (const double share : {0.03, 0.05, 0.1, 0.13, 0.22}) {
      EXPECT_EQ(short_edges(asset_mesh(name), share), 0u) << name << " " << share;
      EXPECT_EQ(short_edges(asset_mesh(name), share, " adaptive=on"), 0u) << name << " " << share;
    }
  for (const std::uint32_t pages : {5u, 12u, 30u})
    EXPECT_EQ(short_edges(from_indexed(test::book(pages)), 0.08), 0u) << pages;
}

TEST(RemeshShortest, no_made_edge_of_the_bunny_is_short) {
  const Mesh bunny = asset_mesh("stanford_bunny.obj");
  EXPECT_EQ(short_edges(bunny, 0.01), 0u);
  if (!is_long_run()) return;
  for (const double share : {0.02, 0.03, 0.05, 0.08, 0.13, 0.16}) EXPECT_EQ(short_edges(bunny, share), 0u) << share;
  for (const double share : {0.02, 0.05}) EXPECT_EQ(short_edges(bunny, share, " adaptive=on"), 0u) << share;
}

// What a surface is judged by when a short edge goes.
struct Judged {
  std::vector<double> short_lengths;  // ascending
  std::size_t meetings = 0, flat = 0;
};
Judged judged(const KeptLines& kept, const Mesh& after, double least) {
  Judged found;
  for (const Segment& edge : made_edges(kept, after, least)) found.short_lengths.push_back(edge.length());
  std::sort(found.short_lengths.begin(), found.short_lengths.end());
  found.meetings = find_self_intersections(after).count;
  for (Face f(0); f.index < after.face_slots(); ++f.index) {
    if (!after.is_alive(f)) continue;
    const TriangleCorners c = corners_of(after, after.halfedge(f));
    if (are_collinear(c[0], c[1], c[2])) ++found.flat;
  }
  return found;
}
// Fewer short edges, of those that are new none under the one that goes, and no more faces that meet or are flat.
bool is_better(const Judged& made, const Judged& old, double length) {
  if (made.short_lengths.size() >= old.short_lengths.size()) return false;
  if (made.meetings > old.meetings || made.flat > old.flat) return false;
  std::vector<double> fresh;
  std::set_difference(made.short_lengths.begin(), made.short_lengths.end(), old.short_lengths.begin(),
                      old.short_lengths.end(), std::back_inserter(fresh));
  return fresh.empty() || fresh.front() >= length * rounding;
}

// The steps that the kernel allows, that leave what must stay, and that would take short edges away.
std::size_t steps_that_help(const KeptLines& kept, const Mesh& after, double least) {
  const Judged old = judged(kept, after, least);
  std::size_t found = 0;
  const auto try_step = [&](const auto& step, double length) {
    if (!step.check(after).legal()) return;
    Mesh made = after;
    Edit edit(made, nullptr);
    step.apply(edit);
    edit.commit();
    if (is_better(judged(kept, made, least), old, length)) ++found;
  };
  for (Edge e(0); e.index < after.edge_slots(); ++e.index) {
    if (!after.is_alive(e) || after.is_wire(e)) continue;
    const Segment segment = segment_of(after, e);
    if (segment.length() >= least || (kept.hold(segment.a) && kept.hold(segment.b))) continue;
    if (kept.hold(segment.a, segment.b)) continue;
    try_step(SwapEdge{halfedge(e)}, segment.length());
    const auto [a, b] = ends(after, e);
    for (const Vertex v : {a, b}) {
      const glm::dvec3 p = after.position(v);
      if (kept.hold(p)) continue;
      for (const Halfedge h : outgoing(after, v)) {
        const glm::dvec3 q = after.position(after.to(h));
        if (!kept.hold(p, p) || kept.hold(p, q)) try_step(CollapseEdge{h, CollapseEdge::Place::end}, segment.length());
      }
    }
  }
  return found;
}

// Tubes whose circumference is about twice the length and less.
TEST(RemeshShortest, an_edge_of_a_thin_tube_stays_short_only_where_no_step_helps) {
  const std::vector<double> few{0.28}, many{0.1, 0.13, 0.16, 0.18, 0.22, 0.28, 0.35};
  for (const char* const tube : {"0.6", "0.3", "0.15"})
    for (const double share : is_long_run() ? many : few) {
      SCOPED_TRACE(tube);
      SCOPED_TRACE(share);
      const Mesh torus = triangles_of(made_by("torus radius=2 tube=" + std::string(tube)));
      const KeptLines kept(torus);
      const double least = 0.8 * share * diagonal(torus) * rounding;
      const auto made = [&](double length) {
        return remeshing_of(torus, "length=" + std::to_string(100 * length) + "% feature_angle=180");
      };
      EXPECT_EQ(steps_that_help(kept, made(share), least), 0u);
      if (share == 0.28) {
        EXPECT_GT(steps_that_help(kept, made(0.7 * share), least), 0u);
      }
    }
}

Mesh overlapping_tubes() {
  Mesh tubes;
  Journal journal;
  for (int i = 0; i < 9; ++i)
    run_algorithm(tubes, journal, "torus radius=2 tube=0.6 at=" + std::to_string(0.11 * i) + ",0,0");
  return triangles_of(std::move(tubes));
}

// Large triangles over thin parts, a surface that passes through itself, and parts that lie over one another.
TEST(RemeshShortest, an_edge_of_any_shape_stays_short_only_where_no_step_helps) {
  struct Shape {
    Mesh mesh;
    std::vector<double> shares, further;  // the further ones in a long run
  };
  const std::vector<Shape> all{{triangles_of(asset_mesh("klein_bottle.off")), {0.13}, {0.1, 0.16, 0.2, 0.25}},
                               {asset_mesh("stanford_bunny.obj"), {}, {0.22, 0.28, 0.35, 0.45}},
                               {overlapping_tubes(), {}, {0.03, 0.05}}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<double> shares = all[i].shares;
    if (is_long_run()) shares.insert(shares.end(), all[i].further.begin(), all[i].further.end());
    if (shares.empty()) continue;
    const KeptLines kept(all[i].mesh);
    for (const double share : shares) {
      SCOPED_TRACE(i);
      SCOPED_TRACE(share);
      const double least = 0.8 * share * diagonal(all[i].mesh) * rounding;
      const Mesh made = remeshing_of(all[i].mesh, "length=" + std::to_string(100 * share) + "%");
      EXPECT_LE(made_edges(kept, made, least).size(), 6u);
      EXPECT_EQ(steps_that_help(kept, made, least), 0u);
    }
  }
}

}  // namespace
}  // namespace ryosen::test
