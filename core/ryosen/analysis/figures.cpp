#include "ryosen/analysis/figures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/analysis/components.h"
#include "ryosen/base/parallel.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/box.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

void count_corners(std::uint64_t corners, Figures& figures) {
  figures.corners += corners;
  figures.triangles += corners == 3;
  figures.quads += corners == 4;
  figures.polygons += corners >= 5;
}

void count_quarantine(const Mesh& mesh, std::span<const QuarantinedFace> quarantine, Figures& figures) {
  for (const QuarantinedFace& face : quarantine) {
    count_corners(face.corners.size(), figures);
    for (const ProblemRow& row : problem_table())
      if (row.quarantined) figures[row.kind] += row.quarantined(face, mesh.file_vertices());
  }
}

void count_edges(Neighbourhood& around, Figures& figures) {
  const Mesh& mesh = around.mesh();
  std::uint64_t most = 0;
  for (const Edge e : live_edges(mesh)) {
    if (!around.is_first_sheet(e)) continue;
    if (is_bridge(mesh, halfedge(e))) {
      ++figures.rings;  // as a file that is read again has it
      continue;
    }
    ++figures.edges;
    most = std::max<std::uint64_t>(most, around.edge(halfedge(e)).faces());
  }
  figures.max_edge_faces = most;
}

void count_vertices(Neighbourhood& around, const ProblemSets& sets, Figures& figures) {
  const Mesh& mesh = around.mesh();
  figures.vertices = mesh.live().vertices;
  if (mesh.has_copies())
    for (const Vertex v : live_vertices(mesh)) figures.vertices -= around.point(v) != v;
  sets.of(ProblemKind::nonmanifold_vertex).for_each([&](std::uint32_t i) {
    figures.bowtie_vertices += around.fans(Vertex(i)) > 1;
  });
}

// What wires alone hold is isolated in a file that is read again.
void count_isolated(Neighbourhood& around, const ProblemSets& sets, Figures& figures) {
  std::vector<Vertex> bare;
  sets.of(ProblemKind::wire).for_each([&](std::uint32_t i) {
    const auto [a, b] = ends(around.mesh(), Edge(i));
    for (const Vertex v : {a, b})
      if (around.fans(v) == 0) bare.push_back(around.point(v));
  });
  sort_unique(bare);
  figures[ProblemKind::isolated_vertex] += bare.size();
}

// Bounds, area and volume of faces as they come.
class Measure {
 public:
  void add(std::span<const glm::dvec3> polygon) {
    const Box before = bounds_;
    for (const glm::dvec3& p : polygon) {
      if (!is_finite(p)) {
        all_finite_ = false;
        bounds_ = before;
        return;
      }
      bounds_.add(p);
    }
    if (!has_faces_) apex_ = polygon[0];
    has_faces_ = true;
    if (polygon.size() == 3 && add_triangle(polygon[0], polygon[1], polygon[2])) return;
    area_ += polygon_area(polygon);
    volume_ += polygon_volume(polygon, apex_);
  }

  void report(Figures& figures) const {
    if (has_faces_) figures.bounds = {bounds_.lowest, bounds_.highest};
    figures.area = area_;
    if (figures.closed && figures.manifold && figures[ProblemKind::misoriented_edge] == 0 && all_finite_)
      figures.volume = volume_;
  }

 private:
  // Whether a triangle could be added by its three corners; false where the squares leave the range of doubles.
  bool add_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double square = glm::dot(normal, normal);
    if (!(square > 1e-280 && square < 1e+280)) return false;
    area_ += 0.5 * std::sqrt(square);
    volume_ += glm::dot(normal, a - apex_) / 6;
    return true;
  }

  Box bounds_;
  glm::dvec3 apex_{0.0};
  double area_ = 0, volume_ = 0;
  bool has_faces_ = false;
  bool all_finite_ = true;
};

// Whether a face has rings or bridges; it takes two loops of three corners and a bridge walked twice to have one.
bool has_inner_loops(const Mesh& mesh, const FacePolygon& polygon) {
  if (polygon.loop_ends().size() > 1) return true;
  if (polygon.corners().size() < 8) return false;
  return std::any_of(polygon.corners().begin(), polygon.corners().end(),
                     [&](Halfedge h) { return is_bridge(mesh, h); });
}

// The corners of each kind of face and what the faces measure.
void measure_faces(const Mesh& mesh, Measure& measure, Figures& figures) {
  FacePolygon polygon;
  for (const Face f : live_faces(mesh)) {
    const Halfedge first = mesh.halfedge(f);
    if (is_triangle(mesh, first) && !mesh.has_rings(f)) {
      const Halfedge second = mesh.next(first);
      const glm::dvec3 places[] = {mesh.position(mesh.from(first)), mesh.position(mesh.from(second)),
                                   mesh.position(mesh.to(second))};
      count_corners(3, figures);
      measure.add(places);
      continue;
    }
    polygon.read(mesh, f);
    if (!has_inner_loops(mesh, polygon)) {
      count_corners(polygon.places().size(), figures);
      measure.add(polygon.places());
    } else {
      // The walk has the corners that the file's bridged list has.
      const std::vector<glm::dvec3> walk = measured_walk(mesh, f);
      count_corners(walk.size(), figures);
      measure.add(walk);
    }
  }
}

