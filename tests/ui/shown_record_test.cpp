// A record of what is on the screen: for each owner of the shown mesh (the document, a step, a level of detail, a
// preview of values, a gesture) and each command: what is shown, edited and said after it, then after undo, and after
// Esc. The record is tests/data/shown/OWNER.txt; RYOSEN_UPDATE_GOLDEN=1 writes it anew.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/asked_values.h"
#include "app/editor/shown/levels.h"
#include "app/editor/shown/values_preview.h"
#include "app/editor/textbook/playing.h"
#include "ryosen/algo/algorithm_table.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

namespace fs = std::filesystem;

// The lines that call each command. Operators and algorithms that are not here are as those that are: their rows differ
// in nothing that decides what is shown.
const std::map<std::string_view, std::vector<const char*>>& lines_of_commands() {
  static const std::map<std::string_view, std::vector<const char*>> lines{
      {"poke", {"poke f1"}},
      {"delete", {"delete selected", "delete f1", "delete v99"}},
      {"split", {"split 0-1"}},
      {"collapse", {"collapse 0-1 mid"}},
      {"subdivide", {"subdivide steps=1"}},
      {"cube", {"cube size=1"}},
      {"translate", {"translate by=1,0,0 elements=selected"}},
      {"open", {"open torus.off", "open missing.obj"}},
      {"reload", {"reload"}},
      {"keep_mine", {"keep_mine"}},
      {"new", {"new"}},
      {"start", {"start"}},
      {"exercise", {"exercise triangle"}},
      {"figure", {"figure 000-3"}},
      {"save", {"save out.obj", "save out.nothing"}},
      {"save_selected", {"save_selected part.obj"}},
      {"append", {"append torus.off"}},
      {"attribute", {"attribute add face.load float", "attribute list", "attribute remove face.none"}},
      {"compare", {"compare torus.off", "compare off"}},
      {"select", {"select f2", "select all", "select none", "select"}},
      {"box", {"box 300,200 900,600"}},
      {"lasso", {"lasso 300,200 900,200 900,600"}},
      {"band", {"band box"}},
      {"gesture", {"gesture move", "gesture extrude", "gesture duplicate"}},
      {"keep", {"keep mine"}},
      {"forget", {"forget mine"}},
      {"hide", {"hide selected", "hide f3"}},
      {"isolate", {"isolate f2"}},
      {"unhide", {"unhide"}},
      {"either", {"either extrude selected | extrude_edges selected", "either select f1 | select f2"}},
      {"walk", {"walk next"}},
      {"undo", {"undo", "undo 2"}},
      {"redo", {"redo"}},
      {"repair", {"repair default", "repair fill_holes", "repair remove_isolated"}},
      {"would", {"would repair fill_holes"}},
      {"recover", {"recover list", "recover 1"}},
      {"camera", {R"(camera {"eye":[9,0,0],"target":[0,0,0],"up":[0,0,1],"fov_y_deg":35})"}},
      {"view", {"view front"}},
      {"frame", {"frame", "frame selected"}},
      {"projection", {"projection orthographic"}},
      {"orbit", {"orbit centre"}},
      {"preset", {"preset blender"}},
      {"theme", {"theme light"}},
      {"shading", {"shading smooth"}},
      {"wire", {"wire off"}},
      {"xray", {"xray on"}},
      {"dots", {"dots always"}},
      {"numbers", {"numbers vertices"}},
      {"links", {"links selection"}},
      {"file_colours", {"file_colours off"}},
      {"normals", {"normals faces"}},
      {"verdicts", {"verdicts on"}},
      {"ground", {"ground on"}},
      {"axes", {"axes on"}},
      {"clip", {"clip x"}},
      {"gizmo", {"gizmo move"}},
      {"clip_at", {"clip_at 0.4"}},
      {"show", {"show boundary on"}},
      {"colours", {"colours edge_length", "colours off"}},
      {"measure", {"measure v0 v1", "measure clear"}},
      {"steps", {"steps script triangle", "steps forward", "steps back", "steps first", "steps close"}},
      {"levels", {"levels", "levels at 3", "levels keep", "levels close"}},
      {"account", {"account", "account structure"}},
      {"self_intersections", {"self_intersections", "self_intersections off"}},
      {"tool", {"tool collapse", "tool none"}},
      {"ask", {"ask split", "ask swap", "ask"}},
      {"mode", {"mode edge"}},
      {"click", {"click 640,360", "click 640,360 poke"}},
      {"remedy", {"remedy"}},
      {"drag", {"drag 300,300 400,350"}},
      {"press", {"press left 640,360"}},
      {"move", {"move 640,360"}},
      {"release", {"release left 640,360"}},
      {"wheel", {"wheel 1 640,360"}},
      {"type", {"type a"}},
      {"key", {"key E", "key Enter", "key Ctrl+Z"}},
      {"shot", {"shot out.png"}},
      {"expect", {"expect F 6", "expect legal poke f1", "expect refused collapse 0-1"}},
      {"panel", {"panel keys", "panel steps on", "panel none"}},
      {"menu", {"menu file"}},
      {"columns", {"columns left 260"}},
      {"values", {"values mirror"}},
      {"language", {"language ja"}},
      {"prefer", {"prefer crease_angle 40"}},
      {"bind", {"bind Ctrl+7 undo"}},
      {"cancel", {"cancel"}},
      {"quit", {"quit"}}};
  return lines;
}

