// The table of preferences: what the window keeps from one time to the next, one row each. The dialog, the command
// `prefer` and the file of the user read it.
//
// To add one, write its row here; for a switch of the view (view_switches.h) its name there is enough.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/preferences/keys.h"
#include "app/editor/session/owners.h"
#include "ryosen/algo/parameters.h"

namespace ryosen {

class Session;

struct PreferenceRow {
  ParameterRow field;  // its id, texts, kind, range and initial value
  OnOwners<std::string(const Session&)> value;
  OnOwners<void(Session&, const ParameterValue&)> set;  // one of the field's kind and in its range
};

std::vector<PreferenceRow> preference_table();
std::optional<PreferenceRow> find_preference(std::string_view id);

// Sets a preference to a value as it is written, or to `initial`. A clause where it is no preference or no value of it;
// nothing is set then.
std::optional<Text> prefer(Session& session, std::string_view id, std::string_view value);
// What is wrong with that; nothing is set.
std::optional<Text> fault_of_preference(std::string_view id, std::string_view value);

// The user's own bindings: a chord gets this command, none where that is empty, or what its preset says.
enum class BindTo { command, preset };
void bind(Preferences& preferences, const std::string& chord, BindTo to, const std::string& command = {});
// What the key does now and would not do any more; nothing where it is free or does that already.
std::optional<KeyRow> conflict_of(const Preferences& preferences, std::string_view chord, std::string_view command);

// The command that makes it.
std::string line_of(const KeyBinding& binding);

}  // namespace ryosen
