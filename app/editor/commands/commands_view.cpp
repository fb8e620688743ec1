// The commands of the view: camera, highlights, switches, gestures, and where the mesh is cut.
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/editor/camera/camera_text.h"
#include "app/editor/camera/cutting.h"
#include "app/editor/camera/view_state.h"
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/fly.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/input/view/navigation.h"
#include "app/editor/session/session.h"
#include "ryosen/base/number_text.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/scene/view/named_views.h"

namespace ryosen {

Outcome run_camera(ViewState& view, Words, std::string_view whole) {
  Text error;
  const auto camera = camera_from_json(whole, view.camera, error);
  if (!camera) return usage_error("camera: " + error.en, "camera：" + error.ja);
  view.camera = *camera;
  return {};
}

Outcome run_view(ViewState& view, const Framing& framing, Words arguments, std::string_view) {
  const bool is_here = arguments.size() == 2 && arguments[1] == "here";
  const NamedView* const named = arguments.size() == 1 || is_here ? find_named_view(arguments[0]) : nullptr;
  if (!named) return wrong_arguments("view");
  if (is_here) {
    view.camera = turned_to(*named, view.camera);
    return {};
  }
  view.camera = framing.of_all(camera_along(*named));
  return {};
}

Outcome run_frame(Findings& findings, ViewState& view, Framing& framing, const Selecting& selecting, Words arguments,
                  std::string_view) {
  if (arguments.size() > 1 || (arguments.size() == 1 && arguments[0] != "all" && arguments[0] != "selected"))
    return wrong_arguments("frame");
  if (arguments.empty() || arguments[0] == "all") {
    framing.frame_all();
    return {};
  }
  Outcome outcome;
  if (selecting.selection.empty())
    outcome.sentence = {"nothing is selected; the whole mesh is shown", "選択がないため、全体を表示しています"};
  fly_to(findings, view, framing, selecting.selection);
  return outcome;
}

Outcome run_drag(Session& session, Words arguments, std::string_view) {
  const auto from = arguments.size() == 2 ? parse_pixel(arguments[0]) : std::nullopt;
  const auto to = arguments.size() == 2 ? parse_pixel(arguments[1]) : std::nullopt;
  if (!from || !to) return wrong_arguments("drag");
  Navigation navigation;
  navigation.press(MouseButton::left, *from, {}, DragAction::orbit);
  navigation.move(session, *to);
  return {};
}

Outcome run_gesture(Gesturing& gesturing, Words arguments, std::string_view) {
  if (arguments.size() == 1 && arguments[0] == "extrude") return gesturing.begin_extrusion();
  if (arguments.size() == 1 && arguments[0] == "split") return gesturing.begin_split();
  if (arguments.size() == 1 && arguments[0] == "duplicate") return gesturing.begin_copy();
  const std::string_view kinds[] = {"move", "turn", "scale"}, axes[] = {"x", "y", "z", "normal", "yz", "zx", "xy"};
  const char* const keys[] = {"X", "Y", "Z", "N", "Shift+X", "Shift+Y", "Shift+Z"};  // that choose them
  const std::string_view word = arguments.empty() ? "" : arguments[0];
  const auto kind = std::find(std::begin(kinds), std::end(kinds), word);
  const auto axis = arguments.size() == 2 ? std::find(std::begin(axes), std::end(axes), arguments[1]) : std::end(axes);
  if (kind == std::end(kinds) || arguments.size() > 2 || (arguments.size() == 2 && axis == std::end(axes)))
    return wrong_arguments("gesture");
  Outcome outcome = gesturing.begin(static_cast<PointTransform::Kind>(kind - std::begin(kinds)));
  if (outcome.done() && axis != std::end(axes)) gesturing.key(keys[axis - std::begin(axes)]);
  return outcome;
}

Outcome run_show(ViewState& view, Words arguments, std::string_view) {
  if (arguments.empty() || arguments.size() > 2) return wrong_arguments("show");
  const bool on = arguments.size() == 1 || arguments[1] == "on";
  if (!on && arguments[1] != "off") return wrong_arguments("show");
  std::vector<std::string> known;
  for (const HighlightRow& row : highlight_table()) {
    known.emplace_back(row.id);
    if (arguments[0] != row.id && arguments[0] != "all") continue;
    if (on)
      view.highlights.insert(known.back());
    else
      view.highlights.erase(known.back());
  }
  if (arguments[0] == "all" || std::find(known.begin(), known.end(), arguments[0]) != known.end()) return {};
  const std::string wrong(arguments[0]);
  return usage_error(Text{"there is no highlight '" + wrong + "'", "強調表示「" + wrong + "」はありません"} +
                     did_you_mean(wrong, known));
}

// Its run looks the switch up again, since one of ScopedViewSwitch comes and goes.
CommandRow row_of(const ViewSwitch& given) {
  const auto run = [id = given.id](Session& session, Words arguments, std::string_view) -> Outcome {
    const ViewSwitch& row = *find_view_switch(id);
    if (arguments.size() != 1) return wrong_arguments(row.id);
    auto value = find_value(row, arguments[0]);
    if (row.toggles() && arguments[0] == "toggle") value = (row.value(session) + 1) % row.values.size();
    if (!value) return wrong_arguments(row.id);
    row.set(session, *value);
    return {};
  };
  return {.id = given.id,
          .syntax = (given.toggles() ? "toggle|" : "") + ids_of(given.values),
          .help_en = given.help_en,
          .help_ja = given.help_ja,
          .effect = Effect::view,
          .run = run};
}

namespace {

// A share, or a step with its sign; none for anything else.
std::optional<double> share_of(Words arguments) {
  if (arguments.size() != 1) return std::nullopt;
  std::string_view word = arguments[0];
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto value = parse_double(word);
  return value && std::abs(*value) <= 1 ? value : std::nullopt;
}

}  // namespace

std::optional<Text> fault_of_clip_at(Words arguments, const std::string&) {
  if (share_of(arguments)) return std::nullopt;
  return wrong_arguments("clip_at").sentence;
}

Outcome run_clip_at(const Mesh& mesh, ViewState& view, Words arguments, std::string_view) {
  const auto share = share_of(arguments);
  if (!share) return wrong_arguments("clip_at");
  if (!view.cut)
    return failed(ExitCode::refused, {"there is no clipping plane to move; clip x, for one, begins with it",
                                      "動かす断面がありません。clip x などで断面を表示してください"});
  const bool is_step = arguments[0][0] == '+' || arguments[0][0] == '-';
  move_cut(mesh, view, is_step ? view.cut->share + *share : *share);
  return {};
}

}  // namespace ryosen
