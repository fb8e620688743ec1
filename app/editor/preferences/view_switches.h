// The switches of the view: what is one of a few values at a time, and is neither a highlight nor a panel.
//
// To add one, write its row, and for what is drawn otherwise a field of ViewSettings (scene/view/view_settings.h),
// which shaders read by its name. Commands, their help, the View menu, keys, the command window and the flags of `shot`
// read the table.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/session/owners.h"

namespace ryosen {

class Session;

struct SwitchValue {
  std::string_view id;
  std::string_view name_en, name_ja;     // in the menu
  std::uint64_t bytes_per_triangle = 0;  // that a picture takes with it, more than without
};

struct ViewSwitch {
  std::string_view id;                // of the command that sets it
  std::string_view help_en, help_ja;  // of that command
  std::vector<SwitchValue> values;    // it begins with the first
  // The number of the value that it has, and how it gets one.
  OnOwners<std::size_t(const Session&)> value;
  OnOwners<void(Session&, std::size_t value)> set;
  // The key that goes on to the next value; empty where there is none. The command says that with the word `toggle`.
  std::string_view chord = "", key_en = "", key_ja = "";
  // The help of its flag --ID of `shot`; empty where there is none.
  std::string_view flag_en = "", flag_ja = "";
  // Of the menu of its own that its values stand in; empty: in the View menu itself.
  std::string_view menu_en = "", menu_ja = "";

  // Its name among the preferences, which the window keeps; empty where it begins anew each time.
  std::string_view preference_en = "", preference_ja = "";

  // The number of the value that a window begins with, and that its preference has at first.
  std::size_t first_in_window = 0;

  bool toggles() const { return !chord.empty(); }
  bool has_flag() const { return !flag_en.empty(); }
};

// In the order of the menu. Valid until a row comes or goes.
std::span<const ViewSwitch> view_switches();
const ViewSwitch* find_view_switch(std::string_view id);
// "dark|light"
std::string ids_of(std::span<const SwitchValue> values);
std::optional<std::size_t> find_value(const ViewSwitch& row, std::string_view id);
// Gives each the value that a window begins with.
void begin_as_window(Session& session);
// The line of the key.
std::string toggle_line(const ViewSwitch& row);
// "--theme"
std::string flag_of(const ViewSwitch& row);

// A further row at the end for its life: for tests, and for programs that embed the editor. The last one made ends
// first. Not while anything else reads the table.
class ScopedViewSwitch {
 public:
  explicit ScopedViewSwitch(ViewSwitch row);
  ~ScopedViewSwitch();
  ScopedViewSwitch(const ScopedViewSwitch&) = delete;
  ScopedViewSwitch& operator=(const ScopedViewSwitch&) = delete;
};

}  // namespace ryosen