// An owner of the shown mesh: how a session comes to show it. All begin with a cube, one edit and a selected face.
struct Owner {
  const char* name;
  std::vector<const char*> lines;
  bool is_preview = false;
};
constexpr const char* first_lines[] = {"mode face", "poke f5", "select f0"};
const Owner owners[] = {{"document", {}},
                        {"step", {"steps script square", "steps at 3"}},
                        {"level", {"levels", "levels at 6"}},
                        {"preview", {}, true},
                        {"extrusion", {"gesture extrude"}},
                        {"copy", {"gesture duplicate"}},
                        {"move", {"gesture move"}}};

std::string short_hash(const Mesh& mesh) {
  char text[9];
  std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(mesh.hash() >> 32));
  return text;
}

std::string sizes_of(const Mesh& mesh) {
  const auto live = mesh.live();
  return std::to_string(live.vertices) + " " + std::to_string(live.edges) + " " + std::to_string(live.faces);
}

// A session that one owner shows something in, and what a person sees of it.
class Stage {
 public:
  explicit Stage(const Owner& owner) : is_preview_(owner.is_preview) {
    auto document = Document::open("cube.obj");
    session_ = std::make_unique<Session>(std::move(document).value());
    session_->place_view(session_->view.size, {0, 0});
    session_->framing.frame_all();
    session_->files = RunFiles(RunFiles::Policy::keep);
    for (const char* const line : first_lines) EXPECT_TRUE(session_->run(line).done()) << line;
    for (const char* const line : owner.lines) EXPECT_TRUE(session_->run(line).done()) << line;
    if (session_->gesturing.is_active()) {
      session_->gesturing.follow({700, 360}, {});
      session_->gesturing.follow({720, 380}, {});
    }
    show_preview();
    first_ = state();
  }

  // Runs a line. What it says; and what is shown and edited then, "=" where that is as at first.
  std::string run(const std::string& line) {
    const Outcome outcome = session_->run(line);
    static constexpr const char* kinds[] = {"done", "refused", "failed"};
    std::string said = kinds[static_cast<int>(outcome.kind)];
    if (outcome.exit_code != ExitCode::done) said += " " + std::to_string(static_cast<int>(outcome.exit_code));
    if (!outcome.sentence.en.empty()) said += " \"" + in_one_line(outcome.sentence.en) + "\"";
    if (!outcome.performed.empty()) said += " performed: " + outcome.performed;
    const std::string now = state();
    return " " + said + "\n    " + (now == first_ ? "=" : now) + "\n";
  }

  std::string state() const {
    const Session& s = *session_;
    const Document& d = s.document();
    std::string text = sizes_of(s.mesh()) + " " + short_hash(s.mesh()) + (d.is_on_trial() ? " trial" : "");
    if (s.shown.player())
      text += " step " + std::to_string(s.shown.player()->position()) + (s.shown.shows(ShownBy::step) ? " shown" : "");
    if (s.shown.levels())
      text += " level " + std::to_string(s.shown.levels()->faces()) + (s.shown.shows(ShownBy::level) ? " shown" : "");
    if (s.gesturing.is_active()) text += " gesture";
    text += " | " + std::to_string(d.position()) + "/" + std::to_string(d.history().size());
    if (!d.history().empty()) text += " " + d.history().back().command;
    text += std::string(" ") + (d.is_modified() ? "*" : "") + d.path().filename().string();
    text += " | " + std::to_string(s.selecting.selection.size()) + " selected, " +
            std::to_string(s.findings().hidden().elements().size()) + " hidden, " +
            std::to_string(s.selecting.measures.size()) + " measured";
    if (!s.layout.open_panel.empty()) text += ", panel " + s.layout.open_panel;
    if (!s.selecting.tool.empty()) text += ", tool " + s.selecting.tool;
    return text;
  }
  const std::string& first() const { return first_; }

