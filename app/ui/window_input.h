// Mouse and keyboard in a window with panels. A press goes to what is under the pointer, the view or the panels; its
// release goes to both, so whichever has the button releases it, wherever the pointer is by then. Keys go to a field
// that has the keyboard, else they send commands.
#pragma once

#include <array>
#include <functional>

#include "app/editor/input/view/view_input.h"
#include "app/ui/gui.h"

namespace ryosen {

// The gui and the session must outlive it. Over a panel the last element stays hovered, so that its information there
// can be read and clicked.
class WindowInput : public ViewInput {
 public:
  // `lay_out` is for those who send events faster than frames come: panels see events in frames, one before and one
  // behind. A window, whose frames come by themselves, gives `catch_up`: it lays out frames until the panels have seen
  // all keys, for a key behind one that may open or close a panel, and for presses on panels.
  WindowInput(Gui& gui, Session& session, std::function<void()> lay_out = {}, std::function<void()> catch_up = {})
      : ViewInput(session), gui_(gui), lay_out_(std::move(lay_out)), catch_up_(std::move(catch_up)) {}

  void resize(Size window) { window_ = window; }

  void press(MouseButton button, const Pointer& at) override;
  Outcome release(MouseButton button, const Pointer& at) override;
  void move(const Pointer& at) override;
  void wheel(double steps, const Pointer& at) override;
  Outcome key(const std::string& chord) override;
  Outcome type(std::string_view text) override;

  // The two halves of a key. Held down it comes again and again, which not every command does.
  Outcome key_down(const std::string& chord, bool is_again = false);
  Outcome key_up(const std::string& chord);
  // The pointer has left the window. A drag goes on.
  void leave();
  // The window has lost focus and will miss releases: ends every press, without a click.
  void let_go();

 private:
  bool is_over_view(glm::dvec2 pixel) const override { return !gui_.owns_pointer(session_.layout, window_, pixel); }
  // One beside what a tab has opened closes that and does nothing else.
  Outcome click(const Navigation::Click& click) override;
  Outcome open_menu(const Navigation::Click& click) override;
  Outcome run(const std::string& line) override { return gui_.run(session_, line); }
  Outcome end_gesture() override { return gui_.keep(session_, session_.gesturing.end()); }
  Outcome give_up_gesture() override { return gui_.keep(session_, session_.gesturing.give_up()); }
  Outcome press_key(const std::string& chord, bool is_again, const InputPreset& preset);
  Outcome let_key_go(const std::string& chord, const InputPreset& preset);
  Outcome act_on(const std::string& chord, bool is_again, const InputPreset& preset);
  // The panels know where the pointer is before they see what it does.
  void show_pointer(const Pointer& at) const {
    gui_.pointer(at.pixel);
    gui_.modifiers(at.modifiers.shift, at.modifiers.ctrl);
    show_event();
  }
  void show_event() const {
    if (lay_out_) lay_out_();
  }
  // A panel sees the press where it was made, though the pointer should go on before the next frame.
  void catch_up() const {
    if (catch_up_) catch_up_();
  }

  Gui& gui_;
  std::function<void()> lay_out_, catch_up_;
  Size window_{1, 1};
  bool is_held_by_panels_ = false;  // a button was pressed there
  bool is_alone_ = false;           // lone_key is down, and nothing else has been since
  std::array<bool, 3> is_held_{};   // by button
};

}  // namespace ryosen
