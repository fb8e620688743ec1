#include "app/cli/written_mesh.h"

#include <utility>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/elements.h"

namespace ryosen::cli {

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

AlgorithmResult joined(AlgorithmResult first, AlgorithmResult then) {
  if (first.changed == 0) return then;
  if (then.changed > 0) {
    first.text = first.text + Text{" ", ""} + then.text;
    first.changed += then.changed;
    if (then.crossings) first.crossings = first.crossings.value_or(0) + *then.crossings;
    first.drops_quarantined |= then.drops_quarantined;
  }
  first.left = then.left;
  first.left_for = std::move(then.left_for);
  return first;
}

AlgorithmResult undone_in_file(AlgorithmResult result) {
  result.left += result.changed;
  if (result.changed > 0)
    result.text = {"Undone, since points at one place are one in the file.",
                   "ファイルでは同じ位置の点が一つになるため、元に戻しました。"};
  result.changed = 0;
  result.crossings = {};
  result.drops_quarantined = false;
  return result;
}

}  // namespace ryosen::cli