 private:
  static std::string in_one_line(std::string text) {
    for (char& c : text)
      if (c == '\n') c = '/';
    return text;
  }
  void show_preview() {
    if (!is_preview_) return;
    const auto asked = ask_values(*find_algorithm("mirror"), session_->mesh(), session_->selecting);
    for (ValueField& field : asked->fields()) field.text = field.row.initial;
    preview_.show(*session_, asked->trial());
    EXPECT_TRUE(session_->document().is_on_trial());
  }

  bool is_preview_;
  std::unique_ptr<Session> session_;
  ValuesPreview preview_;
  std::string first_;
};

class ShownRecord : public testing::TestWithParam<Owner> {
 protected:
  ShownRecord()
      : state_home_("XDG_STATE_HOME", folder_.at("state")),
        config_home_("XDG_CONFIG_HOME", folder_.at("config")),
        before_(fs::current_path()) {
    folder_.copy(test::asset("cube.obj"), "cube.obj");
    folder_.copy(test::asset("torus.off"), "torus.off");
    fs::current_path(folder_.path());
  }
  ~ShownRecord() override { fs::current_path(before_); }

 private:
  test::TemporaryFolder folder_;
  test::ScopedVariable state_home_, config_home_;
  fs::path before_;
};

// What Esc and undo do is written where it differs from what they do at first.
std::string record_of(const Owner& owner) {
  Stage first(owner), first_escaped(owner);
  const std::string usual_escape = "  Esc:" + first_escaped.run("key Escape"),
                    usual_undo = "  undo:" + first.run("undo");
  std::string text = "first: " + first.first() + "\n" + usual_escape + usual_undo;
  for (const auto& [id, lines] : lines_of_commands()) {
    for (const char* const line : lines) {
      Stage stage(owner), escaped(owner);
      text += "\n" + std::string(line) + ":" + stage.run(line);
      escaped.run(line);
      const std::string escape = "  Esc:" + escaped.run("key Escape"), undo = "  undo:" + stage.run("undo");
      if (escape != usual_escape) text += escape;
      if (undo != usual_undo) text += undo;
      fs::remove("out.obj");
      fs::remove("part.obj");
    }
  }
  return text;
}

// The same of a frontend without a view, `ryosen edit`: what it says of the line and of the mesh at the end.
std::string record_without_view(const Owner& owner) {
  std::string text;
  const std::string of_the_line = "{\"line\":" + std::to_string(std::size(first_lines) + owner.lines.size() + 1) + ",";
  for (const auto& [id, lines] : lines_of_commands()) {
    for (const char* const line : lines) {
      std::string script;
      for (const char* const first : first_lines) script += std::string(first) + "\n";
      for (const char* const first : owner.lines) script += std::string(first) + "\n";
      std::ofstream("lines.ryosen", std::ios::binary) << script << line << "\n";
      const test::ProgramRun run = test::run_here({"edit", "cube.obj", "--script", "lines.ryosen", "--json"});
      text += std::string(line) + ": exit " + std::to_string(run.exit_code) + "\n";
      std::istringstream said(run.out + run.err);
      for (std::string each; std::getline(said, each);)
        if (!each.starts_with("{\"line\"") || each.starts_with(of_the_line)) text += "    " + each + "\n";
      fs::remove("out.obj");
      fs::remove("part.obj");
    }
  }
  return text;
}

void compare_with_record(const std::string& name, const std::string& now) {
  const fs::path file = fs::path(RYOSEN_SOURCE_DIR) / "tests/data/shown" / (name + ".txt");
  if (std::getenv("RYOSEN_UPDATE_GOLDEN")) {
    std::ofstream(file, std::ios::binary) << now;
    GTEST_SKIP() << file << " was written";
  }
  std::istringstream was(test::read_file(file)), is(now);
  std::string expected, found, command;
  for (int line = 1; std::getline(was, expected); ++line) {
    ASSERT_TRUE(std::getline(is, found)) << "the record has more lines, from " << line;
    if (!expected.starts_with(' ')) command = expected;
    ASSERT_EQ(found, expected) << file << ":" << line << ", of " << command;
  }
  EXPECT_FALSE(std::getline(is, found)) << "the record lacks " << found;
}

TEST_P(ShownRecord, is_as_it_was) { compare_with_record(GetParam().name, record_of(GetParam())); }

TEST_P(ShownRecord, is_as_it_was_without_a_view) {
  if (GetParam().is_preview) GTEST_SKIP() << "values are shown beforehand by a panel alone";
  compare_with_record(std::string("script_") + GetParam().name, record_without_view(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Owners, ShownRecord, testing::ValuesIn(owners),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(shown_record, has_a_line_of_every_command_of_the_editor) {
  const auto& lines = lines_of_commands();
  for (const CommandRow* row : command_table()) {
    if (find_op(row->id) || find_algorithm(row->id)) continue;
    EXPECT_TRUE(lines.contains(row->id)) << row->id;
  }
}

}  // namespace
}  // namespace ryosen
