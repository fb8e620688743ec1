// What the mouse and the keys do, in the manner of several programs: a table of presets, each with its drags and with
// the keys that it has otherwise than the first.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/input/input.h"
#include "ryosen/base/message.h"

namespace ryosen {

// What a drag does: with the camera, or selecting what lies in the box or the loop that it draws.
enum class DragAction { orbit, pan, zoom, box, lasso };

constexpr bool selects(DragAction action) { return action == DragAction::box || action == DragAction::lasso; }

// The centre that an orbiting drag turns about: the point of the mesh that was pressed, or the target of the camera.
enum class OrbitAbout { point, centre };

// The outline that a selecting drag has drawn so far: a box from its first to its last corner, or a lasso.
struct Band {
  DragAction action = DragAction::box;
  std::vector<glm::dvec2> path;  // pixels; not empty
};

struct DragRow {
  MouseButton button;
  bool shift, ctrl;
  DragAction action;
};

// What a click with Select in hand selects: the element, or the loop or ring of the edge that is nearest.
enum class ClickSelects { element, loop, ring };

struct KeyChange {
  std::string_view chord, command, help_en, help_ja;
};

// The command that the user bound to a key in place of its preset; an empty command takes the key away.
struct KeyBinding {
  std::string chord, command;
  bool operator==(const KeyBinding&) const = default;
};

struct InputPreset {
  std::string_view id, name_en, name_ja;
  std::span<const DragRow> drags;
  std::span<const KeyChange> keys;
};

// The first is Ryosen's own, which scripts use.
std::span<const InputPreset> input_presets();
// Alt makes no other gesture: with one that selects it goes through the surface. With modifiers that no row has it is
// that of the button alone.
DragAction drag_action_of(const InputPreset& preset, MouseButton button, Modifiers modifiers);

// Shift adds to the selection what any of them finds.
ClickSelects click_selects(Modifiers modifiers);

// What the gesture does, in a few words.
Text help_of(DragAction action);

// What is done with the mouse, and what that does.
struct MouseRow {
  Text input, does;
};

// A drag as it is called: "Shift+left drag", to stand within a sentence.
Text name_of(const DragRow& drag);
// All that the mouse does in the preset: its drags, then the clicks and the wheel, which are the same in all.
std::vector<MouseRow> mouse_table(const InputPreset& preset);

}  // namespace ryosen
