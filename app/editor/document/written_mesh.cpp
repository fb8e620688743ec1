#include "app/editor/document/written_mesh.h"

#include <utility>

#include "ryosen/analysis/problem_kinds.h"
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

std::optional<Text> file_findings_text(const Document& document, const std::filesystem::path& path) {
  const Format* const format = format_to_write(path, document.file());
  if (!format || !format->write) return std::nullopt;
  MeshFile contents = document.contents();
  if (!gives_back_others(contents, *format)) return std::nullopt;
  const std::vector<Vertex> on_lines = vertices_on_lines(document.file(), document.mesh().file_vertices());
  const FindingCounts before = count_findings(document.mesh(), on_lines);
  const FindingCounts after = WrittenMesh(std::move(contents), *format).counts();
  Text numbers;
  for (const ProblemRow& row : problem_table()) {
    const auto kind = static_cast<std::size_t>(row.kind);
    if (row.severity != ProblemSeverity::problem || before[kind] == after[kind]) continue;
    const std::string number = " " + std::to_string(before[kind]) + " -> " + std::to_string(after[kind]);
    numbers += (numbers.en.empty() ? Text{} : Text{", ", "、"}) +
               Text{std::string(row.id) + number, std::string(row.id) + number};
  }
  if (numbers.en.empty()) return std::nullopt;
  return Text{"In the file points at one place are one: ", "ファイルでは同じ位置の点が一つになります："} + numbers +
         Text{".", "。"};
}

}  // namespace ryosen
