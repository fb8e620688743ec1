// Two-column text layout for help and lists.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ryosen::cli {

class Columns {
 public:
  // The left text is ASCII; the right one may be anything.
  void add(std::string left, std::string_view right) { rows_.emplace_back(std::move(left), right); }

  // Indented by two spaces, the right column aligned.
  std::string text() const {
    std::size_t width = 0;
    for (const auto& row : rows_) width = std::max(width, row.first.size());
    std::string all;
    for (const auto& [left, right] : rows_)
      all += "  " + left + std::string(right.empty() ? 0 : width - left.size() + 2, ' ') + right + "\n";
    return all;
  }

 private:
  std::vector<std::pair<std::string, std::string>> rows_;
};

}  // namespace ryosen::cli
