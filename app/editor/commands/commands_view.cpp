#include "app/editor/commands/command_functions.h"

#include <algorithm>

#include "app/editor/camera/camera_text.h"
#include "app/editor/camera/fly.h"
#include "app/editor/camera/framing.h"
#include "app/editor/commands/script.h"
#include "app/editor/session/session.h"
#include "ryosen/view/named_views.h"

namespace ryosen {

Outcome run_camera(Session& session, Words, std::string_view whole) {
  Text error;
  const auto camera = camera_from_json(whole, session.view.camera, error);
  if (!camera) return usage_error("camera: " + error.en, "camera：" + error.ja);
  session.view.camera = *camera;
  return {};
}

Outcome run_view(Session& session, Words arguments, std::string_view) {
  const bool is_here = arguments.size() == 2 && arguments[1] == "here";
  const NamedView* const view = arguments.size() == 1 || is_here ? find_named_view(arguments[0]) : nullptr;
  if (!view) return wrong_arguments("view");
  if (is_here) {
    session.view.camera = turned_to(*view, session.view.camera);
    return {};
  }
  Session* const beside = session.beside();
  session.view.camera = framing_of(session, beside ? &beside->mesh() : nullptr, camera_along(*view));
  return {};
}

Outcome run_frame(Session& session, Words arguments, std::string_view) {
  if (arguments.size() > 1 || (arguments.size() == 1 && arguments[0] != "all" && arguments[0] != "selected"))
    return wrong_arguments("frame");
  if (arguments.empty() || arguments[0] == "all") {
    session.frame_all();
    return {};
  }
  Outcome outcome;
  if (session.selecting.selection.empty())
    outcome.sentence = {"nothing is selected; the whole mesh is shown", "選択がないため、全体を表示しています"};
  fly_to(session, session.selecting.selection);
  return outcome;
}

Outcome run_drag(Session& session, Words arguments, std::string_view) {
  const auto from = arguments.size() == 2 ? parse_pixel(arguments[0]) : std::nullopt;
  const auto to = arguments.size() == 2 ? parse_pixel(arguments[1]) : std::nullopt;
  if (!from || !to) return wrong_arguments("drag");
  Navigation navigation;
  navigation.press(MouseButton::left, *from, {}, Gesture::orbit);
  navigation.move(session, *to);
  return {};
}

Outcome run_gesture(Session& session, Words arguments, std::string_view) {
  if (arguments.size() == 1 && arguments[0] == "extrude") return session.gesturing.begin_pull();
  if (arguments.size() == 1 && arguments[0] == "split") return session.gesturing.begin_split();
  if (arguments.size() == 1 && arguments[0] == "duplicate") return session.gesturing.begin_copy();
  const std::string_view kinds[] = {"move", "turn", "scale"}, axes[] = {"x", "y", "z", "normal", "yz", "zx", "xy"};
  const char* const keys[] = {"X", "Y", "Z", "N", "Shift+X", "Shift+Y", "Shift+Z"};  // that choose them
  const std::string_view word = arguments.empty() ? "" : arguments[0];
  const auto kind = std::find(std::begin(kinds), std::end(kinds), word);
  const auto axis = arguments.size() == 2 ? std::find(std::begin(axes), std::end(axes), arguments[1]) : std::end(axes);
  if (kind == std::end(kinds) || arguments.size() > 2 || (arguments.size() == 2 && axis == std::end(axes)))
    return wrong_arguments("gesture");
  Outcome outcome = session.gesturing.begin(static_cast<PointTransform::Kind>(kind - std::begin(kinds)));
  if (outcome.done() && axis != std::end(axes)) session.gesturing.key(keys[axis - std::begin(axes)]);
  return outcome;
}

Outcome run_show(Session& session, Words arguments, std::string_view) {
  if (arguments.empty() || arguments.size() > 2) return wrong_arguments("show");
  const bool on = arguments.size() == 1 || arguments[1] == "on";
  if (!on && arguments[1] != "off") return wrong_arguments("show");
  std::vector<std::string> known;
  for (const HighlightRow& row : highlight_table()) {
    known.emplace_back(row.id);
    if (arguments[0] != row.id && arguments[0] != "all") continue;
    if (on)
      session.view.highlights.insert(known.back());
    else
      session.view.highlights.erase(known.back());
  }
  if (arguments[0] == "all" || std::find(known.begin(), known.end(), arguments[0]) != known.end()) return {};
  const std::string wrong(arguments[0]);
  return usage_error(Text{"there is no highlight '" + wrong + "'", "強調表示「" + wrong + "」はありません"} +
                     did_you_mean(wrong, known));
}

}  // namespace ryosen
