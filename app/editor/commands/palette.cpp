#include "app/editor/commands/palette.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/document/findings.h"
#include "app/editor/preferences/keys.h"
#include "app/editor/preferences/panel_list.h"
#include "app/editor/preferences/view_switches.h"
#include "app/editor/session/asking.h"
#include "app/editor/session/operator_selection.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/asked_values.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/scene/highlights/colour_maps.h"
#include "ryosen/scene/view/named_views.h"

namespace ryosen {

namespace {

Text name_in(std::string_view en, std::string_view ja) { return {std::string(en), std::string(ja)}; }

// How well a word of what was typed fits; the lower the better.
enum Fit {
  name_itself,
  line_itself,
  begins_line,
  begins_name,
  begins_word_of_name,
  begins_word_of_help,
  inside_name,
  inside_help
};

// None where a word is missing.
std::optional<Fit> fit_of(const PaletteEntry& entry, std::string_view typed) {
  const std::string names[] = {folded(entry.line), folded(entry.name.en), folded(entry.name.ja)};
  const std::string help = folded(entry.help.en + " " + entry.help.ja), asked = folded(without_blanks(typed));
  const auto any_name = [&](auto is) { return std::any_of(std::begin(names), std::end(names), is); };
  if (!has_words(names[0] + " " + names[1] + " " + names[2] + " " + help, asked)) return std::nullopt;
  if (names[1] == asked || names[2] == asked) return name_itself;  // before a word of scripts that may be the same
  if (names[0] == asked) return line_itself;
  if (names[0].starts_with(asked)) return begins_line;
  if (any_name([&](const std::string& name) { return name.starts_with(asked); })) return begins_name;
  Fit worst = begins_name;
  for (const std::string_view word : split_words(asked)) {
    const auto begins = [&](const std::string& name) { return begins_a_word(name, word); };
    const auto has = [&](const std::string& name) { return name.find(word) != name.npos; };
    const Fit fit = any_name(begins)            ? begins_word_of_name
                    : begins_a_word(help, word) ? begins_word_of_help
                    : any_name(has)             ? inside_name
                                                : inside_help;
    worst = std::max(worst, fit);
  }
  return worst;
}

// The first clause of a sentence, as a title.
std::string title_of(std::string_view help, std::string_view ends) {
  std::string title(help.substr(0, help.find_first_of(ends)));
  while (title.ends_with(' ')) title.pop_back();
  return capitalized(std::move(title));
}

// In the words of its help where no other table names it.
Text title_of(const CommandRow& row) {
  std::size_t end = row.help_ja.size();
  for (const std::string_view mark : {"（", "：", "。"}) end = std::min(end, row.help_ja.find(mark));
  return {title_of(row.help_en, ";:("), std::string(row.help_ja.substr(0, end))};
}

// A command whose id has been typed, with a blank behind it.
std::optional<PaletteEntry> begun(std::string_view typed) {
  const std::size_t end = typed.find(' ');
  const CommandRow* const row = end == typed.npos ? nullptr : find_command_row(typed.substr(0, end));
  if (!row) return std::nullopt;
  const std::string id(row->id);
  return PaletteEntry{id, {id, id}, {help_of(*row, Language::english), help_of(*row, Language::japanese)}, row->syntax};
}

}  // namespace

std::vector<PaletteEntry> palette_entries() {
  std::vector<PaletteEntry> entries;
  std::set<std::string> lines;
  const auto add = [&](PaletteEntry entry) {
    if (lines.insert(entry.line).second) entries.push_back(std::move(entry));
  };
  for (const OpInfo& op : all_ops())
    add({std::string(op.id), name_in(op.name_en, op.name_ja), name_in(op.help_en, op.help_ja), syntax_of(op.line)});
  for (const AlgorithmRow& row : algorithm_table())
    if (!find_op(row.id))
      add({std::string(row.id), name_in(row.name_en, row.name_ja), name_in(row.help_en, row.help_ja), ""});
  for (const ViewSwitch& row : view_switches())
    for (const SwitchValue& value : row.values)
      add({std::string(row.id) + " " + std::string(value.id), name_in(value.name_en, value.name_ja),
           name_in(row.help_en, row.help_ja), ""});
  for (const NamedView& view : named_views())
    add({"view " + std::string(view.id), name_in(view.name_en, view.name_ja), {}, ""});
  for (const Selector& row : selectors()) add({select_line(row), name_in(row.name_en, row.name_ja), {}, ""});
  for (const PanelRow& row : panel_list())
    add({"panel " + std::string(row.id), name_in(row.title_en, row.title_ja), {}, ""});
  for (const ColourMap& map : colour_maps())
    add({"colours " + std::string(map.id), name_in(map.name_en, map.name_ja), name_in(map.legend_en, map.legend_ja),
         ""});
  for (const KeyRow& row : key_table()) add({row.command, name_in(row.help_en, row.help_ja), {}, ""});
  for (const OpInfo& op : all_ops())
    if (takes_numbers(op))
      add({"values " + std::string(op.id), name_in(std::string(op.name_en) + "...", std::string(op.name_ja) + "..."),
           name_in(op.help_en, op.help_ja), ""});
  for (const CommandRow* row : command_table()) {
    for (const NamedCall& call : row->named) add({std::string(call.line), name_in(call.en, call.ja), {}, ""});
    add({std::string(row->id), title_of(*row), name_in(row->help_en, row->help_ja), row->syntax});
  }
  return entries;
}

std::vector<PaletteEntry> find_in_palette(std::string_view typed) {
  std::vector<PaletteEntry> entries;
  const auto own = begun(typed);
  if (own) entries.push_back(*own);
  std::vector<std::pair<Fit, PaletteEntry>> found;
  for (PaletteEntry& entry : palette_entries()) {
    const auto fit = fit_of(entry, typed);
    if (fit && (!own || (*fit <= begins_name && entry.line != own->line))) found.emplace_back(*fit, std::move(entry));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [fit, entry] : found) entries.push_back(std::move(entry));
  return entries;
}

PaletteChoice choice_of(const Findings& findings, const Selecting& selecting, const PaletteEntry& entry) {
  using Kind = PaletteChoice::Kind;
  if (const OpInfo* const op = find_op(entry.line)) {
    if (fits_selection(findings, selecting, *op)) return {Kind::run, entry.line + " selected"};
    if (!fault_of_command(entry.line)) return {Kind::run, entry.line};
    if (is_tool(*op)) return {Kind::run, "tool " + entry.line};
    if (can_be_asked(entry.line)) return {Kind::run, "ask " + entry.line};
    return {Kind::begin, entry.line + " "};
  }
  if (const AlgorithmRow* const row = find_algorithm(entry.line))
    return {Kind::run, row->parameters.empty() ? called(*row) : "values " + entry.line};
  if (const auto row = find_command_row(entry.line); row && row->most_elements > 0)
    return {Kind::run, selecting.selection.empty() ? "ask " + entry.line : entry.line + " selected"};
  if (fault_of_command(entry.line)) return {Kind::begin, entry.line + " "};
  return {Kind::run, entry.line};
}

std::string beyond_name(const std::string& help, const std::string& name) {
  if (name.empty() || help.size() < name.size() || help.substr(1, name.size() - 1) != name.substr(1)) return help;
  std::string_view rest = std::string_view(help).substr(name.size());
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (!rest.empty() && is_letter(rest[0])) return help;  // of its first word the name is a part only
  for (const std::string_view mark : {";", ":", "：", "。"})
    if (rest.starts_with(mark)) rest.remove_prefix(mark.size());
  return std::string(without_blanks(rest));
}

}  // namespace ryosen
