// Distances of surfaces as text and as JSON, for every command that measures them.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "app/cli/columns.h"
#include "app/cli/console.h"
#include "app/cli/contract/json.h"
#include "app/cli/contract/measure.h"
#include "ryosen/analysis/measure/distance.h"

namespace ryosen::cli {

// Null where it is too large for a number.
inline Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

// Of one direction or of both: the keys of distance_figure_keys.
template <class Figures, const Shape& shape>
void add_figures(Record<shape>& json, const Figures& f, double diagonal) {
  const auto share = [&](double length) {
    return diagonal > 0 && std::isfinite(diagonal) ? number_or_null(length / diagonal) : Json();
  };
  json["rms"] = number_or_null(f.rms);
  json["rms_rel"] = share(f.rms);
  json["mean"] = number_or_null(f.mean);
  json["mean_rel"] = share(f.mean);
  json["hausdorff"] = number_or_null(f.hausdorff);
  json["hausdorff_rel"] = share(f.hausdorff);
  json["hausdorff_gap"] = number_or_null(f.hausdorff_gap);
  json["hausdorff_gap_rel"] = share(f.hausdorff_gap);
}

// Two rows for each: in the unit of the files, and in percent of the diagonal.
class DistanceTable {
 public:
  explicit DistanceTable(const Console& console) : console_(console) {
    table_.add({"", "rms", std::string(console.text("mean", "平均")),
                std::string(console.text("largest <=", "最大 <=")), std::string(console.text("gap", "上界の幅"))});
  }

  template <class Figures>
  void add(const std::string& name, const Figures& f, double diagonal) {
    std::vector<std::string> row{name}, shares{std::string(console_.text("  % of the diagonal", "  対角線に対する %"))};
    for (const double length : {f.rms, f.mean, f.hausdorff, f.hausdorff_gap}) {
      row.push_back(short_number(length));
      shares.push_back(diagonal > 0 ? short_number(100 * length / diagonal) : "-");
    }
    table_.add(row);
    table_.add(shares);
  }

  std::string text() const { return table_.text(); }

 private:
  const Console& console_;
  Columns table_{Columns::Others::figures};
};

}  // namespace ryosen::cli
