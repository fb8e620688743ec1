#include "app/ui/textbook/growth_plots.h"

namespace ryosen {

LogPlot growth_plot(std::span<const forms::GrowthCurve> curves, forms::GrowthOf of, forms::Relation relation,
                    GrowthAxis axis, Language language) {
  const bool is_count = axis == GrowthAxis::count;
  const forms::GrowthRow& row = forms::growth_rows()[static_cast<std::size_t>(of)];
  const forms::RelationRow& asked = forms::relations()[static_cast<std::size_t>(relation)];
  Text title{std::string(row.en), std::string(row.ja)};
  if (of == forms::GrowthOf::query) title += Text{": " + std::string(asked.en), "：" + std::string(asked.ja)};
  const Text up =
      is_count ? Text{std::string(row.counted_en), std::string(row.counted_ja)} : Text{"milliseconds", "ミリ秒"};
  LogPlot plot{title.in(language),
               Text{"faces", "面の数"}.in(language),
               up.in(language),
               Text{"slope", "傾き"}.in(language),
               {}};
  for (const forms::GrowthCurve& curve : curves) {
    if (curve.of != of || (curve.relation && *curve.relation != relation)) continue;
    LogCurve drawn{std::string(language == Language::japanese ? curve.ja : curve.en),
                   forms::slope_text(is_count ? slope_of_count(curve) : slope_of_time(curve)),
                   {}};
    for (const forms::GrowthPoint& point : curve.points)
      drawn.points.emplace_back(static_cast<double>(point.faces), is_count ? point.count : 1e3 * point.seconds);
    plot.curves.push_back(std::move(drawn));
  }
  return plot;
}

}  // namespace ryosen
