// The state of a view in space: camera, place in the picture, settings, and what it shows of the mesh. The open mesh
// has one, and a mesh that is compared with another.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <set>
#include <string>

#include "app/editor/input/gizmo.h"
#include "app/editor/input/input_presets.h"
#include "app/editor/labels/drawn_links.h"
#include "ryosen/scene/highlights/map_values.h"
#include "ryosen/scene/view/camera.h"
#include "ryosen/scene/view/clip_plane.h"
#include "ryosen/scene/view/view_settings.h"

namespace ryosen {

// The map that the surface is coloured by. The range stays through edits, so that equal colours stay equal values.
struct Colouring {
  const ColourMap* map = nullptr;
  MapRange range;
  friend bool operator==(const Colouring&, const Colouring&) = default;
};

// Where the mesh is cut: the switch says across which axis, the share of its extent how far along.
struct Cut {
  ClipWay way = ClipWay::off;
  double share = 0.5;
  ClipPlane plane;
};

struct ViewState {
  Camera camera;
  Size size{1280, 720};
  glm::dvec2 origin{0};      // in the picture or window; pixels are relative to the latter
  glm::dvec2 covered_px{0};  // of its width, at its left and its right, by what a tab has opened over it
  ViewSettings settings;
  std::set<std::string> highlights;  // ids of the highlight table that are shown
  std::optional<Colouring> colouring;
  DrawnLinks links;                        // as arrows
  std::optional<Cut> cut;                  // what lies beyond its plane is neither drawn nor picked
  GizmoKind gizmo_kind = GizmoKind::none;  // of the handles that move the selection
  bool shows_verdicts = false;             // of the tool in hand, on all elements that it acts on
  bool shows_axes = false;                 // X, Y, Z in the corner
  glm::dvec2 pointer{-1e9};                // where it was last
  std::optional<DragAction> armed_drag;    // of the next drag with the left button
  std::optional<Band> band;                // that a drag draws just now

  std::optional<ClipPlane> clip_plane() const { return cut ? std::optional(cut->plane) : std::nullopt; }
};

}  // namespace ryosen
