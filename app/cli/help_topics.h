// Additional help topics of commands, generated from the tables of core and editor.
#pragma once

#include <string>
#include <string_view>

#include "app/cli/console.h"
#include "app/cli/contract/shape.h"
#include "ryosen/algo/algorithm.h"
#include "ryosen/base/message.h"

namespace ryosen::cli {

inline std::string_view choose(Language language, std::string_view en, std::string_view ja) {
  return language == Language::japanese ? ja : en;
}

// The ids of a list with what they mean, below a title that ends its line.
std::string ids_below(const Text& title, Ids ids, Language language);
// The kinds of problems that `check` knows.
std::string problem_kinds_topic(Language language);
// The highlights that `shot` can show, then the commands of scripts.
std::string shot_topic(Language language);
// The commands of scripts: operators, then those of the editor.
std::string script_commands_topic(Language language);
// The repairs, which of them run by default, and what each solves.
std::string repairs_topic(Language language);
// The algorithm's line in a script, and what it solves.
std::string algorithm_topic(const AlgorithmRow& row, Language language);
// The operators alone.
std::string operators_topic(Language language);
// Where edits are stored for crash recovery, and how to restore them.
std::string recovery_topic(Language language);
// What the mesh can be coloured and measured by.
std::string maps_topic(Language language);
// From here on in textbook/help_topics.cpp.
// The forms and the ways to pair halfedges.
std::string forms_topic(Language language);
// What can be played step by step.
std::string steps_topic(Language language);
// Kinds of questions of `practice`, and what answers them.
std::string practice_topic(Language language);
// Each place of the texts and where it is shown, in lines of three parts.
void show_text_places(const Console& console);

}  // namespace ryosen::cli
