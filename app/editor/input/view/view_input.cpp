#include "app/editor/input/view/view_input.h"

#include <glm/geometric.hpp>
#include <utility>

#include "app/editor/camera/camera_text.h"
#include "app/editor/commands/text/outcomes.h"
#include "app/editor/preferences/keys.h"
#include "app/editor/session/session.h"

namespace ryosen {

void ViewInput::press(MouseButton button, const Pointer& at) {
  session_.view.pointer = at.pixel;
  // The window may have missed its release.
  if (gesture_ended_ && gesture_ended_->button == button) gesture_ended_.reset();
  if (button == MouseButton::left) held_handle_.reset();
  if (session_.gesturing.is_active() && button != MouseButton::middle) {
    gesture_ended_ = {button, {}};
    if (button == MouseButton::left) {
      session_.gesturing.follow(at.pixel, at.modifiers);
      gesture_ended_->outcome = end_gesture();
    } else {
      gesture_ended_->outcome = give_up_gesture();
    }
    return;
  }
  const InputPreset& preset = input_presets()[session_.preferences.input_preset];
  const bool is_armed = session_.view.armed_drag && button == MouseButton::left;
  const DragAction action = is_armed ? *session_.view.armed_drag : drag_action_of(preset, button, at.modifiers);
  const HandleRow* const handle =
      button == MouseButton::left && !is_armed && !is_dragging() && !session_.pointing.axis_end_at(at.pixel)
          ? session_.pointing.handle_at(at.pixel, at.modifiers)
          : nullptr;
  if (handle) {
    held_handle_ = HeldHandle{handle, at.pixel, at.modifiers};
    return;
  }
  band_modifiers_ = at.modifiers;
  for (const DragRow& row : preset.drags) {
    if (is_armed || row.button != button || row.shift != at.modifiers.shift || row.ctrl != at.modifiers.ctrl) continue;
    band_modifiers_.shift = band_modifiers_.ctrl = false;  // they asked for the box
  }
  navigation_.press(button, at.pixel, at.modifiers, action, session_.preferences.size_scale());
}

void ViewInput::drag_handle(const Pointer& at) {
  if (!held_handle_->has_begun &&
      glm::length(at.pixel - held_handle_->start) > click_reach_px * session_.preferences.size_scale()) {
    held_handle_->has_begun = true;
    session_.view.pointer = held_handle_->start;
    run(std::string(held_handle_->row->line));
    session_.view.pointer = at.pixel;
  }
  if (session_.gesturing.is_active()) session_.gesturing.follow(at.pixel, at.modifiers);
}

// The gesture may have been ended before, by a key or the other button.
Outcome ViewInput::let_go_of_handle(const Pointer& at) {
  Outcome outcome;
  const HeldHandle held = *std::exchange(held_handle_, std::nullopt);
  if (held.has_begun && session_.gesturing.is_active()) {
    session_.gesturing.follow(at.pixel, at.modifiers);
    outcome = end_gesture();
  } else if (!held.has_begun && !is_dragging() && clicks_through(held)) {
    navigation_.press(MouseButton::left, held.start, held.modifiers, DragAction::orbit,
                      session_.preferences.size_scale());
    outcome = end_click(navigation_.release(MouseButton::left, at.pixel, at.now_s));
  }
  point(at);
  return outcome;
}

bool ViewInput::clicks_through(const HeldHandle& held) {
  return (session_.selecting.selection.size() == 1 || held.modifiers.ctrl) &&
         session_.pointing.pick_to_select(held.start, session_.selecting.pointed_sort());
}

void ViewInput::give_up_drags() {
  navigation_.cancel();
  if (std::exchange(held_handle_, std::nullopt)) session_.gesturing.cancel();
}

std::string ViewInput::line_of_band(Modifiers at_end) const {
  const Band& band = *session_.view.band;
  std::string line(band.action == DragAction::box ? "box" : "lasso");
  for (const glm::dvec2& pixel : band.path) line += " " + format_pixel(pixel);
  if (band_modifiers_.shift) line += " add";
  if (band_modifiers_.ctrl && !band_modifiers_.shift) line += " toggle";
  if (band_modifiers_.alt || at_end.alt) line += " through";
  return line;
}

Outcome ViewInput::release(MouseButton button, const Pointer& at) {
  session_.view.pointer = at.pixel;
  if (button == MouseButton::left && held_handle_) return let_go_of_handle(at);
  if (gesture_ended_ && gesture_ended_->button == button) return std::exchange(gesture_ended_, std::nullopt)->outcome;
  const auto ended = navigation_.release(button, at.pixel, at.now_s);
  Outcome outcome;
  if (session_.view.band && !navigation_.is_dragging()) {
    const std::string line = line_of_band(at.modifiers);
    session_.view.band.reset();
    session_.view.armed_drag.reset();
    outcome = run(line);
  }
  if (ended) outcome = end_click(ended);
  point(at);
  return outcome;
}

Outcome ViewInput::end_click(const std::optional<Navigation::Click>& ended) {
  // A panel may have been opened since the press.
  if (!ended || !is_over_view(ended->pixel)) return {};
  if (ended->button == MouseButton::right) return open_menu(*ended);
  // With a tool two quick clicks are two edits.
  if (!ended->is_double || !session_.selecting.tool.empty() || session_.pointing.axis_end_at(ended->pixel))
    return click(*ended);
  set_centre(session_, ended->pixel);
  return {};
}

void ViewInput::move(const Pointer& at) {
  session_.view.pointer = at.pixel;
  if (session_.gesturing.is_active() && !navigation_.is_dragging())
    session_.gesturing.follow(at.pixel, at.modifiers);
  else if (held_handle_ && !navigation_.is_dragging())
    drag_handle(at);
  else if (navigation_.move(session_, at.pixel))
    session_.pointing.point_away();
  else
    point(at);
}

void ViewInput::wheel(double steps, const Pointer& at) {
  if (session_.gesturing.widen(steps)) return;
  navigation_.wheel(session_, at.pixel, steps);
  point(at);
}

Outcome ViewInput::key(const std::string& chord) {
  if (const auto outcome = session_.gesturing.key(chord)) return *outcome;
  if (const auto row = find_key(chord, input_presets()[0], session_.preferences.bindings))
    return session_.run(row->command);
  return is_panel_key(chord) ? no_panel_for_key(chord) : no_such_key(chord);
}

Outcome ViewInput::type(std::string_view) { return no_field_to_type(); }

void ViewInput::point(const Pointer& at) {
  if (navigation_.is_dragging()) return;
  if (is_over_view(at.pixel))
    session_.pointing.point_at(at.pixel, at.modifiers);
  else
    session_.pointing.point_away();
}

Outcome ViewInput::click(const Navigation::Click& click) {
  return session_.pointing.click(click.pixel, session_.selecting.tool, click.modifiers);
}

Outcome ViewInput::open_menu(const Navigation::Click& click) {
  session_.pointing.select_for_menu(click.pixel);
  return {};
}

Outcome no_such_key(std::string_view chord) {
  const std::string name(chord);
  return usage_error("no key '" + name + "' (see ryosen keys)",
                     "キー「" + name + "」はありません（ryosen keys を参照）");
}

Outcome no_panel_for_key(std::string_view chord) {
  const std::string name(chord);
  return failed(ExitCode::refused, {"the key '" + name + "' is for panels, and there are none here",
                                    "キー「" + name + "」はパネル用ですが、ここにはパネルがありません"});
}

Outcome no_field_to_type() {
  return failed(ExitCode::refused,
                {"no field takes text here; click into one or open one first, such as with key F3",
                 "文字を受け取る入力欄がありません。先に入力欄をクリックするか、key F3 などで開いてください"});
}

std::unique_ptr<Input> make_view_input(Session& session) { return std::make_unique<ViewInput>(session); }

}  // namespace ryosen
