#include "app/ui/panels.h"

#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/input/pick_modes.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "ryosen/algo/repair/report.h"

namespace ryosen {

#define RYOSEN_PANEL(id, place, menu, opened_by, at_first, reads, en, ja, help_en, help_ja, ...) \
  std::unique_ptr<Panel> make_##id##_panel();
#include "app/editor/preferences/panels.def"
#undef RYOSEN_PANEL

std::vector<std::unique_ptr<Panel>> make_panels() {
  std::vector<std::unique_ptr<Panel>> made;
#define RYOSEN_PANEL(id, place, menu, opened_by, at_first, reads, en, ja, help_en, help_ja, ...) \
  made.push_back(make_##id##_panel());
#include "app/editor/preferences/panels.def"
#undef RYOSEN_PANEL
  return made;
}

namespace {

class PanelOfFunction : public Panel {
 public:
  PanelOfFunction(void (*function)(PanelContext&), ImVec2 size, float lines)
      : draw_(function), size_(size), lines_(lines) {}
  void draw(PanelContext& context) override { draw_(context); }
  ImVec2 size() const override { return size_; }
  float lines() const override { return lines_; }

 private:
  void (*draw_)(PanelContext&);
  ImVec2 size_;
  float lines_;
};

}  // namespace

std::unique_ptr<Panel> panel_of(void (*draw)(PanelContext& context), ImVec2 size) {
  return std::make_unique<PanelOfFunction>(draw, size, 0.f);
}

std::unique_ptr<Panel> panel_of_lines(void (*draw)(PanelContext& context), float lines) {
  return std::make_unique<PanelOfFunction>(draw, ImVec2(), lines);
}

namespace {

// Of a refusal that begins with its line, the reasons alone; else nothing.
Text without_line(const Outcome& outcome, const Mesh& mesh) {
  Text told = join(describe_first(mesh, outcome.reasons));
  return outcome.sentence.en.ends_with(told.en) ? told : Text();
}

// In fewer and fewer words what the last repair changed and left, if that is what was said.
void add_shorter_report(std::vector<Text>& shorter, const Findings& findings, const Text& name, const Text& said) {
  const RepairReport* const report = findings.last_repair();
  if (!report || (said.en != report->text.en && said.en != told(*report, findings.mesh()).en)) return;
  shorter.push_back(name + in_short(*report));
  shorter.push_back(name + in_numbers(*report));
  shorter.push_back(in_numbers(*report));
}

}  // namespace

Outcome PanelContext::keep(Outcome outcome) {
  state.unsettle();
  state.last.kind = outcome.kind;
  state.last.sentence = outcome.sentence;
  if (outcome.done() && !outcome.performed.empty())
    state.last.sentence = {outcome.performed + ": " + ryosen::text(UiText::done, Language::english),
                           outcome.performed + "：" + ryosen::text(UiText::done, Language::japanese)};
  state.last.shorter.clear();
  if (outcome.done() && !outcome.performed.empty() && !outcome.sentence.en.empty()) {
    state.last.sentence = {outcome.performed + ": " + outcome.sentence.en,
                           outcome.performed + "：" + outcome.sentence.ja};
    const Text name = name_of_line(outcome.performed) + Text{": ", "："};
    state.last.shorter = {name + outcome.sentence};
    add_shorter_report(state.last.shorter, session.findings(), name, outcome.sentence);
  }
  if (outcome.kind == Outcome::Kind::refused)
    if (Text reasons = without_line(outcome, session.mesh()); !reasons.en.empty())
      state.last.shorter = {std::move(reasons)};
  return outcome;
}

namespace {

// How many frames a command waits for behind the one that sends it; none where it is carried out at once, as are lines
// that are wrong: they fail where they were written.
std::optional<int> frames_to_wait(const Command& command) {
  const auto call = call_of_command(command);
  if (!call || !(call->is_long || call->row->sees_window)) return std::nullopt;
  if (const std::string* const line = command.written(); line && fault_of_command(*line)) return std::nullopt;
  // The panel closes in the next frame; the one behind that is without it, and drawn when a third is laid out.
  return call->row->sees_window ? 3 : 0;
}

// Whether edits that are not saved would go with what the line replaces.
bool loses_edits(const Document& document, const std::string& line) {
  if (!document.is_modified()) return false;
  const auto call = call_of(line);
  return call && call->effect == Effect::replaces && !fault_of_command(line);
}

// Whether the line saves to a file that has no name yet.
bool lacks_file(const Document& document, const std::string& line) {
  const auto call = call_of(line);
  return call && call->effect == Effect::writes && file_of(*call).empty() && document.path().empty();
}

// Several lines, the first of which begins anew: the program makes what it shows. At once, so that all that there is
// behind them counts as made; none of them takes long.
void show_made(PanelContext& context, const std::string& lines) {
  for (const ScriptLine& line : split_script(lines))
    if (!context.keep(context.session.run(line.text)).done()) return;
  context.document().mark_generated();
  if (context.session.frontend.autosave) context.session.frontend.autosave->note_document(context.document());
}

}  // namespace

Document& PanelContext::document() const { return session.document(); }
const Mesh& PanelContext::mesh() const { return session.mesh(); }
Findings& PanelContext::findings() const { return session.findings(); }

Language PanelContext::language() const { return session.preferences.language; }

Outcome PanelContext::run(const Command& command, const std::string& panel_id) {
  const std::string* const line = command.written();
  if (line && lacks_file(session.document(), *line)) return open(PanelOpener::unnamed_save);
  if (!line || !loses_edits(session.document(), *line)) return run_from(command, panel_id);
  leave({false, {}, *line, panel_id});
  return {};
}

Outcome PanelContext::run_from(const Command& command, const std::string& panel_id) {
  std::string own = panel_id;  // it may be session.layout.open_panel itself
  if (!own.empty()) session.layout.open_panel.clear();
  if (const auto frames = state.is_laying_out ? frames_to_wait(command) : std::nullopt) {
    state.waiting.push_back({command, *frames, std::move(own)});
    return {};
  }
  Outcome outcome = keep(session.run(command));
  const bool asks_again = !own.empty() && !outcome.done() && outcome.exit_code != ExitCode::cancelled;
  if (asks_again && session.layout.open_panel.empty()) session.layout.open_panel = own;
  return outcome;
}

Outcome PanelContext::click(const Navigation::Click& click) {
  Outcome outcome = session.pointing.click(click.pixel, session.selecting.tool, click.modifiers);
  // Of the mesh something is there, but nothing that can be selected now.
  const PickMode pointed = session.selecting.pointed_sort(click.modifiers);
  const bool misses = outcome.done() && session.selecting.tool.empty() && session.selecting.selection.empty() &&
                      outcome.performed.empty() && outcome.sentence.en.empty() && pointed != PickMode::face;
  if (misses && session.pointing.pick(click.pixel, PickMode::face)) {
    const PickModeRow& sort = pick_modes[static_cast<std::size_t>(pointed)];
    Outcome told;
    told.sentence = Text{std::string(sort.point_en), std::string(sort.point_ja)} +
                    Text{" 1 to 4 choose what a click selects: vertices, edges, faces, halfedges.",
                         "1〜4 で選ぶもの（頂点、稜線、面、半稜線）を切り替えます。"};
    keep(std::move(told));
    return outcome;
  }
  return keep(std::move(outcome));
}

Outcome PanelContext::open(PanelOpener opener) { return run("panel " + std::string(panel_opened_by(opener).id)); }

bool PendingLeave::reads_again() const {
  const auto call = call_of(command);
  return call && call->row->reads_again;
}

void PanelContext::begin_command(std::string line) {
  state.begun_command = std::move(line);
  open(PanelOpener::begun_line);
}

void PanelContext::leave(PendingLeave where) {
  if (session.document().is_modified()) {
    state.pending = std::move(where);
    open(PanelOpener::loss);
    return;
  }
  go(std::move(where));
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): it may be the pending one itself.
void PanelContext::go(PendingLeave where) {
  state.pending.reset();
  state.unsettle();
  session.layout.open_panel.clear();
  if (where.quits)
    state.wants_quit = true;
  else if (!where.command.empty() && !call_of(where.command))
    show_made(*this, where.command);
  else if (!where.command.empty())
    run_from(where.command, where.asks_again);
  else
    run_from(where.opens.empty() ? "new" : "open " + file_argument(where.opens.string()), {});
}

}  // namespace ryosen
