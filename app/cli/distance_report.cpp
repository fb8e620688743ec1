#include "app/cli/distance_report.h"

#include <cstdio>
#include <vector>

namespace ryosen::cli {

std::string short_distance(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

DistanceTable::DistanceTable(const Console& console) : console_(console) {
  table_.add({"", "rms", std::string(console.text("mean", "平均")), std::string(console.text("largest <=", "最大 <=")),
              std::string(console.text("gap", "上界の幅"))});
}

void DistanceTable::add(const std::string& name, const std::array<double, 4>& lengths, double diagonal) {
  std::vector<std::string> row{name}, shares{std::string(console_.text("  % of the diagonal", "  対角線に対する %"))};
  for (const double length : lengths) {
    row.push_back(short_distance(length));
    shares.push_back(diagonal > 0 ? short_distance(100 * length / diagonal) : "-");
  }
  table_.add(row);
  table_.add(shares);
}

}  // namespace ryosen::cli
