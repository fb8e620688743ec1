#include "app/editor/document/written_mesh.h"

#include <utility>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/edited_file.h"

namespace ryosen {

WrittenMesh::WrittenMesh(MeshFile contents, const Format& format) {
  MeshFile file = given_back(std::move(contents), format);
  on_lines_ = vertices_on_lines(file, file.mesh.positions.size());
  quarantine_ = std::move(file.mesh.quarantine);
  mesh_ = from_indexed(std::move(file.mesh));
  counts_ = count_findings(mesh_, on_lines_);
}

void WrittenMesh::count(std::size_t KindCount::*at, std::vector<KindCount>& findings) const {
  count_kinds(mesh_, {quarantine_, {}, {}, on_lines_}, true, at, findings);
}

bool WrittenMesh::is_like(const Document& document) const {
  return mesh_.hash() == document.mesh().hash() && quarantine_.size() == document.tables().quarantine.size();
}

}  // namespace ryosen
