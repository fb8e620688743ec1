// The camera of a session's view, so that it shows all.
#pragma once

#include <new>

#include "app/editor/camera/framing.h"
#include "app/editor/camera/view_state.h"

namespace ryosen {

class Session;

// Puts the camera of a session's view so that it shows all.
class Framing {
 public:
  Framing(const Session& session, ViewState& view) : session_(session), view_(view) {}

  // The parts that a tab which is open, the caption of what is played, and the axes lie over.
  Covered covered() const;
  // The strips of that alone, as shares of the view; none where they leave hardly any of it.
  CoveredShares covered_shares() const;
  // The camera in the same direction that shows all beside what lies over the view: the mesh, with the one that it is
  // compared with, or what is played, as it ends.
  Camera of_all(const Camera& from) const;
  void frame_all() { frame(of_all(view_.camera)); }
  // The same; the camera stays where there is no memory for it.
  void frame_all_if_possible() noexcept {
    try {
      frame_all();
    } catch (const std::bad_alloc&) {
    }
  }
  // Whether the camera is where frame() has put it last.
  bool is_framed() const { return framed_ == view_.camera; }
  // Takes a camera as one that shows all.
  void frame(const Camera& camera) { view_.camera = framed_ = camera; }

 private:
  const Session& session_;
  ViewState& view_;
  Camera framed_;
};

}  // namespace ryosen
