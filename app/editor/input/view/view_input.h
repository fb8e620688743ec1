// What mouse and keyboard do to the view: they navigate, hover, click with the tool in hand, and send commands.
#pragma once

#include "app/editor/input/gizmo.h"
#include "app/editor/input/input.h"
#include "app/editor/input/view/navigation.h"
#include "app/editor/session/session.h"

namespace ryosen {

// By itself: for sessions without panels. The session must outlive it.
class ViewInput : public Input {
 public:
  explicit ViewInput(Session& session) : session_(session) {}

  void press(MouseButton button, const Pointer& at) override;
  Outcome release(MouseButton button, const Pointer& at) override;
  void move(const Pointer& at) override;
  void wheel(double steps, const Pointer& at) override;
  Outcome key(const std::string& chord) override;
  Outcome type(std::string_view text) override;

  // Hovers what is under the pixel, if it is one of the view.
  void point(const Pointer& at);
  // Ends every press, without a click; what a drag of a handle has moved is where it was.
  void give_up_drags();
  bool is_dragging() const { return navigation_.is_dragging(); }

 protected:
  // A click with the right button: by itself it only selects what a menu would be about.
  virtual Outcome open_menu(const Navigation::Click& click);
  virtual Outcome run(const std::string& line) { return session_.run(line); }
  virtual Outcome end_gesture() { return session_.gesturing.end(); }
  virtual Outcome give_up_gesture() { return session_.gesturing.give_up(); }

  Session& session_;
  Navigation navigation_;

 private:
  // Those of a frontend with panels take more than this.
  virtual bool is_over_view(glm::dvec2) const { return true; }
  virtual Outcome click(const Navigation::Click& click);
  // The line that selects by the band that a drag has drawn; through the surface with Alt, down at its begin or its
  // end.
  std::string line_of_band(Modifiers at_end) const;

  // The left button holds a handle of the gizmo. The gesture begins when the pointer has moved farther than for a
  // click.
  struct HeldHandle {
    const HandleRow* row;
    glm::dvec2 start;
    Modifiers modifiers;
    bool has_begun = false;
  };
  void drag_handle(const Pointer& at);
  Outcome let_go_of_handle(const Pointer& at);
  // What lies under the handle is clicked, where no selection of several is lost by that.
  bool clicks_through(const HeldHandle& held);
  Outcome end_click(const std::optional<Navigation::Click>& click);

  std::optional<HeldHandle> held_handle_;

  struct EndedGesture {
    MouseButton button;
    Outcome outcome;
  };
  std::optional<EndedGesture> gesture_ended_;  // by the press of a button that is still held
  Modifiers band_modifiers_;                   // of its press, beyond those that ask for the gesture
};

// The failures of a key that is bound to nothing, of one that only panels take, and of text that no field takes.
Outcome no_such_key(std::string_view chord);
Outcome no_panel_for_key(std::string_view chord);
Outcome no_field_to_type();

}  // namespace ryosen
