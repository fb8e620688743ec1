// Functions that the rows of the command table call; everybody else goes through the table. Each takes the owners
// that it works on (the session where it runs lines or puts another document in its place), the words behind the id,
// and all of the text behind it.
#pragma once

#include <functional>
#include <vector>

#include "app/editor/commands/commands.h"
#include "app/editor/preferences/view_switches.h"

namespace ryosen {

class Document;

// The line says the command in another form than its row shows.
Outcome wrong_arguments(std::string_view id);
// Says the form where a line does not have it; else nothing.
std::optional<Text> fault_unless(bool has_form, std::string_view id);
// The fault of a command that takes one word at least.
std::function<std::optional<Text>(Words arguments, const std::string& line)> takes_words(std::string_view id);
// [N]: a number from 1, which is 1 where it is left out; none for anything else.
std::optional<std::uint32_t> count_of(Words arguments);

// On the session, or on the owners in it that the command works on.
template <class... Owners>
using RunOn = Outcome(Owners&..., Words arguments, std::string_view whole);
using RunCommand = RunOn<Session>;
using FaultOfCommand = std::optional<Text>(Words arguments, const std::string& line);

// Operators, and commands of commands: commands_operator.cpp
CommandRow row_of(const OpInfo& op, std::string_view called);
RunCommand run_either;
FaultOfCommand fault_of_either;
// Files and the history: commands_document.cpp
RunCommand run_start, run_new, run_open, run_reload, run_keep_mine, run_save, run_recover;
RunOn<Document, Framing, Selecting, RunFiles> run_append;
RunOn<Document, const Selecting, const Frontend, RunFiles> run_save_selected;
RunOn<Document> run_undo, run_redo;
RunOn<Frontend, RunFiles> run_shot;
FaultOfCommand fault_of_recover;
bool recover_only_tells(Words arguments);
// Attributes: commands_attribute.cpp
RunOn<Document, const Selecting> run_attribute;
FaultOfCommand fault_of_attribute;
bool attribute_only_tells(Words arguments);
std::string attribute_syntax();
// Algorithms: commands_algorithm.cpp
CommandRow row_of(const AlgorithmRow& algorithm);
RunCommand run_repair;
RunOn<const Document, const Frontend> run_would;
FaultOfCommand fault_of_repair, fault_of_would;
// What the pointer does: commands_pointing.cpp
RunCommand run_ask, run_remedy;
RunOn<Findings, ViewState, Framing, Selecting> run_walk;
RunOn<Selecting, Pointing> run_tool, run_mode;
RunOn<const Selecting, Pointing> run_click;
FaultOfCommand fault_of_ask, fault_of_remedy;
// Another mesh beside this one: commands_document.cpp
RunCommand run_compare;
// Selecting: commands_selecting.cpp
RunCommand run_select;
RunOn<Selecting> run_keep, run_forget;
enum class SelectHow { anew, add, toggle };
// Adds what is not there yet; where wanted takes out what is, or what was there before.
void put_into_selection(Elements& selection, std::span<const Element> elements, SelectHow how);
FaultOfCommand fault_of_select, fault_of_keep;
std::string select_syntax();
// Moving the selection by hand: commands_view.cpp
RunOn<Gesturing> run_gesture;
// Those named; fails at the first that is not there. Of a range those that are. And what is wrong with the names on any
// mesh.
Outcome find_named(Document& document, std::string_view command, Words names, Elements& found);
std::optional<Text> fault_of_names(std::string_view command, Words names);
// Hiding: commands_selecting.cpp
RunOn<Document, Findings, Selecting> run_hide, run_isolate;
RunOn<Selecting> run_unhide;
FaultOfCommand fault_of_hide;
// Colouring and measuring: commands_measuring.cpp
RunOn<Findings, ViewState, Layout> run_colours;
RunOn<Document, Selecting, Layout> run_measure;
FaultOfCommand fault_of_colours, fault_of_measure;
std::string colours_syntax();
// Levels of detail and what holds edges: commands_simplifying.cpp
RunCommand run_levels, run_account;
FaultOfCommand fault_of_levels, fault_of_account;
std::string levels_syntax(), account_syntax();
bool levels_take_long(Words arguments);
// Searching on request: commands_measuring.cpp
RunOn<Findings, const Frontend> run_self_intersections;
FaultOfCommand fault_of_self_intersections;
// In a region of the picture: commands_pointing.cpp
RunCommand run_box, run_lasso;
RunOn<ViewState> run_band;
// Events of mouse and keyboard: commands_input.cpp
RunCommand run_move;
RunOn<Input> run_press, run_release, run_wheel, run_type, run_key;
FaultOfCommand fault_of_move, fault_of_key;
std::string sent_by_move(Words arguments), sent_by_key(Words arguments);
// The view: commands_view.cpp
CommandRow row_of(const ViewSwitch& row);
RunCommand run_drag;
RunOn<Findings, ViewState, Framing, const Selecting> run_frame;
RunOn<ViewState, const Framing> run_view;
RunOn<ViewState> run_camera, run_show;
// Where the mesh is cut: commands_view.cpp
RunOn<const Mesh, ViewState> run_clip_at;
FaultOfCommand fault_of_clip_at;
// The user interface: commands_window.cpp
std::string panel_syntax();
std::string preference_ids(), prefer_syntax();
RunCommand run_prefer;
RunOn<Preferences> run_bind;
FaultOfCommand fault_of_bind;
RunCommand run_cancel;
RunOn<Layout> run_panel, run_menu, run_columns, run_values;
RunOn<Preferences> run_language;
RunOn<Frontend> run_quit;

// Whether the file is a large one.
bool opening_takes_long(Words arguments);
// Of a file that could not be read, or whose reading was given up.
Outcome not_read(const Failure& failure, const std::string& name);

// The rows of commands that no other table has: those before the switches of the view, and those behind them.
const std::vector<CommandRow>& first_command_rows();
const std::vector<CommandRow>& last_command_rows();

}  // namespace ryosen
