// The figures of a mesh as `check` reports them of the file that holds it, counted on points and undirected edges: in a
// file a bridge is a ring (euler_poincare.h), and a wire is no edge and holds no vertex.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "ryosen/analysis/problem_sets.h"
#include "ryosen/base/message.h"
#include "ryosen/indexed/indexed.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

struct Figures {
  // How many elements there are of a kind that has a figure in its row; of boundary_loop its edges.
  std::uint64_t operator[](ProblemKind kind) const { return counts[static_cast<std::size_t>(kind)]; }
  std::uint64_t& operator[](ProblemKind kind) { return counts[static_cast<std::size_t>(kind)]; }
  std::array<std::uint64_t, most_problem_kinds> counts{};

  // Of the file: quarantined faces and their corners count.
  std::uint64_t vertices = 0, corners = 0, faces = 0;
  std::uint64_t triangles = 0, quads = 0, polygons = 0;  // polygons: five or more corners

  // Of the faces that take part in the mesh. Edges without a face do not count.
  std::uint64_t edges = 0;
  std::uint64_t rings = 0;
  std::uint64_t boundary_loops = 0, max_edge_faces = 0, bowtie_vertices = 0;
  std::uint64_t components = 0;
  std::int64_t euler_characteristic = 0;
  std::optional<std::int64_t> genus;  // only where manifold, orientable and not empty
  bool manifold = true;
  bool closed = false;
  bool orientable = true;
  bool open_boundary = false;  // some boundary edges close to no loop: boundary_loops is no number of holes

  // Of the faces with finite coordinates.
  std::optional<std::array<glm::dvec3, 2>> bounds;  // smallest and largest coordinates
  double area = 0;
  std::optional<double> volume;  // only where closed, manifold, consistently oriented and all finite

  friend bool operator==(const Figures&, const Figures&) = default;
};

// O(corners), and a logarithm beside copies, on several threads where that pays (0) or on so many; sums are formed in
// the order of the faces whatever the number. `sets` are those of the mesh as it is.
Figures compute_figures(const Mesh& mesh, const ProblemSets& sets, std::span<const QuarantinedFace> quarantine,
                        unsigned threads = 0);
// Searches for itself.
Figures compute_figures(const Mesh& mesh, std::span<const QuarantinedFace> quarantine = {});

// The name of a connected surface by the classification theorem: "sphere", "torus", "Moebius strip", "Klein bottle",
// ..., else the numbers of handles or crosscaps and of boundary loops. None if the figures are not those of one
// manifold component.
std::optional<Text> surface_name(const Figures& figures);

}  // namespace ryosen
