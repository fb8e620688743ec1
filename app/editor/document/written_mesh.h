// A mesh as its file gives it back, and what is found in that and not in the document, or the other way round.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "ryosen/algo/repair/recipe.h"
#include "ryosen/document/document.h"
#include "ryosen/io/formats.h"

namespace ryosen {

class WrittenMesh {
 public:
  WrittenMesh(MeshFile contents, const Format& format);

  const FindingCounts& counts() const { return counts_; }
  FoundInMesh found() const { return {&mesh_, counts_, quarantine_.size()}; }
  // Into these findings, as count_kinds does.
  void count(std::size_t KindCount::*at, std::vector<KindCount>& findings) const;
  // Whether repairing the document is repairing this mesh.
  bool is_like(const Document& document) const;
  std::size_t boundary_edges() const { return counts_[static_cast<std::size_t>(ProblemKind::boundary_loop)]; }

 private:
  Mesh mesh_;
  std::vector<QuarantinedFace> quarantine_;
  std::vector<Vertex> on_lines_;
  FindingCounts counts_{};
};

// A sentence with the kinds of problems of which the file at this path will have another number than the document: one
// without a list of vertices makes one point of those at one place. None where the numbers are equal. Cost: that of
// writing and reading such a file; nothing for other formats.
std::optional<Text> file_findings_text(const Document& document, const std::filesystem::path& path);

}  // namespace ryosen
