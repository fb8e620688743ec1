#include "app/editor/document/file_findings.h"

#include <utility>

#include "app/editor/document/written_mesh.h"
#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/io/edited_file.h"

namespace ryosen {

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
    numbers = numbers + (numbers.en.empty() ? Text{} : Text{", ", "、"}) +
              Text{std::string(row.id) + number, std::string(row.id) + number};
  }
  if (numbers.en.empty()) return std::nullopt;
  return Text{"In the file points at one place are one: ", "ファイルでは同じ位置の点が一つになります："} + numbers +
         Text{".", "。"};
}

}  // namespace ryosen
