// The overlays of the view's layers: highlights, selection, hovered element and preview, handles and axes. `places`:
// where the vertices are drawn.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "render/overlay.h"
#include "render/palette.h"
#include "ryosen/algo/edge_rules.h"
#include "ryosen/geometry/box.h"
#include "ryosen/ops/preview/tool_verdicts.h"
#include "ryosen/scene/highlights/highlight_table.h"

namespace ryosen {

class Findings;
class Gesturing;
class Mesh;
class Pointing;
class Selecting;
class Session;
class Shown;
struct Layout;
struct LinkArrow;
struct Preferences;
struct SeenMesh;
struct ViewState;

// The members of a mark of a highlight with slot numbers from first to before end.
// Points have so much room, see Point. With dots the ends of edges are drawn over them, where vertices are drawn.
Overlay highlight_overlay(Findings& findings, std::span<const glm::dvec3> places, const HighlightRow& row, Mark mark,
                          std::uint32_t first, std::uint32_t end, const ViewSettings& settings, double room);
// The last of so many is marked by a ring.
inline constexpr std::size_t most_ringed = 20;
Overlay selection_overlay(const Findings& findings, const ViewState& view, const Selecting& selecting,
                          const Gesturing& gesturing, Theme theme);
// The elements of such a verdict with slot numbers from first to before end: edges as lines, vertices and the middles
// of faces as points, which have so much room.
Overlay verdicts_overlay(const Findings& findings, std::span<const glm::dvec3> places, const ToolVerdicts& verdicts,
                         ElementVerdict which, std::uint32_t first, std::uint32_t end, Theme theme, double room);
// The ways along which was measured, where all elements of it are still there.
Overlay measures_overlay(const Mesh& mesh, const Selecting& selecting, Theme theme);
// The elements of the step that is played, by their roles; nothing where the mesh is no longer the one it is about.
Overlay step_overlay(const Mesh& mesh, const ViewState& view, const Gesturing& gesturing, const Shown& shown,
                     Theme theme);
// What the open question of practice is about.
Overlay question_overlay(const Session& session, Theme theme);
// The edges that the last simplification left, each in the colour of the rule that holds it; nothing where its panel is
// not shown.
Overlay left_edges_overlay(const Findings& findings, const Layout& layout, Theme theme);
// The colour of a rule, as 0xRRGGBB.
std::uint32_t colour_of(EdgeRule rule, Theme theme);
Overlay links_overlay(std::span<const LinkArrow> arrows, Theme theme);
// Without a tool the element itself; with one, green with the ghost of the result, or red with the witnesses.
Overlay hover_overlay(const Mesh& mesh, const ViewState& view, const Selecting& selecting, const Gesturing& gesturing,
                      Theme theme);
// An element of a mesh that is compared with, under the pointer.
Overlay pointed_overlay(const SeenMesh& compared, const Element& element);
// The handles, with the one under the pointer marked; or while a gesture lasts the axis or plane that it is bound to,
// the reach of its falloff, and what it snaps to.
Overlay gizmo_overlay(const ViewState& view, const Pointing& pointing, const Gesturing& gesturing, Theme theme);
// The axes in the corner of the view; nothing where they are not shown.
Overlay axes_overlay(const ViewState& view, const Pointing& pointing, const Preferences& preferences, Theme theme);

// How much room points have that are drawn at many places, as if so many were even over a surface as large as the two
// longer sides of their bounds, in whole octaves, so that an edit seldom changes it; none where they are few (see
// Point).
double room_of_points(const Box& bounds, std::size_t count);

}  // namespace ryosen
