#include "app/editor/preferences/view_switches.h"

#include <cassert>
#include <type_traits>

#include "app/editor/camera/cutting.h"
#include "app/editor/camera/view_state.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/input/input_presets.h"
#include "app/editor/preferences/preference_values.h"
#include "ryosen/base/rows.h"

namespace ryosen {

namespace {

// A field of the settings as the value of a row.
template <auto field>
std::size_t setting(const ViewState& view) {
  return static_cast<std::size_t>(view.settings.*field);
}
template <auto field>
void set_setting(ViewState& view, std::size_t value) {
  view.settings.*field = static_cast<std::remove_cvref_t<decltype(view.settings.*field)>>(value);
}

std::vector<SwitchValue> preset_values() {
  std::vector<SwitchValue> values;
  for (const InputPreset& preset : input_presets()) values.push_back({preset.id, preset.name_en, preset.name_ja});
  return values;
}

std::vector<ViewSwitch>& switch_rows() {
  static std::vector<ViewSwitch> rows{
      {.id = "projection",
       .help_en = "switches the projection",
       .help_ja = "投影法を切り替える",
       .values = {{"perspective", "Perspective", "透視投影"}, {"orthographic", "Orthographic", "平行投影"}},
       .value = [](const ViewState& view) { return std::size_t{view.camera.ortho_height.has_value()}; },
       .set = [](ViewState& view, std::size_t value) { view.camera = with_ortho(view.camera, value == 1); },
       .chord = "Numpad5",
       .key_en = "perspective or orthographic",
       .key_ja = "透視投影と平行投影"},
      {.id = "orbit",
       .help_en = "a drag turns the view about the point that was pressed, or about the centre",
       .help_ja = "ドラッグで視点を回す中心を、押した点か画面の中心かで選ぶ",
       .values = {{"point", "Orbit about the point pressed", "押した点のまわりに回す"},
                  {"centre", "Orbit about the centre", "中心のまわりに回す"}},
       .value = [](const Preferences& preferences) { return static_cast<std::size_t>(preferences.orbit_about); },
       .set = [](Preferences& preferences,
                 std::size_t value) { preferences.orbit_about = static_cast<OrbitAbout>(value); },
       .menu_en = "Orbit",
       .menu_ja = "回転の中心",
       .preference_en = "Orbit",
       .preference_ja = "回転の中心"},
      {.id = "preset",
       .help_en = "drags and keys as in Ryosen or another program",
       .help_ja = "ドラッグとキーの割り当てを選ぶ",
       .values = preset_values(),
       .value = [](const Preferences& preferences) { return preferences.input_preset; },
       .set = [](Preferences& preferences, std::size_t value) { preferences.input_preset = value; },
       .menu_en = "Mouse and keys",
       .menu_ja = "マウスとキー",
       .preference_en = "Mouse and keys",
       .preference_ja = "マウスとキー"},
      {.id = "theme",
       .help_en = "sets the colours of the window",
       .help_ja = "画面の配色を選ぶ",
       .values = {{"dark", "Dark", "暗い配色"}, {"light", "Light", "明るい配色"}},
       .value = setting<&ViewSettings::theme>,
       .set = set_setting<&ViewSettings::theme>,
       .flag_en = "the colours",
       .flag_ja = "配色",
       .preference_en = "Theme",
       .preference_ja = "配色"},
      {.id = "shading",
       .help_en = "draws each face in a light of its own, or smoothly from face to face except at creases",
       .help_ja = "面ごとの陰影と、折り目以外で滑らかにつながる陰影を切り替える",
       .values = {{"flat", "Flat shading", "面ごとの陰影"}, {"smooth", "Smooth shading", "滑らかな陰影", 28}},
       .value = setting<&ViewSettings::shading>,
       .set = set_setting<&ViewSettings::shading>,
       .chord = "Shift+W",
       .key_en = "flat or smooth shading",
       .key_ja = "面ごとの陰影と滑らかな陰影",
       .flag_en = "how faces are lit; else flat",
       .flag_ja = "面の陰影（省くと flat）"},
      {.id = "wire",
       .help_en = "draws the edges of faces on the surface",
       .help_ja = "面の稜線の表示を切り替える",
       .values = {{"on", "Wireframe", "稜線を表示"}, {"off", "No wireframe", "稜線を表示しない"}},
       .value = setting<&ViewSettings::wire>,
       .set = set_setting<&ViewSettings::wire>,
       .chord = "W",
       .key_en = "with or without the edges of faces",
       .key_ja = "稜線の表示と非表示",
       .flag_en = "whether the edges of faces are drawn; else on",
       .flag_ja = "稜線の表示（省くと on）"},
      {.id = "xray",
       .help_en = "lets one see and pick through the surface",
       .help_ja = "面を透かして、裏側の要素も見えて選べるようにする",
       .values = {{"off", "No X-ray", "透過表示なし"}, {"on", "X-ray", "透過表示"}},
       .value = setting<&ViewSettings::xray>,
       .set = set_setting<&ViewSettings::xray>,
       .chord = "Z",
       .key_en = "see and pick through the surface, or not",
       .key_ja = "面を透かす表示の切り替え",
       .flag_en = "whether one sees through the surface; else off",
       .flag_ja = "面を透かす表示（省くと off）"},
      {.id = "dots",
       .help_en = "draws the vertices of faces: while the pointer picks vertices, always, or never",
       .help_ja = "面の頂点の表示：頂点モードのときだけ、常に、なし",
       .values = {{"picked", "Vertices in vertex mode", "頂点モードで頂点を表示"},
                  {"always", "Vertices always", "頂点を常に表示"},
                  {"never", "No vertices", "頂点を表示しない"}},
       .value = setting<&ViewSettings::dots>,
       .set = set_setting<&ViewSettings::dots>,
       .flag_en = "whether vertices are drawn; else in vertex mode",
       .flag_ja = "頂点の表示（省くと頂点モードのとき）",
       .menu_en = "Vertices",
       .menu_ja = "頂点"},
      {.id = "numbers",
       .help_en = "writes the numbers of elements beside them, as many as have room",
       .help_ja = "要素の番号を、重ならない範囲で表示する",
       .values = {{"off", "No numbers", "番号を表示しない"},
                  {"vertices", "Numbers of vertices", "頂点の番号"},
                  {"edges", "Numbers of edges", "稜線の番号"},
                  {"faces", "Numbers of faces", "面の番号"},
                  {"halfedges", "Numbers of halfedges", "半稜線の番号"},
                  {"all", "Numbers of all elements", "すべての要素の番号"},
                  {"corners", "Numbers 3i+j of halfedges", "半稜線の番号 3i+j"}},
       .value = setting<&ViewSettings::numbers>,
       .set = set_setting<&ViewSettings::numbers>,
       .flag_en = "whose numbers are written; else none",
       .flag_ja = "番号を表示する要素（省くと off）",
       .menu_en = "Numbers",
       .menu_ja = "番号"},
      {.id = "links",
       .help_en = "draws links as arrows inside the faces: of what is selected, in halfedge mode or always, or all "
                  "halfedges in view, or those of faces alone; a click on an arrow selects its halfedge",
       .help_ja = "リンクを面の内側の矢印で表示する（半稜線モードの選択、常に選択、画面内のすべて、面のあるものだけ）。"
                  "矢印をクリックするとその半稜線を選択する",
       .values = {{"mode", "Links in halfedge mode", "半稜線モードでリンクを表示"},
                  {"selection", "Links of the selection", "選択のリンクを常に表示"},
                  {"all", "All halfedges as arrows", "すべての半稜線を矢印で表示"},
                  {"faces", "Halfedges of faces as arrows", "面のある半稜線を矢印で表示"},
                  {"off", "No links", "リンクを表示しない"}},
       .value = [](const ViewState& view) { return static_cast<std::size_t>(view.links.shown); },
       .set = [](ViewState& view, std::size_t value) { view.links.shown = static_cast<LinksShown>(value); },
       .flag_en = "which links are drawn as arrows; else those of the selection in halfedge mode",
       .flag_ja = "矢印で表示するリンク（省くと半稜線モードの選択）",
       .menu_en = "Links",
       .menu_ja = "リンク"},
      {.id = "file_colours",
       .help_en = "shows the surface in the colours of the file: of its faces, else of its vertices",
       .help_ja = "ファイルの色（面の色、なければ頂点の色）で面を表示する",
       .values = {{"on", "Colours of the file", "ファイルの色", 16},
                  {"vertices", "Colours of vertices", "頂点の色", 16},
                  {"faces", "Colours of faces", "面の色", 16},
                  {"off", "No colours of the file", "ファイルの色を使わない"}},
       .value = setting<&ViewSettings::file_colours>,
       .set = set_setting<&ViewSettings::file_colours>,
       .flag_en = "whether the surface has the colours of the file; else on",
       .flag_ja = "ファイルの色を使うか（省くと on）",
       .menu_en = "Colours of the file",
       .menu_ja = "ファイルの色"},
      {.id = "normals",
       .help_en = "draws normals as lines, half as long as edges are in the mean",
       .help_ja = "法線を線で表示する（長さは稜線の平均の半分）",
       .values = {{"off", "No normals", "法線を表示しない"},
                  {"vertices", "Normals of vertices", "頂点の法線"},
                  {"faces", "Normals of faces", "面の法線"}},
       .value = setting<&ViewSettings::normals>,
       .set = set_setting<&ViewSettings::normals>,
       .flag_en = "whose normals are drawn; else none",
       .flag_ja = "法線を表示する要素（省くと off）",
       .menu_en = "Normals",
       .menu_ja = "法線"},
      {.id = "verdicts",
       .help_en = "draws all elements that the tool in hand acts on by its verdict: possible, or refused",
       .help_ja = "手にしたツールの判定（可能・不可）を、その対象となるすべての要素に表示する",
       .values = {{"off", "No verdicts on all elements", "全要素の判定なし"},
                  {"on", "Verdicts of the tool on all elements", "全要素にツールの判定"}},
       .value = [](const ViewState& view) { return std::size_t{view.shows_verdicts}; },
       .set = [](ViewState& view, std::size_t value) { view.shows_verdicts = value == 1; },
       .chord = "V",
       .key_en = "the verdict of the tool on all elements, or not",
       .key_ja = "全要素へのツールの判定表示の切り替え",
       .flag_en = "whether all elements show the verdict of the tool; else off",
       .flag_ja = "全要素へのツールの判定（省くと off）"},
      {.id = "ground",
       .help_en = "draws a grid on the ground below the mesh, with lines at round coordinates",
       .help_ja = "メッシュの下の地面に、切りのよい座標ごとの格子を表示する",
       .values = {{"off", "No ground grid", "地面の格子なし"}, {"on", "Ground grid", "地面の格子"}},
       .value = setting<&ViewSettings::ground>,
       .set = set_setting<&ViewSettings::ground>,
       .chord = "Shift+G",
       .key_en = "with or without a grid on the ground",
       .key_ja = "地面の格子の切り替え",
       .flag_en = "whether there is a grid on the ground; else off",
       .flag_ja = "地面の格子（省くと off）",
       .preference_en = "Ground grid",
       .preference_ja = "地面の格子"},
      {.id = "axes",
       .help_en =
           "draws the axes X, Y and Z in the corner, a click on which looks from there; a window begins with them",
       .help_ja = "隅に座標軸を表示し、クリックした方向から見る（ウィンドウでは表示から始まる）",
       .values = {{"off", "No axes in the corner", "隅の座標軸なし"}, {"on", "Axes in the corner", "隅の座標軸"}},
       .value = [](const ViewState& view) { return std::size_t{view.shows_axes}; },
       .set = [](ViewState& view, std::size_t value) { view.shows_axes = value == 1; },
       .chord = "Shift+V",
       .key_en = "with or without the axes in the corner",
       .key_ja = "隅の座標軸の切り替え",
       .flag_en = "whether the axes stand in the corner; else off",
       .flag_ja = "隅の座標軸（省くと off）",
       .preference_en = "Axes",
       .preference_ja = "座標軸",
       .first_in_window = 1},
      {.id = "clip",
       .help_en =
           "cuts the mesh in the middle across an axis: what lies beyond, on the side of the sign, is neither drawn "
           "nor picked; or across the line of sight",
       .help_ja = "メッシュを中央で切り、軸の符号の側を表示も選択もしない（view：視線に垂直に手前を切る）",
       .values = {{"off", "No clipping plane", "断面なし"},
                  {"x", "Cut off +X", "+X 側を切る"},
                  {"-x", "Cut off -X", "−X 側を切る"},
                  {"y", "Cut off +Y", "+Y 側を切る"},
                  {"-y", "Cut off -Y", "−Y 側を切る"},
                  {"z", "Cut off +Z", "+Z 側を切る"},
                  {"-z", "Cut off -Z", "−Z 側を切る"},
                  {"view", "Cut off what is nearer", "手前を切る"}},
       .value = [](const ViewState& view) -> std::size_t { return view.cut ? std::size_t(view.cut->way) : 0; },
       .set = [](const Mesh& mesh, ViewState& view,
                 std::size_t value) { cut_across(mesh, view, static_cast<ClipWay>(value)); },
       .flag_en = "where the mesh is cut; else nowhere",
       .flag_ja = "断面（省くと off）",
       .menu_en = "Clipping plane",
       .menu_ja = "断面"},
      {.id = "gizmo",
       .help_en =
           "shows handles at the selection, a drag of which moves, turns or scales it; a window begins with move",
       .help_ja = "選択をドラッグで移動・回転・拡大縮小するハンドルを表示する（ウィンドウでは move から始まる）",
       .values = {{"off", "No handles", "ハンドルなし"},
                  {"move", "Handles to move", "移動ハンドル"},
                  {"turn", "Handles to turn", "回転ハンドル"},
                  {"scale", "Handles to scale", "拡大縮小ハンドル"}},
       .value = [](const ViewState& view) { return static_cast<std::size_t>(view.gizmo_kind); },
       .set = [](ViewState& view, std::size_t value) { view.gizmo_kind = static_cast<GizmoKind>(value); },
       .chord = "Ctrl+G",
       .key_en = "handles that move, turn, scale, or none",
       .key_ja = "ハンドル（移動・回転・拡大縮小・なし）の切り替え",
       .menu_en = "Handles at the selection",
       .menu_ja = "選択のハンドル",
       .preference_en = "Handles",
       .preference_ja = "ハンドル",
       .first_in_window = 1},
  };
  return rows;
}

}  // namespace

std::span<const ViewSwitch> view_switches() { return switch_rows(); }

const ViewSwitch* find_view_switch(std::string_view id) { return find_row(switch_rows(), id); }

std::string ids_of(std::span<const SwitchValue> values) { return joined_ids(values); }

std::optional<std::size_t> find_value(const ViewSwitch& row, std::string_view id) {
  for (std::size_t i = 0; i < row.values.size(); ++i)
    if (row.values[i].id == id) return i;
  return std::nullopt;
}

void begin_as_window(Session& session) {
  for (const ViewSwitch& row : view_switches()) row.set(session, row.first_in_window);
}

std::string toggle_line(const ViewSwitch& row) { return std::string(row.id) + " toggle"; }

std::string flag_of(const ViewSwitch& row) { return "--" + std::string(row.id); }

ScopedViewSwitch::ScopedViewSwitch(ViewSwitch row) {
  assert(!find_view_switch(row.id) && "every switch has an id of its own, which is its command");
  switch_rows().push_back(std::move(row));
}

ScopedViewSwitch::~ScopedViewSwitch() { switch_rows().pop_back(); }

}  // namespace ryosen
