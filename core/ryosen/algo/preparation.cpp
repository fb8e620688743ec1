#include "ryosen/algo/preparation.h"

#include <string_view>
#include <unordered_map>

#include "ryosen/base/count_text.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/poke.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/triangulate.h"

namespace ryosen {

namespace {

// By index into a pool: the first index with the same value.
std::vector<std::uint32_t> first_equals(const AttributeColumn& pool) {
  const std::size_t count = pool.data.size() / pool.words();
  std::vector<std::uint32_t> first(count);
  std::unordered_map<std::string_view, std::uint32_t> known;
  known.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto* const bytes = reinterpret_cast<const char*>(pool.data.data() + i * pool.words());
    first[i] = known.emplace(std::string_view(bytes, pool.words() * sizeof(std::uint32_t)), i).first->second;
  }
  return first;
}

}  // namespace

std::vector<Face> polygons_of_mesh(const Mesh& mesh) {
  std::vector<Face> found;
  for (const Face f : live_faces(mesh))
    if (mesh.has_rings(f) || !is_triangle(mesh, mesh.halfedge(f))) found.push_back(f);
  return found;
}

bool has_bridge(const Mesh& mesh, Face f) {
  for (const Halfedge h : loop(mesh, mesh.halfedge(f)))
    if (is_bridge(mesh, h)) return true;
  return false;
}

std::optional<Text> cut_faces(Edit& edit, std::span<const Face> faces) {
  const Mesh& mesh = edit.mesh();
  for (const Face f : faces) {
    const Triangulate by_diagonals{f};
    if (by_diagonals.check(mesh).legal()) {
      by_diagonals.apply(edit);
    } else if (is_one_simple_loop(mesh, f)) {
      poke(edit, f, Poke{f}.position(mesh));  // also where another face lies on it, which the operator refuses
    } else {
      const std::string name = name_of(mesh, f);
      return Text{name + " cannot be cut into triangles; cut it by hand or delete it",
                  name + " を三角形に分割できません。手で分割するか削除してください"};
    }
  }
  return std::nullopt;
}

Text cut_text(std::size_t cut_faces) {
  if (cut_faces == 0) return {};
  return count_text(cut_faces, "; one face was cut into triangles first", "; # faces were cut into triangles first",
                    "（先に面 # 個を三角形に分割）");
}

void share_equal_values(Edit& edit) {
  const Mesh& mesh = edit.mesh();
  for (const CornerAttribute& attribute : corner_attributes(mesh)) {
    const std::vector<std::uint32_t> first = first_equals(mesh.attributes()[attribute.pool_column]);
    const std::vector<std::uint32_t>& indices = mesh.attributes()[attribute.index_column].data;
    for (const Halfedge h : live_halfedges(mesh)) {
      if (indices[h.index] >= first.size()) continue;
      const std::uint32_t index = first[indices[h.index]];
      edit.set_attribute(attribute.index_column, h.index, std::span(&index, 1));
    }
  }
}

}  // namespace ryosen
