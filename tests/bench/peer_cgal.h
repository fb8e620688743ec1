// CGAL's Surface_mesh behind a few plain functions: the peer that the kernel is measured against. Only benchmarks use
// it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ryosen/indexed/indexed.h"

namespace ryosen::bench {

class CgalMesh {
 public:
  CgalMesh();
  ~CgalMesh();
  CgalMesh(CgalMesh&&) noexcept;
  CgalMesh& operator=(CgalMesh&&) noexcept;
  CgalMesh copy() const;

  // Exact reserves, then vertices and faces one by one; what it cannot take is left out.
  static CgalMesh build(const IndexedMesh& source);
  // Reads a file, welded where the format is STL; without faces where it cannot.
  static CgalMesh read(const std::string& path);
  std::size_t faces() const;
  std::size_t edges() const;  // slots

  // The sum of all neighbours' positions of all vertices.
  double walk_one_rings() const;
  // For each vertex the sum of its neighbours' positions, in one loop over the edges.
  void sum_one_rings_over_edges(std::vector<glm::dvec3>& sums) const;
  // How many edges satisfy the link condition; how many could be flipped.
  std::size_t count_collapsible() const;
  std::size_t count_swappable() const;
  // Checks each edge in turn and does what is legal; returns how many that were.
  std::size_t swap_each(const std::vector<std::uint32_t>& edges);
  std::size_t collapse_each(const std::vector<std::uint32_t>& edges);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace ryosen::bench
