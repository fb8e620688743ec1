// The commands `colours` and `measure`.
#include "app/editor/camera/view_state.h"
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/document/findings.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/session/selecting.h"
#include "app/editor/texts/measure_text.h"
#include "ryosen/base/number_text.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

std::optional<MapRange> range_of(Words words) {
  const auto low = words.size() == 2 ? parse_double(words[0]) : std::nullopt;
  const auto high = words.size() == 2 ? parse_double(words[1]) : std::nullopt;
  return low && high && *low < *high ? std::optional(MapRange{*low, *high}) : std::nullopt;
}

void show_panel(Layout& layout) { layout.show(panel_opened_by(PanelOpener::coloured), true); }

}  // namespace

std::string colours_syntax() { return colour_map_ids() + "|off [LOW HIGH|all]"; }

std::optional<Text> fault_of_colours(Words arguments, const std::string&) {
  if (arguments.size() == 1 && arguments[0] == "off") return std::nullopt;
  const bool shows_all = arguments.size() == 2 && arguments[1] == "all";
  if (arguments.empty() || (arguments.size() > 1 && !shows_all && !range_of(arguments.subspan(1))))
    return wrong_arguments("colours").sentence;
  if (find_colour_map(arguments[0])) return std::nullopt;
  std::vector<std::string> known;
  for (const ColourMap& map : colour_maps()) known.emplace_back(map.id);
  const std::string wrong(arguments[0]);
  return Text{"there is no colour map '" + wrong + "'", "色分け「" + wrong + "」はありません"} +
         did_you_mean(wrong, known);
}

Outcome run_colours(Findings& findings, ViewState& view, Layout& layout, Words arguments, std::string_view) {
  if (const auto fault = fault_of_colours(arguments, {})) return usage_error(*fault);
  const ColourMap* const map = find_colour_map(arguments[0]);
  if (!map) {
    view.colouring.reset();
    return {};
  }
  if (map->against && !findings.against)
    return failed(ExitCode::refused, {"there is no other mesh to measure from; compare FILE puts one beside this one",
                                      "距離を測る相手がありません。compare FILE で並べてください"});
  const std::optional<Colouring> before = view.colouring;
  view.colouring = Colouring{map, {}};
  const MapFigures figures = figures_of(findings.map_values(*view.colouring).all());
  if (figures.count == 0) {
    view.colouring = before;
    return failed(ExitCode::refused, Text{"nothing here has a value of ", "値を持つ要素がありません："} +
                                         Text{std::string(map->name_en), std::string(map->name_ja)});
  }
  const MapRange usual = arguments.size() == 2 ? whole_range(*map, figures) : first_range(*map, figures);
  view.colouring->range = range_of(arguments.subspan(1)).value_or(usual);
  show_panel(layout);
  Outcome outcome;
  outcome.sentence = text_of(*map, figures);
  return outcome;
}

std::optional<Text> fault_of_measure(Words arguments, const std::string&) {
  if (arguments.empty()) return wrong_arguments("measure").sentence;
  if (arguments.size() == 1 && (arguments[0] == "selected" || arguments[0] == "clear")) return std::nullopt;
  if (arguments.size() > 3) return wrong_arguments("measure").sentence;
  return fault_of_names("measure", arguments);
}

Outcome run_measure(Document& document, Selecting& selecting, Layout& layout, Words arguments, std::string_view) {
  if (const auto fault = fault_of_measure(arguments, {})) return usage_error(*fault);
  if (arguments[0] == "clear") {
    selecting.measures.clear();
    return {};
  }
  Elements measured;
  if (arguments[0] == "selected") {
    measured = selecting.selection;
    if (measured.empty())
      return failed(ExitCode::refused,
                    {"nothing is selected that could be measured", "計測する要素が選択されていません"});
  } else if (Outcome outcome = find_named(document, "measure", arguments, measured); !outcome.done()) {
    return outcome;
  }
  const Measurement found = measure(document.mesh(), measured);
  if (found.values.empty())
    return failed(
        ExitCode::refused,
        {"there is nothing to measure: name an edge, a face, two elements or three vertices with finite places",
         "計測できません。稜線、面、二つの要素、または三つの頂点（座標が有限のもの）を指定してください"});
  selecting.measures.push_back(std::move(measured));
  show_panel(layout);
  Outcome outcome;
  outcome.sentence = text_of(found);
  return outcome;
}

}  // namespace ryosen
