// What the rows of the command table call; everybody else goes through the table. Each takes the words behind the id, and
// all of the text behind it.
#pragma once

#include "app/editor/commands.h"
#include "app/editor/view_switches.h"

namespace ryosen {

// The line says the command in another form than its row shows.
Outcome wrong_arguments(std::string_view id);
Outcome failed(const Failure& failure);

// Files and the history: commands_document.cpp
Outcome run_new(Session& session, Words arguments, std::string_view whole);
Outcome run_open(Session& session, Words arguments, std::string_view whole);
Outcome run_save(Session& session, Words arguments, std::string_view whole);
Outcome run_undo(Session& session, Words arguments, std::string_view whole);
Outcome run_redo(Session& session, Words arguments, std::string_view whole);
Outcome run_recover(Session& session, Words arguments, std::string_view whole);
Outcome run_shot(Session& session, Words arguments, std::string_view whole);
std::optional<Text> fault_of_open(Words arguments, const std::string& line);
std::optional<Text> fault_of_recover(Words arguments, const std::string& line);
bool recover_only_tells(Words arguments);
// Algorithms: commands_algorithm.cpp
CommandRow row_of(const AlgorithmRow& algorithm);
Outcome run_repair(Session& session, Words arguments, std::string_view whole);
std::optional<Text> fault_of_repair(Words arguments, const std::string& line);
// What the pointer does: commands_pointing.cpp
Outcome run_select(Session& session, Words arguments, std::string_view whole);
std::optional<Text> fault_of_select(Words arguments, const std::string& line);
Outcome run_walk(Session& session, Words arguments, std::string_view whole);
Outcome run_tool(Session& session, Words arguments, std::string_view whole);
Outcome run_mode(Session& session, Words arguments, std::string_view whole);
Outcome run_click(Session& session, Words arguments, std::string_view whole);
// What is seen: view_switches.cpp, commands_view.cpp
CommandRow row_of(const ViewSwitch& row);
Outcome run_camera(Session& session, Words arguments, std::string_view whole);
Outcome run_view(Session& session, Words arguments, std::string_view whole);
Outcome run_frame(Session& session, Words arguments, std::string_view whole);
Outcome run_drag(Session& session, Words arguments, std::string_view whole);
Outcome run_show(Session& session, Words arguments, std::string_view whole);
// The user interface: commands_window.cpp
Outcome run_panel(Session& session, Words arguments, std::string_view whole);
Outcome run_values(Session& session, Words arguments, std::string_view whole);
Outcome run_language(Session& session, Words arguments, std::string_view whole);
Outcome run_cancel(Session& session, Words arguments, std::string_view whole);
Outcome run_key(Session& session, Words arguments, std::string_view whole);
std::string sent_by_key(Words arguments);
Outcome run_quit(Session& session, Words arguments, std::string_view whole);

}  // namespace ryosen
