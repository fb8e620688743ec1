#include "app/cli/subcommand_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>

#include "app/cli/algorithm_flags.h"
#include "app/cli/contract/algorithms.h"
#include "app/cli/contract/check.h"
#include "app/cli/contract/convert.h"
#include "app/cli/contract/hull.h"
#include "app/cli/contract/lists.h"
#include "app/cli/contract/measure.h"
#include "app/cli/contract/operators.h"
#include "app/cli/contract/shot.h"
#include "app/cli/contract/textbook.h"
#include "app/cli/help_topics.h"
#include "app/editor/preferences/view_switches.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/scene/view/named_views.h"

namespace ryosen::cli {

namespace {

const std::array common{
    Flag{"--json", "", false, "results as JSON, one object per line, also on failure",
         "結果を JSON で出力（一行に一つ、失敗時も）"},
    Flag{"-q", "", false, "no messages but errors", "エラー以外のメッセージを出さない"},
    Flag{"-v", "", false, "shorten nothing", "省略せずに出力"},
    Flag{"--lang", "en|ja", false, "language of texts; else that of the environment", "表示言語（省くと環境に従う）"},
    Flag{"--help", "", false, "the help of the command", "コマンドの使い方"},
    Flag{"-h", "", false, "the same", "同上"},
};

const Flag overwrite{"--overwrite", "", false, "allows to replace what the run reads or wrote before",
                     "この実行で読み込む、または先に書き出したファイルの置き換えを許す"};

const Flag preferences{"--preferences", "FILE", false,
                       "reads these preferences; else the editor its user's, a picture none",
                       "設定ファイル（省くとエディタは利用者の設定、画像は設定なし）"};

// Those of `shot`, with one for each switch of the view that has one.
std::vector<Flag> shot_flags() {
  std::vector<Flag> flags{
      {"-o", "PNG", false, "where the picture goes", "画像の出力先"},
      {"--size", "WxH", false, "in pixels; else 1280x720", "画素数（省くと 1280x720）"},
      {"--view", named_view_ids(), false, "looks along an axis", "軸方向から見る"},
      {"--camera", "JSON", false, "eye, target, up, fov_y_deg, ortho_height", "カメラを指定する"},
      {"--show", "IDS|all|none", false, "the highlights, separated by commas", "強調表示（コンマ区切り）"},
      {"--select", "NAMES", false, "selects elements", "要素を選択する"},
      {"--hover", "X,Y", false, "where the pointer is, in pixels of the picture", "ポインタの位置（画素）"},
      {"--tool", "OP", false, "the tool in hand", "使うツール"},
      {"--click", "X,Y[,TOOL]", true, "clicks there first (repeatable)", "先にクリックする（繰り返し可）"},
      {"--script", "S", false, "first runs the commands of a file", "先にファイルのコマンドを実行"},
      {"--panels", "", false, "the whole window with its panels", "パネルを含む画面全体"},
      {"--transparent", "", false, "no background", "背景を透明にする"},
      {"--supersample", "N", false, "smooths by N x N rendered pixels each", "N x N 画素から滑らかに描く"},
  };
  for (const ViewSwitch& row : view_switches())
    if (row.has_flag())
      flags.push_back({flag_of(row), ids_of(row.values), false, std::string(row.flag_en), std::string(row.flag_ja)});
  const std::vector<Flag> behind{
      preferences,
      {"--backend", "auto|osmesa|egl", false, "what draws", "描画に使うもの"},
      {"--compare", "REF.png", false, "ends with 1 if the picture differs from this one",
       "この画像と異なれば終了コード 1"},
      {"--diff", "D.png", false, "with --compare: writes where they differ", "--compare の差分画像の出力先"},
      {"--tolerance", "PERCENT", false, "of the pixels may differ; else 0.2", "異なってよい画素の割合（省くと 0.2）"},
      overwrite,
  };
  flags.insert(flags.end(), behind.begin(), behind.end());
  return flags;
}

std::vector<Subcommand> table() {
  return {
      Subcommand{"view",
                 "[FILE]",
                 "the editor; also what ryosen does without a command",
                 "エディタ（コマンドを省いたときもこれ）",
                 view_command,
                 view_contract,
                 {preferences},
                 recovery_topic,
                 false,
                 true},
      Subcommand{"check",
                 "FILE|FOLDER...",
                 "figures and problems of meshes",
                 "メッシュの諸量と問題点",
                 check_command,
                 check_contract,
                 {
                     {"--fail-on", "KIND,...|none", false, "only problems of these kinds lead to exit code 1",
                      "ここに挙げた種類の問題だけを終了コード 1 にする"},
                     {"--self-intersections", "", false, "also finds faces that meet elsewhere than in what they share",
                      "共有要素以外で交わる面も探す"},
                     {"--jobs", "N", false, "how many files are checked at once; else one per processor",
                      "同時に調べるファイル数（省くとプロセッサ数）"},
                     {"--unordered", "", false, "report each file as soon as it is done",
                      "入力順を待たず、終わったものから出力"},
                 },
                 problem_kinds_topic},
      Subcommand{
          "why",
          "FILE",
          "may an operator be done, and if not, why not and what would help",
          "操作が可能か、不可能なら理由と対処",
          why_command,
          why_contract,
          {
              {"--op", "OP", false, "an operator that works on an edge", "稜線に対する操作"},
              {"--edge", "A-B", false, "asks about one edge", "一本の稜線について答える"},
              {"--all", "", false, "asks about every edge", "すべての稜線について答える"},
              {"--do", "COMMAND", false, "asks about a command as scripts write it", "スクリプトの一行について答える"},
              {"--geometry", "", false,
               "with --all: the geometric warnings too (of edges at more than 400 sides or edges: that there are so "
               "many)",
               "--all で幾何的な警告も出す（稜線が 400 を超える所では、多いことだけを伝える）"},
          },
          operators_topic},
      Subcommand{"edit",
                 "FILE",
                 "runs commands on a mesh; without -o and save a trial that writes nothing",
                 "コマンドを実行（-o も save もなければ何も書き出さない）",
                 edit_command,
                 edit_contract,
                 {
                     {"-o", "OUT", false,
                      "writes the result, unless something was refused or failed; /dev/stdout gets it alone, in the "
                      "format of FILE",
                      "結果の出力先（拒否・失敗があれば書き出さない）。/dev/stdout には結果だけを FILE の形式で出す"},
                     {"--new", "", false, "begins with an empty mesh instead of a FILE",
                      "FILE の代わりに空のメッシュから始める", true},
                     {"--do", "COMMAND", true, "runs commands, separated by ; (repeatable)",
                      "コマンドを実行（; で区切る、繰り返し可）"},
                     {"--script", "S", false, "runs the commands of a file", "ファイルのコマンドを実行"},
                     {"--on-refuse", "skip", false, "goes on after a refusal, writes the result, ends with 1",
                      "拒否されても続け、結果を書き出し、終了コード 1"},
                     {"--strict", "", false, "warnings refuse too, also those of what a file would lose",
                      "警告も拒否とする（ファイルで失われるものも含む）"},
                     overwrite,
                 },
                 script_commands_topic},
      Subcommand{"repair",
                 "FILE",
                 "takes whole kinds of problems away; without -o a trial that writes nothing",
                 "問題を種類ごとにまとめて直す（-o がなければ何も書き出さない）",
                 repair_command,
                 repair_contract,
                 {
                     {"-o", "OUT", false, "writes the result; /dev/stdout gets it alone, in the format of FILE",
                      "結果の出力先。/dev/stdout には結果だけを FILE の形式で出す"},
                     {"--kinds", "KIND[=NUMBER],...", false,
                      "these repairs, in the order of the list below; default stands for all that are done unasked",
                      "行う修復（下の一覧の順に実行。default は省略時の修復すべて）"},
                     overwrite,
                 },
                 repairs_topic},
      Subcommand{"convert",
                 "FILE",
                 "writes a mesh in another format and says first what that format cannot hold",
                 "別の形式で書き出す（その形式で失われるものを先に示す）",
                 convert_command,
                 convert_contract,
                 {
                     {"-o", "OUT", false,
                      "the output; its extension tells the format (/dev/stdout gets it alone, with --format)",
                      "出力先（拡張子が形式を決める。/dev/stdout には結果だけを出し、--format が必要）"},
                     {"--format", "ID", false, "the format, whatever the name says (see ryosen formats)",
                      "形式を指定する（ryosen formats を参照）"},
                     {"--strict", "", false, "refuses, with exit code 6, where anything would be lost",
                      "失われるものがあれば終了コード 6 で中止する"},
                     {"--triangulate", "", false, "cuts faces of more than three corners into triangles",
                      "4 頂点以上の面を三角形に分割する"},
                     overwrite,
                 }},
      Subcommand{
          "hull",
          "FILE",
          "the convex hull of the points of a file (- reads lines of three numbers from standard input); without -o "
          "nothing is written",
          "ファイルの点の凸包（- なら標準入力から一行三数の座標を読む）。-o がなければ何も書き出さない",
          hull_command,
          hull_contract,
          {
              {"-o", "OUT", false, "writes the hull", "凸包の出力先"},
              {"--facets", "", false, "facets as polygons; this is also done unasked", "面を多角形のまま出す（既定）"},
              {"--triangles", "", false, "cuts each facet into the fan from its lowest number",
               "各面を番号最小の頂点からの扇で三角形に分ける"},
              {"--per-component", "", false, "a hull of each connected component; a point by itself is one",
               "連結成分ごとに凸包を作る（孤立した点も一成分）"},
              {"--project", "x|y|z|best", false,
               "the polygon around the points as seen along an axis; best: the one in which they reach least",
               "軸方向に投影した点の多角形（best は広がりが最も小さい軸）"},
              {"--measure", "", false, "also the farthest pair of points and the smallest width",
               "最も遠い 2 点と最小の幅も求める"},
              {"--skip-nonfinite", "", false, "leaves points out that are not finite; else they are refused",
               "有限でない点を除く（省くと拒否する）"},
              overwrite,
          }},
      Subcommand{"shot", "FILE", "a picture of a mesh or of the whole editor, without a display",
                 "メッシュまたはエディタ全体の画像（ディスプレイ不要）", shot_command, shot_contract, shot_flags(),
                 shot_topic},
      Subcommand{"measure",
                 "FILE [NAME]...",
                 "numbers of all elements: lengths, angles, areas, valences; or between elements that are named",
                 "全要素の長さ・角・面積・価数などの統計、または名前を挙げた要素の計測",
                 measure_command,
                 measure_contract,
                 {
                     {"--map", "ID", false, "of this alone (see below); else of all", "この項目だけ（下の一覧を参照）"},
                     {"--bars", "N", false, "with a histogram of so many bars", "この数の区間のヒストグラムも出す"},
                     {"--against", "OTHER", false, "also how far the vertices are from this mesh",
                      "各頂点のこのメッシュからの距離も測る"},
                 },
                 maps_topic},
      Subcommand{"distance",
                 "FILE OTHER",
                 "how far two surfaces are from each other: largest, mean and root mean square distance, both ways",
                 "二つの曲面の距離（最大、平均、二乗平均平方根、両方向）",
                 distance_command,
                 distance_contract,
                 {
                     {"--gap", "G", false,
                      "how much the bound of the largest distance may be above it, as a share of it; else 1e-6",
                      "最大距離の上界が超えてよい割合（省くと 1e-6）"},
                     {"--samples", "N", false,
                      "about so many for the means; else 200000, or one per triangle where these are more",
                      "平均に用いる標本のおよその数（省くと 200000、三角形がそれより多ければその数）"},
                 }},
      Subcommand{
          "forms",
          "[FILE]",
          "the representations of the source texts for this mesh: bytes per face, build and query times",
          "テキストの形状表現の比較（面あたりのバイト数、構築時間、問い合わせ時間）",
          forms_command,
          forms_contract,
          {
              {"--element", "NAME|all", false, "what each form stores of an element, or of all",
               "各形状表現が要素（all は全要素）について持つデータ"},
              {"--form", "ID", false, "with --element: of this form alone", "--element でこの形状表現だけ"},
              {"--growth", "", false,
               "how the work grows with the number of faces: on parts of FILE, or without it on tori",
               "面の数に対する手間の増え方（FILE の一部で、FILE がなければトーラスで測る）", true},
              {"--plot", "PNG", false, "with --growth: a picture of the curves", "--growth の曲線の画像の出力先"},
              {"--relation", "ID", false, "with --plot: the query that is drawn; else vertex_faces",
               "--plot で描く問い合わせ（省くと vertex_faces）"},
              {"--theme", "dark|light", false, "with --plot: the colours; else dark", "--plot の配色（省くと dark）"},
              overwrite,
          },
          forms_topic},
      Subcommand{"steps",
                 "WHAT... FILE",
                 "plays something step by step: what is done, what changes, and where the source texts say so",
                 "一手ずつ再生（何をし、何が変わり、テキストのどこにあるか）",
                 steps_command,
                 steps_contract,
                 {
                     {"--at", "N", false, "this step alone, from 1", "この手順だけ（1 から）"},
                     {"-o", "PNG", false, "a picture of this step, else of the last one",
                      "この手順（省くと最後）の画像の出力先"},
                     {"--numbers", ids_of(find_view_switch("numbers")->values), false,
                      "whose numbers are written into it; else none", "画像に書く番号の種類（省くと書かない）"},
                     overwrite,
                 },
                 steps_topic},
      Subcommand{"practice",
                 "[FILE]",
                 "questions about the structure of a mesh, or of a figure of the source texts, and their answers",
                 "メッシュやテキストの図の構造についての問題と答え",
                 practice_command,
                 practice_contract,
                 {
                     {"--seed", "N", false, "draws the question; else 1", "問題を選ぶ数（省くと 1）"},
                     {"--kind", "next|twin|record|legal|valence", false, "of this kind alone", "この種類の問題だけ"},
                     {"--answer", "WORD", false, "judges it: an element, a number, none, yes, or the rule that forbids",
                      "答えを判定する（要素、数、none、yes、または禁じる規則）"},
                     {"--count", "N", false, "so many questions, of this seed and the following ones",
                      "出題数（続く数の問題も出す）"},
                 },
                 practice_topic},
      Subcommand{"formats", "", "the file formats", "ファイル形式の一覧", formats_command, formats_contract},
      Subcommand{"keys", "", "the keys of the editor", "エディタのキー一覧", keys_command, keys_contract},
      Subcommand{"doctor", "", "what this machine offers: versions, backends, fonts, packages",
                 "この環境の状況（版、描画、フォント、パッケージ）", doctor_command, doctor_contract},
      Subcommand{"help",
                 "[COMMAND|json|texts]",
                 "what the program and its commands do; json: every key and code that they print; texts: where each "
                 "figure of the source texts is found",
                 "プログラムとコマンドの使い方（json：出力するキーとコードのすべて、texts：テキストの図表がある場所）",
                 help_command,
                 help_contract,
                 {},
                 nullptr,
                 true},
      Subcommand{"--version", "", "the version of the program", "プログラムの版", version_command, version_contract},
  };
}

Subcommand subcommand_of(const AlgorithmRow& row) {
  std::vector<Flag> flags{
      {"-o", "OUT", false, "writes the result; else a trial", "結果の出力先（省くと書き出さない）"}};
  for (const ParameterRow& parameter : row.parameters) {
    const Text is = described(parameter);
    flags.push_back({flag_of(parameter), flag_value(parameter), false, std::string(parameter.help_en) + ": " + is.en,
                     std::string(parameter.help_ja) + "：" + is.ja});
  }
  if (row.has_goal)
    flags.push_back({"--distance", "", false, "also measures how far the result is from the input, as distance does",
                     "結果が入力から離れた距離も測る（distance と同じ）"});
  flags.push_back(overwrite);
  const auto more = [&row](Language language) { return algorithm_topic(row, language); };
  const auto run = [&row](const Arguments& arguments, const Console& console) {
    return algorithm_command(row, arguments, console);
  };
  Subcommand made{row.id,
                  row.is_primitive ? "[FILE]" : "FILE",
                  row.help_en,
                  row.help_ja,
                  run,
                  row.has_goal ? goal_contract : algorithm_contract,
                  std::move(flags),
                  more};
  made.is_algorithm = true;
  return made;
}

template <class Counts>
std::size_t count_words(std::string_view words, const Counts& counts) {
  std::size_t count = 0;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    if (counts(word)) ++count;
    words.remove_prefix(std::min(words.size(), word.size() + 1));
  }
  return count;
}

}  // namespace

