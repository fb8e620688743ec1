#include "ryosen/io/vertex_values.h"

#include <algorithm>

namespace ryosen {

std::optional<std::vector<std::uint32_t>> per_vertex(const IndexedMesh& mesh, const CornerValues& values) {
  if (values.pool.empty() || values.index.size() != mesh.corners.size()) return std::nullopt;
  const std::size_t count = mesh.positions.size();
  std::vector<std::uint32_t> out(count, no_index);
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const std::uint32_t index = values.index[i];
    if (index >= values.pool.size()) return std::nullopt;
    std::uint32_t& known = out[mesh.corners[i]];
    if (known == no_index) known = index;
    if (known != index && values.pool[known] != values.pool[index]) return std::nullopt;
  }
  for (std::size_t v = 0; v < count; ++v) {
    if (out[v] == no_index && values.pool.size() == count) out[v] = static_cast<std::uint32_t>(v);
  }
  if (std::all_of(out.begin(), out.end(), [](std::uint32_t index) { return index == no_index; })) return std::nullopt;
  return out;
}

glm::dvec3 value_of(const CornerValues& values, std::uint32_t index) {
  return index < values.pool.size() ? values.pool[index] : glm::dvec3(0.0);
}

}  // namespace ryosen
