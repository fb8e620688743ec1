#include "ryosen/scene/view/file_normals.h"

#include <algorithm>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/scene/view/packed_normal.h"

namespace ryosen {

namespace {

const AttributeColumn* column(const Mesh& mesh, std::string_view name) {
  const int i = mesh.find_attribute(name);
  return i < 0 ? nullptr : &mesh.attributes()[static_cast<std::size_t>(i)];
}

}  // namespace

bool FileNormals::are_in(const Mesh& mesh) { return column(mesh, attribute_names::normal) != nullptr; }

FileNormals::Reader::Reader(const FileNormals& normals, const Mesh& mesh)
    : normals_(&normals),
      indices_(column(mesh, attribute_names::normal)),
      pool_(column(mesh, attribute_names::normal_pool)) {}

std::uint32_t FileNormals::Reader::at(Vertex from, Halfedge h) const {
  if (!indices_ || !pool_ || normals_->all_edited_) return no_normal;
  if (from.index < normals_->edited_.size() && normals_->edited_[from.index]) return no_normal;
  const auto index = attribute_value<std::uint32_t>(*indices_, h.index);
  if (index >= pool_->data.size() / pool_->words) return no_normal;
  return packed_normal(attribute_value<glm::dvec3>(*pool_, index));
}

void FileNormals::follow(const Mesh& mesh, const TouchedElements& touched) {
  if (!are_in(mesh)) return;
  all_edited_ |= touched.everything;
  if (all_edited_) return;
  edited_.resize(std::max<std::size_t>(edited_.size(), mesh.vertex_slots()));
  const auto note = [&](Vertex v) {
    if (v.index < edited_.size()) edited_[v.index] = true;
  };
  for (const Vertex v : touched.vertices) note(v);
  for (const Face f : touched.faces)
    if (mesh.exists(f) && mesh.is_alive(f))
      for (const Vertex v : vertices_around(mesh, f)) note(v);
}

}  // namespace ryosen
