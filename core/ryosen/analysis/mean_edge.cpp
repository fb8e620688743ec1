#include "ryosen/analysis/mean_edge.h"

#include <cmath>

#include "ryosen/analysis/measures.h"

namespace ryosen {

double mean_edge_length(const Mesh& mesh) {
  double sum = 0, count = 0;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i))) continue;
    const double length = edge_length(mesh, Edge(i));
    if (!std::isfinite(length)) continue;
    sum += length;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace ryosen