// What is counted on edges and vertices.
void count_the_rest(Neighbourhood& around, const ProblemSets& sets, Figures& figures) {
  count_vertices(around, sets, figures);
  count_isolated(around, sets, figures);
  count_edges(around, figures);
  const BoundaryLoops loops = find_boundary_loops(around, sets.of(ProblemKind::boundary_loop));
  figures.boundary_loops = loops.size();
  figures.open_boundary = loops.has_open_chain;
  figures.orientable = sets.count(ProblemKind::misoriented_edge) == 0 || is_orientable(around);
}

struct NamedSurface {
  bool orientable;
  std::int64_t parts;  // handles or crosscaps
  std::uint64_t boundary_loops;
  const char *en, *ja;
};

constexpr NamedSurface named_surfaces[] = {
    {true, 0, 0, "sphere", "球面"},
    {true, 1, 0, "torus", "トーラス"},
    {true, 0, 1, "disc", "円板"},
    {true, 0, 2, "cylinder", "円筒"},
    {false, 1, 0, "projective plane", "射影平面"},
    {false, 2, 0, "Klein bottle", "クラインの壺"},
    {false, 1, 1, "Möbius strip", "メビウスの帯"},
};

std::string counted(std::uint64_t n, const std::string& one) {
  return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
}

}  // namespace

Figures compute_figures(const Mesh& mesh, const ProblemSets& sets, std::span<const QuarantinedFace> quarantine,
                        unsigned threads) {
  if (threads == 0) threads = threads_for(mesh.halfedge_slots());
  Figures figures, of_faces;
  Measure measure;
  std::uint64_t components = 0;
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  for_each_task(3, threads, [&](unsigned task) {
    if (task == 0) measure_faces(mesh, measure, of_faces);
    if (task == 1) count_the_rest(around, sets, figures);
    if (task != 2) return;
    std::optional<Neighbourhood> own;  // what is gathered must not be shared
    if (threads > 1) own.emplace(mesh, Neighbourhood::Reach::whole);
    components = count_face_components(own ? *own : around);
  });
  figures.corners = of_faces.corners;
  figures.triangles = of_faces.triangles;
  figures.quads = of_faces.quads;
  figures.polygons = of_faces.polygons;
  figures.components = components;
  for (const ProblemRow& row : problem_table())
    if (!row.figure.empty()) figures[row.kind] += sets.count(row.kind);
  count_quarantine(mesh, quarantine, figures);
  const std::uint64_t usable = mesh.live().faces;
  figures.faces = usable + quarantine.size();
  figures.rings += mesh.live().rings;
  const std::uint64_t on_lines = sets.points_without_edge() - sets.count(ProblemKind::isolated_vertex);
  const std::uint64_t used = figures.vertices - figures[ProblemKind::isolated_vertex] - on_lines;
  figures.euler_characteristic =
      static_cast<std::int64_t>(used + usable) - static_cast<std::int64_t>(figures.edges + figures.rings);
  figures.manifold = figures[ProblemKind::nonmanifold_edge] == 0 && figures.bowtie_vertices == 0;
  figures.closed =
      usable > 0 && figures[ProblemKind::boundary_loop] == 0 && figures[ProblemKind::nonmanifold_edge] == 0;
  if (figures.manifold && figures.orientable && usable > 0)
    figures.genus = (2 * static_cast<std::int64_t>(figures.components) - figures.euler_characteristic -
                     static_cast<std::int64_t>(figures.boundary_loops)) /
                    2;
  measure.report(figures);
  return figures;
}

Figures compute_figures(const Mesh& mesh, std::span<const QuarantinedFace> quarantine) {
  return compute_figures(mesh, ProblemSets(mesh), quarantine);
}

std::optional<Text> surface_name(const Figures& f) {
  if (!f.manifold || f.components != 1 || f.edges == 0 || f[ProblemKind::isolated_vertex] > 0) return std::nullopt;
  const std::int64_t lost = 2 - f.euler_characteristic - static_cast<std::int64_t>(f.boundary_loops);
  if (lost < 0 || (f.orientable && lost % 2 != 0)) return std::nullopt;
  const std::int64_t parts = f.orientable ? lost / 2 : lost;
  for (const NamedSurface& s : named_surfaces)
    if (s.orientable == f.orientable && s.parts == parts && s.boundary_loops == f.boundary_loops)
      return Text{s.en, s.ja};
  const auto count = static_cast<std::uint64_t>(parts);
  Text name =
      f.orientable
          ? Text{"sphere with " + counted(count, "handle"), "ハンドル " + std::to_string(count) + " 個の球面"}
          : Text{"sphere with " + counted(count, "crosscap"), "クロスキャップ " + std::to_string(count) + " 個の球面"};
  if (f.boundary_loops > 0) {
    name.en += " and " + counted(f.boundary_loops, "hole");
    name.ja += "（穴 " + std::to_string(f.boundary_loops) + " 個）";
  }
  return name;
}

}  // namespace ryosen
