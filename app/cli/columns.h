// Layout of texts in columns for help and lists.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ryosen::cli {

// Columns of a terminal that a text takes: Japanese letters and signs take two, arrows one.
inline std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0u) == 0x80) continue;
    width += byte >= 0xe3 ? 2 : 1;
  }
  return width;
}

// A number with six digits.
inline std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

// The first column is aligned to the left; the others too where they are texts, to the right where they are figures.
class Columns {
 public:
  enum class Others { texts, figures };
  explicit Columns(Others others = Others::texts) : others_(others) {}

  void add(std::string left, std::string_view right) { add({std::move(left), std::string(right)}); }
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

  // Indented by two blanks, columns two blanks apart.
  std::string text() const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows_) {
      widths.resize(std::max(widths.size(), row.size()), 0);
      for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_width(row[i]));
    }
    std::string all;
    for (const auto& row : rows_) {
      std::string line;
      for (std::size_t i = 0; i < row.size(); ++i) {
        const std::string pad(widths[i] - display_width(row[i]), ' ');
        line += "  " + (i == 0 || others_ == Others::texts ? row[i] + pad : pad + row[i]);
      }
      line.erase(line.find_last_not_of(' ') + 1);
      all += line + "\n";
    }
    return all;
  }

 private:
  Others others_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace ryosen::cli
