// The commands `colours` and `measure`; and what is searched for only where somebody asks for it.
#include "app/editor/camera/view_state.h"
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/document/findings.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/session/frontend.h"
#include "app/editor/session/selecting.h"
#include "app/editor/texts/measure_text.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/number_text.h"
#include "ryosen/base/rows.h"
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

std::string colours_syntax() { return colour_map_ids() + "|ATTRIBUTE|off [LOW HIGH|all]"; }

std::optional<Text> fault_of_colours(Words arguments, const std::string&) {
  if (arguments.size() == 1 && arguments[0] == "off") return std::nullopt;
  const bool shows_all = arguments.size() == 2 && arguments[1] == "all";
  if (arguments.empty() || (arguments.size() > 1 && !shows_all && !range_of(arguments.subspan(1))))
    return wrong_arguments("colours").sentence;
  if (find_colour_map(arguments[0])) return std::nullopt;
  const std::string wrong(arguments[0]);
  return Text{"there is no colour map '" + wrong + "'", "色分け「" + wrong + "」はありません"} +
         did_you_mean(wrong, ids_of_rows(colour_maps()));
}

Outcome run_colours(Findings& findings, ViewState& view, Layout& layout, Words arguments, std::string_view) {
  if (const auto fault = fault_of_colours(arguments, {})) return usage_error(*fault);
  const ColourMap* const map = find_colour_map(arguments[0]);
  if (!map) {
    view.colouring.reset();
    return {};
  }
  if (!has_numbers(findings.mesh(), *map)) return failed(ExitCode::refused, no_numbers(*map));
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
  return done_with(text_of(*map, figures));
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
  return done_with(text_of(found));
}

std::optional<Text> fault_of_self_intersections(Words arguments, const std::string&) {
  const bool is_off = arguments.size() == 1 && arguments[0] == "off";
  return fault_unless(arguments.empty() || is_off, "self_intersections");
}

Outcome run_self_intersections(Findings& findings, const Frontend& frontend, Words arguments, std::string_view) {
  if (const auto fault = fault_of_self_intersections(arguments, {})) return usage_error(*fault);
  if (!arguments.empty()) {
    findings.forget(ProblemKind::self_intersection);
    return {};
  }
  Progress progress(frontend.on_progress);
  constexpr std::size_t most_pairs = 100000;  // of which it is known what a face meets; n copies of one make n^2 / 2
  auto found = find_self_intersections(findings.mesh(), most_pairs, 0, progress);
  if (!found) return cancelled();
  std::vector<std::uint32_t> faces;
  for (const Face f : found->faces) faces.push_back(f.index);
  const std::size_t pairs = found->count;
  findings.put(ProblemKind::self_intersection, faces, std::move(found->pairs));
  Outcome outcome = done_with({"No face meets another elsewhere than in common vertices and edges.",
                               "共有する頂点・稜線以外で交わる面はありません。"});
  if (!faces.empty()) {
    outcome.sentence = row_of(ProblemKind::self_intersection).sentence(faces.size());
    outcome.say(count_text(pairs, "It is one pair.", "They are # pairs.", "組の数は # です。"));
  }
  return outcome;
}

}  // namespace ryosen
