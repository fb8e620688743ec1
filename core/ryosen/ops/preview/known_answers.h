// A cache of answers to questions about the edges of a mesh, for asking about many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "ryosen/ops/all.h"
#include "ryosen/ops/rules/local_facts.h"

namespace ryosen {

// Whether a question about an edge reaches further: a face or hole at the edge of the operator has more than `most`
// sides or, for a collapse, more edges than that meet at one of its ends, over all copies. False for operators on other
// elements. O(most).
bool reaches_further(const Mesh& mesh, const AnyOp& op, std::size_t most);

struct Answer {
  Verdict verdict;
  std::vector<Reason> warnings;
};

// Valid while the mesh does not change. An edge with the same subject (op.h) as one before costs the size of its
// answer, unless that names the edge or, along a cycle, has several reasons. All questions must be about the same
// operator without further arguments, and with the same `geometry`. One whose subject is the edge alone and that
// reaches further than 400 sides or edges gets the warning shape_unseen instead of those about its shape, or n of them
// would cost n squared.
class KnownAnswers {
 public:
  // With the warnings of a preview, or with none. The mesh is byte-equal afterwards.
  Answer ask(Mesh& mesh, const AnyOp& op, bool geometry);
  // With none; all questions must be of this kind.
  Answer ask(const Mesh& mesh, const AnyOp& op);

 private:
  template <class Warn>
  Answer ask(const Mesh& mesh, const AnyOp& op, const Warn& add_warnings);
  std::optional<std::uint64_t> subject(const Mesh& mesh, const AnyOp& op);
  Halfedge first_of_cycle(const Mesh& mesh, Halfedge h);

  std::unordered_map<std::uint64_t, Answer> answers_;
  LocalFacts facts_;
  std::unordered_map<Halfedge, Halfedge> first_of_cycle_;  // of each boundary halfedge of the cycles asked about
  Journal journal_;                                        // of previews; nothing is committed
};

}  // namespace ryosen
