#include "app/ui/window_input.h"

#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/editor/preferences/keys.h"
#include "app/editor/session/session.h"

namespace ryosen {

namespace {

constexpr std::pair<std::string_view, int> imgui_keys[] = {
    {"Tab", ImGuiKey_Tab},
    {"Left", ImGuiKey_LeftArrow},
    {"Right", ImGuiKey_RightArrow},
    {"Up", ImGuiKey_UpArrow},
    {"Down", ImGuiKey_DownArrow},
    {"Home", ImGuiKey_Home},
    {"End", ImGuiKey_End},
    {"Delete", ImGuiKey_Delete},
    {"Backspace", ImGuiKey_Backspace},
    {"Enter", ImGuiKey_Enter},
    {"Escape", ImGuiKey_Escape},
    {"Space", ImGuiKey_Space},
    {"PageUp", ImGuiKey_PageUp},
    {"PageDown", ImGuiKey_PageDown},
    {"A", ImGuiKey_A},
    {"C", ImGuiKey_C},
    {"V", ImGuiKey_V},
    {"X", ImGuiKey_X},
    {"Y", ImGuiKey_Y},
    {"Z", ImGuiKey_Z},
};

static_assert(std::equal(std::begin(imgui_keys), std::end(imgui_keys), std::begin(panel_keys), std::end(panel_keys),
                         [](const auto& row, std::string_view name) { return row.first == name; }));

// Of a key that is_panel_key, else -1.
int panel_key_of(std::string_view chord) {
  for (const auto& [name, key] : imgui_keys)
    if (name == key_of(chord)) return key;
  return -1;
}

// F1 to F12, which no entry of a menu takes.
bool is_function_key(std::string_view chord) {
  return chord.size() > 1 && chord[0] == 'F' && chord[1] >= '1' && chord[1] <= '9';
}

}  // namespace

void WindowInput::press(MouseButton button, const Pointer& at) {
  is_alone_ = false;
  is_held_[static_cast<std::size_t>(button)] = true;
  show_pointer(at);
  if (is_over_view(at.pixel)) {
    ViewInput::press(button, at);
  } else {
    catch_up();
    gui_.button(static_cast<int>(button), true);
    catch_up();
    is_held_by_panels_ = true;
  }
  show_event();
}

Outcome WindowInput::release(MouseButton button, const Pointer& at) {
  is_alone_ = false;
  is_held_[static_cast<std::size_t>(button)] = false;
  show_pointer(at);
  gui_.button(static_cast<int>(button), false);
  if (std::exchange(is_held_by_panels_, false)) catch_up();
  Outcome outcome = ViewInput::release(button, at);
  show_event();
  return outcome;
}

void WindowInput::move(const Pointer& at) {
  show_pointer(at);
  ViewInput::move(at);
  show_event();
}

void WindowInput::wheel(double steps, const Pointer& at) {
  is_alone_ = false;
  show_pointer(at);
  if (is_over_view(at.pixel))
    ViewInput::wheel(steps, at);
  else
    gui_.wheel(steps);
  show_event();
}

Outcome WindowInput::open_menu(const Navigation::Click& click) {
  Outcome outcome = ViewInput::open_menu(click);
  gui_.open_element_menu();
  return outcome;
}

Outcome WindowInput::key_down(const std::string& chord, bool is_again) {
  if (catch_up_ && gui_.awaits_frame(session_.layout)) catch_up_();
  navigation_.forget_click();
  return press_key(chord, is_again, input_presets()[session_.preferences.input_preset]);
}

Outcome WindowInput::press_key(const std::string& chord, bool is_again, const InputPreset& preset) {
  const Modifiers modifiers = modifiers_of(chord);
  gui_.modifiers(modifiers.shift, modifiers.ctrl);
  const bool is_pressing = std::find(is_held_.begin(), is_held_.end(), true) != is_held_.end();
  is_alone_ = chord == lone_key && (!is_again || is_alone_) && !is_pressing;
  if (chord == lone_key) return {};
  if (const int key = panel_key_of(chord); key >= 0) gui_.key(key, true);
  return act_on(chord, is_again, preset);
}

Outcome WindowInput::act_on(const std::string& chord, bool is_again, const InputPreset& preset) {
  if (gui_.take_chord(session_.layout, chord)) return {};
  const auto row = find_key(chord, preset, session_.preferences.bindings);
  if (gui_.has_menu(session_.layout)) {
    const bool opens_menus = row && row->command == find_key(lone_key, preset)->command;
    const bool is_done_behind = row && !opens_menus && is_function_key(chord);
    if (chord == "Escape" || opens_menus || is_done_behind) gui_.close_menus();
    return is_done_behind ? gui_.run(session_, row->command) : Outcome();
  }
  if (session_.gesturing.is_active() && !gui_.owns_keys()) return gui_.keep(session_, *session_.gesturing.key(chord));
  if (gui_.has_start(session_) && !gui_.owns_keys() && StartPage::takes(chord)) return {};
  if (!row || (is_again && !row->repeats)) return {};
  if ((gui_.owns_keys() || !session_.layout.open_panel.empty()) && !row->acts_always) return {};
  return gui_.run(session_, row->command);
}

Outcome WindowInput::let_key_go(const std::string& chord, const InputPreset& preset) {
  const Modifiers modifiers = modifiers_of(chord);
  gui_.modifiers(modifiers.shift, modifiers.ctrl);
  if (const int key = panel_key_of(chord); key >= 0) gui_.key(key, false);
  return chord == lone_key && std::exchange(is_alone_, false) ? act_on(chord, false, preset) : Outcome();
}

Outcome WindowInput::key_up(const std::string& chord) {
  return let_key_go(chord, input_presets()[session_.preferences.input_preset]);
}

Outcome WindowInput::key(const std::string& chord) {
  show_event();
  if (!find_key(chord, input_presets()[0], session_.preferences.bindings) && !is_panel_key(chord) &&
      !session_.gesturing.is_active() && !gui_.wants_chord(session_.layout))
    return no_such_key(chord);
  Outcome outcome = press_key(chord, false, input_presets()[0]);
  if (Outcome then = let_key_go(chord, input_presets()[0]); chord == lone_key) outcome = std::move(then);
  show_event();
  gui_.modifiers(false, false);
  return outcome;
}

Outcome WindowInput::type(std::string_view text) {
  show_event();
  if (!gui_.owns_keys()) return no_field_to_type();
  gui_.text(std::string(text));
  show_event();
  return {};
}

Outcome WindowInput::click(const Navigation::Click& click) {
  return session_.layout.flyout.empty() ? gui_.click(session_, click) : gui_.run(session_, "panel none");
}

void WindowInput::leave() {
  gui_.pointer({-1e9, -1e9});
  session_.pointing.point_away();
}

void WindowInput::let_go() {
  give_up_drags();
  is_alone_ = false;
  is_held_ = {};
  for (const MouseButton button : {MouseButton::left, MouseButton::right, MouseButton::middle})
    gui_.button(static_cast<int>(button), false);
}

}  // namespace ryosen
