#include "ryosen/algo/shared_values.h"

#include <string_view>
#include <unordered_map>
#include <vector>

#include "ryosen/mesh/attribute.h"

namespace ryosen {

namespace {

// By index into a pool: the first index with the same value.
std::vector<std::uint32_t> first_equals(const AttributeColumn& pool) {
  const std::size_t count = pool.data.size() / pool.words;
  std::vector<std::uint32_t> first(count);
  std::unordered_map<std::string_view, std::uint32_t> known;
  known.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto* const bytes = reinterpret_cast<const char*>(pool.data.data() + i * pool.words);
    first[i] = known.emplace(std::string_view(bytes, pool.words * sizeof(std::uint32_t)), i).first->second;
  }
  return first;
}

}  // namespace

void share_equal_values(Edit& edit) {
  const Mesh& mesh = edit.mesh();
  for (const CornerAttribute& attribute : corner_attributes(mesh)) {
    const std::vector<std::uint32_t> first = first_equals(mesh.attributes()[attribute.pool_column]);
    const std::vector<std::uint32_t>& indices = mesh.attributes()[attribute.index_column].data;
    for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
      if (!mesh.is_alive(Halfedge(i)) || indices[i] >= first.size()) continue;
      const std::uint32_t index = first[indices[i]];
      edit.set_attribute(attribute.index_column, i, std::span(&index, 1));
    }
  }
}

}  // namespace ryosen
