#include "ryosen/algo/algorithm_table.h"

#include <cassert>

#include "ryosen/algo/algorithm_rows.h"
#include "ryosen/base/rows.h"

namespace ryosen {

namespace {

std::deque<AlgorithmRow>& algorithm_rows() {
  static std::deque<AlgorithmRow> rows = [] {
    std::deque<AlgorithmRow> all;
    for (const std::vector<AlgorithmRow>& folder :
         {repair_rows(), primitive_rows(), point_cloud_rows(), transform_rows(), duplicate_rows(), simplify_rows(),
          subdivision_rows(), smoothing_rows(), remeshing_rows(), hull_rows()})
      all.insert(all.end(), folder.begin(), folder.end());
    return all;
  }();
  return rows;
}

}  // namespace

const std::deque<AlgorithmRow>& algorithm_table() { return algorithm_rows(); }

const AlgorithmRow* find_algorithm(std::string_view id) { return find_row(algorithm_rows(), id); }

ScopedAlgorithm::ScopedAlgorithm(AlgorithmRow row) : row_(&algorithm_rows().emplace_back(std::move(row))) {}

ScopedAlgorithm::~ScopedAlgorithm() {
  assert(row_ == &algorithm_rows().back());
  algorithm_rows().pop_back();
}

}  // namespace ryosen
