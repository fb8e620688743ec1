// The handles at the middle of the selection, by a drag of which it is moved, turned or scaled: where they are in the
// view. What draws them and what asks which of them is under the pointer read the same strokes, so that the two never
// differ.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/scene/view/camera.h"

namespace ryosen {

// What the handles do, in the order of the values of the switch `gizmo`.
enum class GizmoKind { none, move, turn, scale };

// x, y, z: along or about that axis; yz, zx, xy: in that plane; free: across the view, about its line of sight, or all
// ways alike.
enum class HandleWay { x, y, z, yz, zx, xy, free };

struct HandleRow {
  GizmoKind kind;
  HandleWay way;
  std::string_view line;              // the gesture that a drag is
  std::string_view does_en, does_ja;  // in the status line
};

// From a to b, in the space of the mesh.
struct GizmoStroke {
  glm::dvec3 a, b;
  bool arrow = false;  // with a head at b
};

struct GizmoHandle {
  const HandleRow* row;
  std::vector<GizmoStroke> strokes;  // of what is drawn
  std::vector<GizmoStroke> letter;   // the name of its axis
  std::vector<glm::dvec3> plate;     // the corners of a plate, or none
};

struct Gizmo {
  glm::dvec3 middle{0};
  std::vector<GizmoHandle> handles;
};

// The handles of a kind at a place, as large in every view, by the scale of the display; without axes that point at the
// eye and plates that are seen from the side. No handles where the place is not in front of the eye.
Gizmo gizmo_at(GizmoKind kind, const Camera& camera, Size view, const glm::dvec3& middle, double scale = 1);
// The nearest handle at a pixel of the view, within some pixels; null if there is none.
const GizmoHandle* handle_at(const Gizmo& gizmo, const Camera& camera, Size view, glm::dvec2 pixel, double scale = 1);

// 0, 1 or 2 for a way along or about one axis; none for the others.
std::optional<int> axis_of(HandleWay way);
// The two axes of a plane; none for other ways.
std::optional<std::array<int, 2>> plane_of(HandleWay way);

// The letters of the axes as strokes, so that they are drawn as lines are: from a to b, from -1 to 1 each way, y up.
struct LetterStroke {
  glm::dvec2 a, b;
};
// X, Y or Z of the axes 0, 1 and 2.
const std::vector<LetterStroke>& axis_letter(int axis);

}  // namespace ryosen
