// The elements that views have at a pixel, and what the pointer does there. Pixels count from the upper left corner of
// the picture or window.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/input/corner_axes.h"
#include "app/editor/input/gizmo.h"
#include "app/editor/session/selecting.h"
#include "app/editor/views/mesh_view.h"
#include "ryosen/document/outcome.h"
#include "ryosen/scene/pick/picker.h"

namespace ryosen {

class Session;

class Pointing {
 public:
  Pointing(Session& session, const OpenDocument& open);

  // A further view in the picture, asked before the earlier ones where they overlap. It is removed before it goes.
  void add(View& view) { further_.push_back(&view); }
  void remove(const View& view);
  // The view at a pixel; that of the open mesh in space where there is no other.
  View& view_at(glm::dvec2 pixel);

  // Hovering. The picker is updated after every edit.
  void point_at(glm::dvec2 pixel, Modifiers modifiers = {});
  void point_away();
  // The element that is pointed at in any view, of whatever document; null for none.
  const Pointed* pointed() const;
  // A click: applies the tool to what is under the pixel, or selects it. With Shift a tool puts things exactly where
  // the pointer is.
  Outcome click(glm::dvec2 pixel, const std::string& with_tool, Modifiers modifiers = {});
  // What a menu at a pixel is about is selected, if it is not so already.
  void select_for_menu(glm::dvec2 pixel);

  // The element of the open document under a pixel; none outside its views, and none while another mesh is on trial.
  std::optional<Picked> pick(glm::dvec2 pixel, PickMode what);
  // What a click there would select: as that edits nothing, it reaches farther on the surface.
  std::optional<Picked> pick_to_select(glm::dvec2 pixel, PickMode what);
  // The element that any view draws under a pixel, for who needs its place alone.
  std::optional<Picked> pick_drawn(glm::dvec2 pixel, PickMode what);
  // Only the picked element; the others are none.
  OpTarget target_of(const Picked& picked, Modifiers modifiers) const;

  // The handles that move the selection, where the switch shows them: with Select in hand, at the middle of what is
  // selected. None while it is moved.
  std::optional<Gizmo> gizmo() const;
  // The one at a pixel; none where Shift or Alt ask for something else. And the one that the pointer is on.
  const HandleRow* handle_at(glm::dvec2 pixel, Modifiers modifiers) const;
  const HandleRow* pointed_handle() const { return pointed_handle_; }
  // The axes in the corner of the view, where a switch shows them and there is room; the end that is at a pixel, and
  // the one that the pointer is on. A click on one looks from there.
  std::optional<CornerAxes> axes_in_corner() const;
  const AxisEnd* axis_end_at(glm::dvec2 pixel) const;
  const AxisEnd* pointed_axis_end() const { return pointed_axis_end_; }

  // The pointer is on no handle and no axis: a gesture begins, or the mesh is another.
  void leave_handles() { pointed_handle_ = nullptr, pointed_axis_end_ = nullptr; }

 private:
  const Mesh& mesh() const;
  bool is_in_space(glm::dvec2 pixel) const;  // of the open mesh
  bool is_of_open_document(const View& view) const;
  bool can_pick_in(const View& view) const;
  void look_at(glm::dvec2 pixel, Modifiers modifiers);
  const LinkArrow* arrow_at(glm::dvec2 pixel, const OpInfo* info, Modifiers modifiers);
  Outcome select_along(glm::dvec2 pixel, Modifiers modifiers);
  Outcome use_tool(glm::dvec2 pixel, const Picked& picked, const std::string& tool, Modifiers modifiers);

  Session& session_;
  ViewState& view_;
  Selecting& selecting_;
  MeshView in_space_;
  std::vector<View*> further_;
  std::optional<Pointed> elsewhere_;  // what is pointed at of another document than the open one
  const HandleRow* pointed_handle_ = nullptr;
  const AxisEnd* pointed_axis_end_ = nullptr;
  struct Middle {
    std::uint64_t selection = 0;  // by its stamp
    std::uint64_t document = 0, revision = 0;
    glm::dvec3 place{0};
  };
  mutable Middle middle_;  // of the selection, as it was last asked for
};

}  // namespace ryosen