std::vector<Subcommand> subcommands() {
  std::vector<Subcommand> all = table();
  for (const AlgorithmRow& row : algorithm_table())
    if (!row.has_own_subcommand) all.push_back(subcommand_of(row));
  return all;
}

std::span<const Flag> common_flags() { return common; }

std::optional<Subcommand> find_subcommand(std::string_view id) {
  for (const Subcommand& command : table())
    if (command.id == id) return command;
  const AlgorithmRow* const algorithm = find_algorithm(id);
  return algorithm ? std::optional(subcommand_of(*algorithm)) : std::nullopt;
}

std::size_t Subcommand::least_operands() const {
  const bool may_lack = std::any_of(flags.begin(), flags.end(), [](const Flag& flag) { return flag.replaces_operand; });
  return may_lack ? 0 : count_words(operands, [](std::string_view word) { return !word.starts_with('['); });
}

std::size_t Subcommand::most_operands() const {
  if (operands.find("...") != std::string_view::npos) return std::numeric_limits<std::size_t>::max();
  return count_words(operands, [](std::string_view) { return true; });
}

bool Arguments::has(std::string_view flag) const { return value(flag) != nullptr; }

const std::string* Arguments::value(std::string_view flag) const {
  const std::string* last = nullptr;
  for (const Given& given : given_)
    if (given.flag == flag) last = &given.value;
  return last;
}

std::vector<std::string> Arguments::values(std::string_view flag) const {
  std::vector<std::string> all;
  for (const Given& given : given_)
    if (given.flag == flag) all.push_back(given.value);
  return all;
}

std::optional<std::uint64_t> whole_number(std::string_view word, std::uint64_t least, std::uint64_t most) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_whole = error == std::errc() && end == word.data() + word.size();
  return is_whole && number >= least && number <= most ? std::optional(number) : std::nullopt;
}

}  // namespace ryosen::cli
