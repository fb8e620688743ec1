// Selecting what lies in a region of the picture: `box`, `lasso`, and `band`, which makes the next drag one of them.
#include "app/editor/camera/camera_text.h"
#include "app/editor/commands/command_functions.h"
#include "app/editor/session/session.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/index_set.h"

namespace ryosen {

namespace {

struct RegionCall {
  std::vector<glm::dvec2> pixels;
  SelectHow how = SelectHow::anew;
  Picker::Depth depth = Picker::Depth::seen;
};

// X,Y X,Y ... [add|toggle] [through]
std::optional<RegionCall> read_region(Words arguments, std::size_t least, std::size_t most) {
  RegionCall call;
  for (const std::string_view word : arguments) {
    if (const auto pixel = parse_pixel(word))
      call.pixels.push_back(*pixel);
    else if (word == "add" || word == "toggle")
      call.how = word == "add" ? SelectHow::add : SelectHow::toggle;
    else if (word == "through")
      call.depth = Picker::Depth::through;
    else
      return std::nullopt;
  }
  return call.pixels.size() >= least && call.pixels.size() <= most ? std::optional(call) : std::nullopt;
}

Outcome select_in(Session& session, const RegionCall& call, const ScreenRegion& region) {
  const Picker::Depth depth = call.depth == Picker::Depth::seen ? pick_depth(session.view) : call.depth;
  if (session.shown.is_replaced()) return session.shown.refusal();
  if (session.findings().preparing())
    return failed(ExitCode::refused, {"the mesh is still being prepared; try again in a moment",
                                      "メッシュの準備中です。少し待ってからやり直してください"});
  const Elements found =
      session.findings()
          .picker(session.view)
          .pick_region(session.mesh(), session.view.camera, session.view.size, region, session.selecting.mode, depth);
  put_into_selection(session.selecting.selection.changed(), found, call.how);
  Outcome outcome;
  if (found.empty())
    outcome.sentence =
        depth == Picker::Depth::seen
            ? Text{"nothing lies wholly in there and is seen; ", "全体が収まり見えている要素はありません。"}
            : Text{"nothing lies wholly in there; ", "全体が収まる要素はありません。"};
  outcome.sentence = outcome.sentence + count_text(session.selecting.selection.size(), "one element is selected",
                                                   "# elements are selected", "# 個を選択しています");
  return outcome;
}

}  // namespace

Outcome run_box(Session& session, Words arguments, std::string_view) {
  auto call = read_region(arguments, 2, 2);
  if (!call) return wrong_arguments("box");
  return select_in(session, *call,
                   ScreenRegion::box(call->pixels[0] - session.view.origin, call->pixels[1] - session.view.origin));
}

Outcome run_lasso(Session& session, Words arguments, std::string_view) {
  auto call = read_region(arguments, 1, arguments.size());
  if (!call) return wrong_arguments("lasso");
  for (glm::dvec2& pixel : call->pixels) pixel -= session.view.origin;
  return select_in(session, *call, ScreenRegion(call->pixels));
}

Outcome run_band(ViewState& view, Words arguments, std::string_view) {
  const std::string_view word = arguments.size() == 1 ? arguments[0] : "";
  if (word != "box" && word != "lasso") return wrong_arguments("band");
  view.armed_drag = word == "box" ? DragAction::box : DragAction::lasso;
  return {};
}

}  // namespace ryosen
