#include "app/cli/textbook/form_growth.h"

#include <algorithm>

#include "app/cli/columns.h"
#include "app/cli/console.h"
#include "app/cli/contract/json.h"
#include "app/cli/contract/textbook.h"
#include "app/cli/outputs.h"
#include "app/ui/log_plot.h"
#include "app/ui/textbook/growth_plots.h"
#include "ryosen/base/rows.h"
#include "ryosen/textbook/forms/growth/meshes.h"

namespace ryosen::cli {

namespace {

using forms::GrowthCurve;
using forms::GrowthOf;
using forms::GrowthPoint;
using forms::GrowthRow;
using forms::RelationRow;

Json to_json(const GrowthPoint& point) {
  Record<growth_point_shape> json;
  json["faces"] = point.faces;
  json["comparisons"] = point.count;
  json["ms"] = 1e3 * point.seconds;
  return std::move(json).json();
}

std::string json_line_of(const GrowthCurve& curve) {
  const GrowthRow& row = forms::growth_rows()[static_cast<std::size_t>(curve.of)];
  Record<growth_shape> json;
  json["of"] = row.id;
  json["id"] = curve.id;
  json["relation"] = curve.relation ? Json(forms::relations()[static_cast<std::size_t>(*curve.relation)].id) : Json();
  json.put(curve.en, curve.ja);
  json["counted"] = cli::to_json(Text{std::string(row.counted_en), std::string(row.counted_ja)});
  json["points"] = array_of(curve.points, [](const GrowthPoint& point) { return to_json(point); });
  json["slope"] = or_null(slope_of_count(curve));
  json["time_slope"] = or_null(slope_of_time(curve));
  return line_of(json);
}

// The slopes of a kind of which each curve is one thing.
std::string slopes_text(std::span<const GrowthCurve> curves, GrowthOf of, const Console& console) {
  const GrowthRow& row = forms::growth_rows()[static_cast<std::size_t>(of)];
  Columns table(Columns::Others::figures);
  table.add({"", std::string(console.text("count", "回数")), std::string(console.text("time", "時間"))});
  for (const GrowthCurve& curve : curves)
    if (curve.of == of)
      table.add({std::string(console.text(curve.en, curve.ja)), forms::slope_text(slope_of_count(curve)),
                 forms::slope_text(slope_of_time(curve))});
  return std::string(console.text(row.en, row.ja)) + " (" + std::string(console.text(row.counted_en, row.counted_ja)) +
         ")\n" + table.text();
}

std::string queries_text(std::span<const GrowthCurve> curves, const Console& console) {
  const GrowthRow& row = forms::growth_rows()[static_cast<std::size_t>(GrowthOf::query)];
  Columns table(Columns::Others::figures);
  std::vector<std::string> head{""};
  for (const RelationRow& relation : forms::relations()) head.emplace_back(console.text(relation.en, relation.ja));
  table.add(head);
  for (auto first = curves.begin(); first != curves.end();) {
    const auto last = std::find_if(
        first, curves.end(), [&](const GrowthCurve& curve) { return curve.of != first->of || curve.id != first->id; });
    std::vector<std::string> cells(1 + forms::relation_count, "-");
    cells[0] = console.text(first->en, first->ja);
    for (auto curve = first; curve != last; ++curve)
      if (curve->relation)
        cells[1 + static_cast<std::size_t>(*curve->relation)] = forms::slope_text(slope_of_count(*curve));
    if (first->of == GrowthOf::query) table.add(cells);
    first = last;
  }
  return std::string(console.text(row.en, row.ja)) + " (" + std::string(console.text(row.counted_en, row.counted_ja)) +
         ")\n" + table.text();
}

std::string text_of(std::span<const GrowthCurve> curves, const std::vector<Mesh>& meshes, const Console& console) {
  const std::string least = std::to_string(meshes.front().live().faces),
                    most = std::to_string(meshes.back().live().faces);
  const Text one_size{"Measured at one size alone, " + most +
                          " faces: too few to be cut into growing parts, so that there are no slopes.\n",
                      most + " 面の一つの大きさだけで測りました（分割して増やすには面が足りず、傾きはありません）。\n"};
  return console.text(
             meshes.size() == 1
                 ? one_size
                 : Text{"Growth from " + least + " to " + most +
                            " faces, as a slope: 0 stays, 1 grows in proportion, 2 with the square.\n",
                        least + " 面から " + most + " 面までの増え方（傾き：0 は一定、1 は比例、2 は二乗）\n"}) +
         slopes_text(curves, GrowthOf::pairing, console) + queries_text(curves, console) +
         slopes_text(curves, GrowthOf::collapse, console);
}

Result<forms::Relation> wanted_relation(const Arguments& arguments) {
  const std::string* const id = arguments.value("--relation");
  if (!id) return forms::Relation::vertex_faces;
  if (const RelationRow* const row = find_row(forms::relations(), *id)) return row->relation;
  const std::string known = joined_ids(forms::relations(), ", ");
  return usage_failure("bad_value", {"--relation is one of " + known + ".", "--relation は " + known + " です。"});
}

Result<Theme> wanted_theme(const Arguments& arguments) {
  const std::string* const word = arguments.value("--theme");
  if (!word || *word == "dark") return Theme::dark;
  if (*word == "light") return Theme::light;
  return usage_failure("bad_value", {"--theme is dark or light.", "--theme は dark か light です。"});
}

Status write_plot(std::span<const GrowthCurve> curves, forms::Relation relation, Theme theme, const std::string& path,
                  Language language) {
  constexpr int width_px = 1440;
  std::vector<LogPlot> plots;
  for (const GrowthRow& row : forms::growth_rows())
    for (const GrowthAxis axis : {GrowthAxis::count, GrowthAxis::time})
      plots.push_back(growth_plot(curves, row.of, relation, axis, language));
  const Result<Image> picture = picture_of_plots(plots, 2, width_px, theme, language);
  return picture ? write_png(*picture, path) : Status(picture.failure());
}

}  // namespace

ExitCode print_form_growth(const Mesh* mesh, const Arguments& arguments, const Console& console) {
  const Result<forms::Relation> relation = wanted_relation(arguments);
  if (!relation) return console.fail(relation.failure());
  const Result<Theme> theme = wanted_theme(arguments);
  if (!theme) return console.fail(theme.failure());
  const std::string* const plot = arguments.value("--plot");
  if (plot)
    if (const Status may =
            files_of_run(arguments, mesh ? arguments.operands()[0] : "").may_write(*plot, FileRole::picture);
        !may)
      return console.fail(may.failure());
  const forms::GrowthEffort effort;
  const std::vector<Mesh> meshes =
      mesh ? forms::growing_parts(*mesh, effort.most_faces) : forms::growing_tori(effort.most_faces);
  if (meshes.empty())
    return console.fail(
        make_failure(ExitCode::refused, "refused", {"It has no faces to measure on.", "測るための面がありません。"}),
        arguments.operands()[0]);
  Progress progress(report_on(console, "growth"));
  const std::vector<GrowthCurve> curves = forms::measure_growth(meshes, effort, progress);
  if (plot)
    if (const Status written = write_plot(curves, *relation, *theme, *plot, console.language); !written)
      return console.fail(written.failure());
  std::string all;
  if (console.json)
    for (const GrowthCurve& curve : curves) all += json_line_of(curve);
  else
    all = text_of(curves, meshes, console);
  return console.end(all);
}

}  // namespace ryosen::cli
