// The one table of algorithms: what changes a mesh as a whole.
//
// To add one, write its function, in a pair of files of its own where it is large, and its row in the list of its
// folder; the lists of the folders are joined in algorithm_table.cpp. From the row come its subcommand with its flags
// (`ryosen ID FILE -o OUT --PARAMETER VALUE`), its command in scripts (`ID PARAMETER=VALUE ...`), its fields in the
// window, help, progress, cancel, the history, recovery, and the tests that go over the table: these want that each row
// finds something to do on their mesh of all defects. One with a parameter of each kind is
// tests/support/core/scatter_algorithm.h.
#pragma once

#include <deque>
#include <string_view>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// Repairs first, in the order in which they are done, each after those that make its work easier; then primitives,
// transforms, copies and the hull. Rows stay where they are.
const std::deque<AlgorithmRow>& algorithm_table();
// The row with this id; null if there is none.
const AlgorithmRow* find_algorithm(std::string_view id);

// A further row for its life: for tests, and for programs that embed the library. The last one made ends first. Not
// while anything else reads the table.
class ScopedAlgorithm {
 public:
  explicit ScopedAlgorithm(AlgorithmRow row);
  ~ScopedAlgorithm();
  ScopedAlgorithm(const ScopedAlgorithm&) = delete;
  ScopedAlgorithm& operator=(const ScopedAlgorithm&) = delete;

 private:
  const AlgorithmRow* row_;
};

}  // namespace ryosen
