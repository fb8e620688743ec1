#include "app/editor/commands.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "app/editor/camera_text.h"
#include "app/editor/expect.h"
#include "app/editor/keys.h"
#include "app/editor/script.h"

namespace ryosen {

Outcome usage_error(std::string en, std::string ja) {
  Outcome outcome;
  outcome.kind = Outcome::Kind::failed;
  outcome.exit_code = ExitCode::usage;
  outcome.sentence = {std::move(en), std::move(ja)};
  return outcome;
}

namespace {

using Arguments = std::span<const std::string_view>;

Outcome wrong_arguments(std::string_view id) {
  const CommandRow* row = find_command(id);
  const std::string form = std::string(id) + " " + std::string(row->syntax);
  return usage_error("the command reads: " + form, "書式：" + form);
}

Outcome failed(const Failure& failure) {
  Outcome outcome;
  outcome.kind = Outcome::Kind::failed;
  outcome.exit_code = failure.exit_code;
  outcome.sentence = failure.message.text;
  return outcome;
}

std::optional<std::uint32_t> count_of(Arguments arguments) {
  if (arguments.empty()) return 1;
  std::uint32_t n = 0;
  const auto [end, error] = std::from_chars(arguments[0].data(), arguments[0].data() + arguments[0].size(), n);
  if (error != std::errc() || end != arguments[0].data() + arguments[0].size() || n == 0) return std::nullopt;
  return n;
}

// Goes N entries through the history, or nowhere when there are not so many.
Outcome step_history(Session& session, Arguments arguments, std::string_view id, bool back) {
  const auto n = count_of(arguments);
  if (!n || arguments.size() > 1) return wrong_arguments(id);
  Document& document = session.document();
  const std::size_t possible = back ? document.position() : document.history().size() - document.position();
  if (*n <= possible) {
    document.go_to(back ? document.position() - *n : document.position() + *n);
    return {};
  }
  Outcome outcome;
  outcome.kind = Outcome::Kind::failed;
  outcome.exit_code = ExitCode::refused;
  const std::string wanted = std::to_string(*n), there = std::to_string(possible), verb(id);
  outcome.sentence = possible == 0 ? Text{"there is nothing to " + verb, verb + " できる操作がありません"}
                                   : Text{"there are only " + there + " edits to " + verb + ", not " + wanted,
                                          verb + " できる操作は " + there + " 件だけです（" + wanted + " 件の指定）"};
  return outcome;
}

Outcome run_undo(Session& s, Arguments a, std::string_view) { return step_history(s, a, "undo", true); }
Outcome run_redo(Session& s, Arguments a, std::string_view) { return step_history(s, a, "redo", false); }

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  text = text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

Outcome run_open(Session& session, Arguments arguments, std::string_view whole) {
  if (arguments.empty()) return wrong_arguments("open");
  auto document = Document::open(std::filesystem::path(trimmed(whole)));
  if (!document) return failed(document.failure());
  session.set_document(std::move(document).value());
  return {};
}

Outcome run_save(Session& session, Arguments, std::string_view whole) {
  Document& document = session.document();
  const std::filesystem::path named(trimmed(whole));
  const std::filesystem::path target = named.empty() ? document.path() : named;
  if (target.empty()) return usage_error("save needs a file name here", "保存先のファイル名を指定してください");
  const Status status = document.save(target);
  return status ? Outcome() : failed(status.failure());
}

std::optional<Element> element_named(const Mesh& mesh, std::string_view name, Text& sentence) {
  if (name.starts_with('f')) {
    const Named<Face> face = find_face(mesh, name);
    sentence = face.sentence;
    return face.ok() ? std::optional<Element>(face.element) : std::nullopt;
  }
  if (name.starts_with('v')) {
    const Named<Vertex> vertex = find_vertex(mesh, name);
    sentence = vertex.sentence;
    return vertex.ok() ? std::optional<Element>(vertex.element) : std::nullopt;
  }
  const Named<Halfedge> edge_half = find_edge(mesh, name);
  sentence = edge_half.sentence;
  if (!edge_half.ok()) return std::nullopt;
  return name.starts_with('h') ? Element(edge_half.element) : Element(edge(edge_half.element));
}

Outcome run_select(Session& session, Arguments arguments, std::string_view) {
  std::vector<Element> selection;
  if (arguments.size() != 1 || arguments[0] != "none") {
    for (std::string_view name : arguments) {
      Text sentence;
      const auto element = element_named(session.mesh(), name, sentence);
      if (!element) return usage_error("select: " + sentence.en, "select：" + sentence.ja);
      selection.push_back(*element);
    }
  }
  session.selection = std::move(selection);
  return {};
}

// An operator that works on what the pointer is on.
const OpInfo* find_tool(std::string_view id) {
  const OpInfo* op = find_op(id);
  return op && op->target != OpTargetKind::none ? op : nullptr;
}

Outcome not_a_tool(std::string_view id) {
  if (!find_op(id)) return unknown_command(id);
  const std::string name(id);
  return usage_error(name + " works on the whole mesh; say it as a command",
                     name + " はメッシュ全体に働くので、コマンドとして実行してください");
}

Outcome run_tool(Session& session, Arguments arguments, std::string_view) {
  if (arguments.size() != 1) return wrong_arguments("tool");
  if (arguments[0] != "none" && !find_tool(arguments[0])) return not_a_tool(arguments[0]);
  session.tool = arguments[0] == "none" ? "" : std::string(arguments[0]);
  if (session.hover()) session.point_at(session.hover()->pixel);
  return {};
}

Outcome run_mode(Session& session, Arguments arguments, std::string_view) {
  constexpr std::array<std::pair<std::string_view, PickMode>, 4> modes{{{"vertex", PickMode::vertex},
                                                                        {"edge", PickMode::edge},
                                                                        {"face", PickMode::face},
                                                                        {"halfedge", PickMode::halfedge}}};
  for (const auto& [name, mode] : modes) {
    if (arguments.size() != 1 || arguments[0] != name) continue;
    session.mode = mode;
    if (session.hover()) session.point_at(session.hover()->pixel);
    return {};
  }
  return wrong_arguments("mode");
}

Outcome run_show(Session& session, Arguments arguments, std::string_view) {
  if (arguments.empty() || arguments.size() > 2) return wrong_arguments("show");
  const bool on = arguments.size() == 1 || arguments[1] == "on";
  if (!on && arguments[1] != "off") return wrong_arguments("show");
  std::vector<std::string> known;
  for (const HighlightRow& row : highlight_table()) {
    known.emplace_back(row.id);
    if (arguments[0] != row.id && arguments[0] != "all") continue;
    if (on)
      session.shown.insert(known.back());
    else
      session.shown.erase(known.back());
  }
  if (arguments[0] == "all" || std::find(known.begin(), known.end(), arguments[0]) != known.end()) return {};
  const std::string wrong(arguments[0]), close = closest_word(wrong, known);
  return usage_error("there is no highlight '" + wrong + "'" + (close.empty() ? "" : "; did you mean " + close + "?"),
                     "表示項目「" + wrong + "」はありません" + (close.empty() ? "" : "。" + close + " ですか？"));
}

Outcome run_view(Session& session, Arguments arguments, std::string_view) {
  const auto view = arguments.size() == 1 ? named_view_of(arguments[0]) : std::nullopt;
  if (!view) return wrong_arguments("view");
  session.camera =
      named_view(*view, session.places_to_frame(), static_cast<double>(session.view.width) / session.view.height);
  return {};
}

Outcome run_camera(Session& session, Arguments, std::string_view whole) {
  Text error;
  const auto camera = camera_from_json(whole, session.camera, error);
  if (!camera) return usage_error("camera: " + error.en, "camera：" + error.ja);
  session.camera = *camera;
  return {};
}

Outcome run_frame(Session& session, Arguments arguments, std::string_view) {
  if (arguments.size() > 1 || (arguments.size() == 1 && arguments[0] != "all" && arguments[0] != "selected"))
    return wrong_arguments("frame");
  if (arguments.size() == 1 && arguments[0] == "selected")
    session.frame_selection();
  else
    session.frame_all();
  return {};
}

Outcome run_projection(Session& session, Arguments arguments, std::string_view) {
  const std::string_view word = arguments.size() == 1 ? arguments[0] : "";
  if (word != "toggle" && word != "perspective" && word != "orthographic") return wrong_arguments("projection");
  const bool ortho = word == "toggle" ? !session.camera.ortho_height : word == "orthographic";
  session.camera = with_ortho(session.camera, ortho);
  return {};
}

Outcome run_click(Session& session, Arguments arguments, std::string_view) {
  const auto at = arguments.empty() ? std::nullopt : parse_pixel(arguments[0]);
  if (!at || arguments.size() > 2) return wrong_arguments("click");
  if (arguments.size() == 2 && !find_tool(arguments[1])) return not_a_tool(arguments[1]);
  return session.click(*at, arguments.size() == 2 ? std::string(arguments[1]) : session.tool);
}

Outcome run_drag(Session& session, Arguments arguments, std::string_view) {
  const auto from = arguments.size() == 2 ? parse_pixel(arguments[0]) : std::nullopt;
  const auto to = arguments.size() == 2 ? parse_pixel(arguments[1]) : std::nullopt;
  if (!from || !to) return wrong_arguments("drag");
  session.camera = orbited(session.camera, *to - *from, session.view);
  return {};
}

Outcome run_key(Session& session, Arguments arguments, std::string_view) {
  if (arguments.size() != 1) return wrong_arguments("key");
  const KeyRow* key = find_key(arguments[0]);
  if (!key)
    return usage_error("no key '" + std::string(arguments[0]) + "' (see ryosen keys)",
                       "キー「" + std::string(arguments[0]) + "」はありません（ryosen keys を参照）");
  return session.run(std::string(key->command));
}

Outcome run_shot(Session& session, Arguments, std::string_view whole) {
  if (!session.take_picture) {
    Outcome outcome;
    outcome.kind = Outcome::Kind::failed;
    outcome.exit_code = ExitCode::no_backend;
    outcome.sentence = {"no picture can be made here; use ryosen shot --script",
                        "ここでは画像を作れません。ryosen shot --script を使ってください"};
    return outcome;
  }
  const std::string_view named = trimmed(whole);
  const Status status =
      session.take_picture(named.empty() ? std::filesystem::path("ryosen.png") : std::filesystem::path(named));
  return status ? Outcome() : failed(status.failure());
}

// Which of the words the one argument is.
std::optional<std::size_t> one_of(Arguments arguments, std::initializer_list<std::string_view> words) {
  const auto found = arguments.size() == 1 ? std::find(words.begin(), words.end(), arguments[0]) : words.end();
  if (found == words.end()) return std::nullopt;
  return static_cast<std::size_t>(found - words.begin());
}

Outcome run_panel(Session& session, Arguments arguments, std::string_view) {
  if (!one_of(arguments, {"none", "keys", "open", "save", "unsaved"})) return wrong_arguments("panel");
  session.open_panel = arguments[0] == "none" ? "" : std::string(arguments[0]);
  return {};
}

Outcome run_language(Session& session, Arguments arguments, std::string_view) {
  const auto which = one_of(arguments, {"en", "ja"});
  if (!which) return wrong_arguments("language");
  session.language = *which == 1 ? Language::japanese : Language::english;
  return {};
}

Outcome run_theme(Session& session, Arguments arguments, std::string_view) {
  const auto which = one_of(arguments, {"dark", "light"});
  if (!which) return wrong_arguments("theme");
  session.light_theme = *which == 1;
  return {};
}

// One step out of what was begun: first the open panel, then the tool, then the selection.
Outcome run_cancel(Session& session, Arguments arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("cancel");
  if (!session.open_panel.empty()) return session.run("panel none");
  if (!session.tool.empty()) return session.run("tool none");
  return session.run("select none");
}

Outcome run_quit(Session& session, Arguments, std::string_view) {
  if (session.quit) session.quit();
  return {};
}

constexpr std::array rows{
    CommandRow{"open", "FILE", "opens a mesh in place of the current one", "メッシュを開く", true, run_open},
    CommandRow{"save", "[FILE]", "writes the mesh", "メッシュを保存する", true, run_save},
    CommandRow{"select", "NAME...|none", "selects vertices, edges, faces by name", "名前で要素を選択する", false,
               run_select},
    CommandRow{"undo", "[N]", "takes back the last N edits", "直前の N 回の編集を元に戻す", true, run_undo},
    CommandRow{"redo", "[N]", "does N undone edits again", "元に戻した N 回の編集をやり直す", true, run_redo},
    CommandRow{"camera", "JSON", "sets eye, target, up, fov_y_deg, ortho_height", "カメラを設定する", false,
               run_camera},
    CommandRow{"view", "front|back|left|right|top|bottom|iso", "looks along an axis at all of the mesh",
               "軸方向から全体を見る", false, run_view},
    CommandRow{"frame", "[all|selected]", "fits the mesh or the selection into the view",
               "全体または選択を画面に収める", false, run_frame},
    CommandRow{"projection", "toggle|perspective|orthographic", "switches the projection", "投影法を切り替える", false,
               run_projection},
    CommandRow{"show", "ID|all [on|off]", "shows or hides a highlight", "強調表示を切り替える", false, run_show},
    CommandRow{"tool", "ID|none", "chooses what a click does", "クリックで使うツールを選ぶ", false, run_tool},
    CommandRow{"mode", "vertex|edge|face|halfedge", "chooses what the pointer picks", "ポインタで選ぶ要素を決める",
               false, run_mode},
    CommandRow{"click", "X,Y [TOOL]", "clicks at a pixel", "画素をクリックする", false, run_click},
    CommandRow{"drag", "X,Y X,Y", "orbits by a drag from pixel to pixel", "ドラッグで視点を回す", false, run_drag},
    CommandRow{"key", "CHORD", "presses a key", "キーを押す", false, run_key},
    CommandRow{"shot", "[FILE]", "writes a picture", "画像を書き出す", false, run_shot},
    CommandRow{"expect", "V N|E N|F N|legal COMMAND|refused COMMAND|hash H", "fails the script unless it holds",
               "成り立たなければスクリプトを失敗にする", false, run_expect},
    CommandRow{"panel", "keys|open|save|unsaved|none", "opens or closes a panel over the view",
               "画面に重なるパネルを開閉する", false, run_panel},
    CommandRow{"language", "en|ja", "sets the language of the window", "画面の言語を選ぶ", false, run_language},
    CommandRow{"theme", "dark|light", "sets the colours of the window", "画面の配色を選ぶ", false, run_theme},
    CommandRow{"cancel", "", "closes the open panel, else puts the tool away, else selects nothing",
               "パネル、ツール、選択の順に取り消す", false, run_cancel},
    CommandRow{"quit", "", "ends the program", "終了する", false, run_quit},
};

}  // namespace

std::span<const CommandRow> command_table() { return rows; }

const CommandRow* find_command(std::string_view id) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const CommandRow& r) { return r.id == id; });
  return row == rows.end() ? nullptr : &*row;
}

std::vector<std::string> command_ids() {
  std::vector<std::string> ids;
  for (const OpInfo& op : all_ops()) ids.emplace_back(op.id);
  for (const CommandRow& row : rows) ids.emplace_back(row.id);
  return ids;
}

Outcome unknown_command(std::string_view id) {
  const std::string wrong(id), close = closest_word(id, command_ids());
  return usage_error("there is no command '" + wrong + "'" + (close.empty() ? "" : "; did you mean " + close + "?"),
                     "コマンド「" + wrong + "」はありません" + (close.empty() ? "" : "。" + close + " ですか？"));
}

}  // namespace ryosen
