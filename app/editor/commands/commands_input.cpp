#include <cmath>

#include "app/editor/camera/camera_text.h"
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/input/input.h"
#include "app/editor/input/view/view_input.h"
#include "app/editor/preferences/keys.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/levels.h"
#include "app/editor/shown/player.h"
#include "ryosen/base/number_text.h"

namespace ryosen {

namespace {

// BUTTON X,Y [MODIFIERS]
struct ButtonEvent {
  MouseButton button;
  Pointer at;
};
std::optional<Pointer> read_pointer(Words arguments) {
  const auto pixel = arguments.empty() ? std::nullopt : parse_pixel(arguments[0]);
  if (!pixel || arguments.size() > 2) return std::nullopt;
  const auto modifiers = arguments.size() == 2 ? find_modifiers(arguments[1]) : Modifiers();
  return modifiers ? std::optional(Pointer{*pixel, *modifiers}) : std::nullopt;
}
std::optional<ButtonEvent> read_button_event(Words arguments) {
  const auto button = arguments.empty() ? std::nullopt : find_button(arguments[0]);
  const auto at = button ? read_pointer(arguments.subspan(1)) : std::nullopt;
  return at ? std::optional(ButtonEvent{*button, *at}) : std::nullopt;
}

// The button is that which is held, and says nothing new.
std::optional<Pointer> read_move(Words arguments) {
  const bool has_button = !arguments.empty() && find_button(arguments[0]);
  return read_pointer(arguments.subspan(has_button));
}

// A key that is bound to `key` presses another one; bound in a circle they would never come to an end.
class PressedKey {
 public:
  PressedKey() { ++depth; }
  PressedKey(const PressedKey&) = delete;
  PressedKey& operator=(const PressedKey&) = delete;
  ~PressedKey() { --depth; }

  bool is_too_deep() const { return depth > most; }

  static constexpr int most = 8;

 private:
  static thread_local int depth;
};
thread_local int PressedKey::depth = 0;

Outcome keys_press_each_other(std::string_view chord) {
  const std::string name(chord), most = std::to_string(PressedKey::most);
  return failed(ExitCode::refused,
                {"key " + name + ": keys press each other in a circle, or more than " + most + " in a row",
                 "key " + name + "：キー同士が循環しているか、" + most + " 回を超えて続いています"});
}

}  // namespace

Outcome run_press(Input& input, Words arguments, std::string_view) {
  const auto event = read_button_event(arguments);
  if (!event) return wrong_arguments("press");
  input.press(event->button, event->at);
  return {};
}

Outcome run_release(Input& input, Words arguments, std::string_view) {
  const auto event = read_button_event(arguments);
  if (!event) return wrong_arguments("release");
  const Outcome clicked = input.release(event->button, event->at);
  // The event came where it should: what a hand would be told is no failure of the script.
  return done_with(clicked.sentence);
}

Outcome run_move(Session& session, Words arguments, std::string_view) {
  if (const auto at = read_move(arguments)) {
    session.input().move(*at);
    return {};
  }
  const std::string sent = sent_by_move(arguments);
  return sent.empty() ? wrong_arguments("move") : session.run(sent);
}

std::string sent_by_move(Words arguments) {
  if (arguments.size() < 2 || read_move(arguments)) return {};
  std::string line = "move_vertex";
  for (const std::string_view word : arguments) line.append(" ").append(word);
  return line;
}

std::optional<Text> fault_of_move(Words arguments, const std::string&) {
  return fault_unless(read_move(arguments).has_value(), "move");
}

Outcome run_wheel(Input& input, Words arguments, std::string_view) {
  const auto steps = arguments.empty() ? std::nullopt : parse_double(arguments[0]);
  const auto at = steps ? read_pointer(arguments.subspan(1)) : std::nullopt;
  if (!at) return wrong_arguments("wheel");
  constexpr double most_steps = 100;  // about a million times as large
  if (std::abs(*steps) > most_steps)
    return usage_error("wheel: at most 100 steps at a time", "wheel：一度に回せるのは 100 段までです");
  input.wheel(*steps, *at);
  return {};
}

Outcome run_type(Input& input, Words arguments, std::string_view whole) {
  if (arguments.empty()) return wrong_arguments("type");
  return input.type(without_blanks(whole));
}

std::string sent_by_key(Words arguments) {
  const auto key = arguments.size() == 1 ? find_key(arguments[0]) : std::nullopt;
  return key ? key->command : std::string();
}

std::optional<Text> fault_of_key(Words arguments, const std::string&) {
  if (arguments.size() != 1) return wrong_arguments("key").sentence;
  // Another key may be bound by then.
  if (find_key(arguments[0]) || is_panel_key(arguments[0]) || chord_from(arguments[0]) == arguments[0])
    return std::nullopt;
  return no_such_key(arguments[0]).sentence;
}

Outcome run_key(Input& input, Words arguments, std::string_view) {
  if (arguments.size() != 1) return wrong_arguments("key");
  const PressedKey pressed;
  if (pressed.is_too_deep()) return keys_press_each_other(arguments[0]);
  return input.key(std::string(arguments[0]));
}

namespace {

Outcome leave_question(std::optional<AskedQuestion>& asked_question) {
  asked_question.reset();
  return done_with({"The question is left.", "問題を終えました。"});
}

}  // namespace

// One step out of what was begun: first a band, then the open panel and what a tab has opened, a held verdict, a
// question of the program, the tool, the selection, and last what is played, a level of detail, or a question of the
// practice.
Outcome run_cancel(Session& session, Words arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("cancel");
  if (session.view.band || session.view.armed_drag) {
    session.view.band.reset();
    session.view.armed_drag.reset();
    return {};
  }
  if (!session.layout.open_panel.empty() || !session.layout.flyout.empty()) return session.run("panel none");
  if (session.selecting.is_verdict_held()) {
    session.selecting.release_verdict();
    session.pointing.point_away();
    return {};
  }
  if (!session.selecting.asked_line.empty()) {
    session.selecting.asked_line.clear();
    return {};
  }
  if (!session.selecting.tool.empty()) return session.run("tool none");
  if (!session.shown.is_replaced() && !session.selecting.selection.empty()) return session.run("select none");
  if (session.shown.player()) return leave_playing(session.view, session.framing, session.shown);
  if (session.shown.by() == ShownBy::level) return leave_level(session.shown);
  if (asked_element(session.document(), session.layout, session.asked_question))
    return leave_question(session.asked_question);
  return session.shown.is_replaced() ? Outcome() : session.run("select none");
}

}  // namespace ryosen
