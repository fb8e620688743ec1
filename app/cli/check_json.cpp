// The report of `check` as JSON: what each key means and holds.
#include <algorithm>

#include "app/cli/check_report.h"
#include "app/cli/contract/check.h"
#include "app/cli/contract/json.h"
#include "ryosen/analysis/boundary_loops.h"

namespace ryosen::cli {

namespace {

template <auto member>
Json figure(const CheckReport& report) {
  if constexpr (requires { or_null(report.figures.*member); })
    return or_null(report.figures.*member);
  else
    return report.figures.*member;
}
template <auto member>
Json beside(const CheckReport& report) {
  return report.beside.*member;
}

Json bounds(const CheckReport& report) {
  const auto& box = report.figures.bounds;
  return box ? Json::array({to_json((*box)[0]), to_json((*box)[1])}) : Json();
}

Json kind_reason(const CheckReport& report) { return to_json(report.kind.reason); }

Json open_boundary(const CheckReport& report) { return report.figures.open_boundary ? to_json(no_loop_count) : Json(); }

// Without the names and the pairs; empty arrays are the placeholders.
Json without_names(const Problem& problem) {
  Record<problem_shape> json;
  json["kind"] = problem.row().id;
  json["severity"] = problem.row().severity == ProblemSeverity::problem ? "problem" : "info";
  json["count"] = problem.count();
  json["elements"] = Json::array();
  if (problem.row().is_on_request()) {
    json["pairs"] = Json::array();
    json["complete"] = problem.intersections.is_all();
  }
  json["where"] = problem.where ? to_json(*problem.where) : Json();
  json["line"] = problem.line ? Json(problem.line) : Json();
  json.put(problem.text);
  return std::move(json).json();
}

Json problems_without_names(const CheckReport& report) {
  return array_of(report.problems, [](const NamedProblem& named) { return without_names(named.problem); });
}

constexpr CheckRow rows_before_counts[] = {
    {{"file", "string", "The file, as it was named.", "指定されたとおりのファイル名。"},
     {[](const CheckReport& r) -> Json { return r.file; }}},
    {{"format", "string", "Its format.", "ファイルの形式。", ids_of(Ids::formats)},
     {[](const CheckReport& r) -> Json { return r.format; }}},
    {{"status", "string", "warnings where there is a problem or a message of severity warning.",
      "問題または警告のメッセージがあれば warnings。", words("ok warnings")},
     {[](const CheckReport& r) -> Json { return r.status(); }}},
    {{"vertices", "integer", "Vertices of the file; of STL after welding.", "ファイルの頂点数（STL では縫合後）。"},
     {figure<&Figures::vertices>, 0, "vertices", "頂点"}},
    {{"corners", "integer", "Corners of all faces of the file; of STL before welding.",
      "ファイルの面の角の総数（STL では縫合前）。"},
     {figure<&Figures::corners>}},
    {{"faces", "integer", "Faces of the file, quarantined ones too.", "ファイルの面数（隔離された面を含む）。"},
     {figure<&Figures::faces>, 2, "faces", "面"}},
    {{"lines", "integer", "Line elements of the file; absent where it has none.",
      "ファイルの線の要素の数。なければ省く。", optional()},
     {beside<&ElementTotals::lines>, 18, "lines", "線"}},
    {{"points", "integer", "Point elements of the file; absent where it has none.",
      "ファイルの点の要素の数。なければ省く。", optional()},
     {beside<&ElementTotals::points>, 19, "points", "点"}},
    {{"edges", "integer", "Edges that usable faces have, between points, whatever their direction.",
      "使える面の稜線数（二点間、向きによらない）。"},
     {figure<&Figures::edges>, 1, "edges", "稜線"}},
    {{"triangles", "integer", "Faces of three corners, quarantined ones too.", "三角形の数（隔離された面を含む）。"},
     {figure<&Figures::triangles>, 3, "triangles", "三角形"}},
    {{"quads", "integer", "Faces of four corners, quarantined ones too.", "四角形の数（隔離された面を含む）。"},
     {figure<&Figures::quads>, 4, "quads", "四角形"}},
    {{"polygons", "integer", "Faces of five or more corners, quarantined ones too.",
      "五角以上の面の数（隔離された面を含む）。"},
     {figure<&Figures::polygons>, 5, "polygons", "多角形"}},
    {.value = {nullptr, 17, "quarantined", "隔離された面"}, .kind = ProblemKind::quarantined_face},
    {{"rings", "integer", "Inner loops of faces.", "面の穴（リング）の数。"},
     {figure<&Figures::rings>, 11, "rings", "面の穴"}},
    {.value = {nullptr, 6, "boundary edges", "境界稜線"}, .kind = ProblemKind::boundary_loop},
    {{"boundary_loops", "integer", "Boundary loops, of the edges that close to one.",
      "境界ループの数（輪になる境界だけ）。"},
     {figure<&Figures::boundary_loops>, 7, "boundary loops", "境界ループ"}},
    {{"open_boundary", "object or null", "Why some boundary edges close to no loop; null where all do.",
      "輪にならない境界がある理由。ないとき null。", objects(sentence_shape)},
     {open_boundary}},
    {.kind = ProblemKind::nonmanifold_edge},
    {{"max_edge_faces", "integer", "The most faces at one edge.", "一本の稜線に接する面の最大数。"},
     {figure<&Figures::max_edge_faces>}},
    {.kind = ProblemKind::nonmanifold_vertex},
    {{"bowtie_vertices", "integer", "Vertices where several fans of faces meet.", "複数の面の扇が集まる頂点の数。"},
     {figure<&Figures::bowtie_vertices>}},
};

constexpr CheckRow rows_after_counts[] = {
    {{"components", "integer", "Connected parts.", "連結成分の数。"},
     {figure<&Figures::components>, 8, "components", "連結成分"}},
    {{"euler_characteristic", "integer", "Vertices that faces use, minus edges, plus faces, minus rings.",
      "オイラー標数（面が使う頂点 − 稜線 + 面 − リング）。"},
     {figure<&Figures::euler_characteristic>, 9, "Euler char.", "オイラー標数"}},
    {{"genus", "integer or null", "Genus; null where the mesh is not manifold and orientable, or empty.",
      "種数。多様体で向き付け可能でないとき、または空のとき null。"},
     {figure<&Figures::genus>, 10, "genus", "種数"}},
    {{"manifold", "boolean", "Whether there is no non-manifold edge and no bowtie vertex.", "多様体か。"},
     {figure<&Figures::manifold>, 12, "manifold", "多様体"}},
    {{"closed", "boolean", "Whether there are faces, and two at every edge.",
      "閉じているか（どの稜線にも二つの面がある）。"},
     {figure<&Figures::closed>, 13, "closed", "閉じている"}},
    {{"orientable", "boolean", "Whether the faces can be turned so that all neighbours agree.",
      "隣り合う面の向きをすべて揃えられるか。"},
     {figure<&Figures::orientable>, 14, "orientable", "向き付け可能"}},
    {{"bounds", "array of array of number or null",
      "Smallest and largest coordinates of faces, each x y z; null where no face has finite coordinates.",
      "面の座標の最小と最大（それぞれ x y z）。有限の座標の面がないとき null。"},
     {bounds}},
    {{"area", "number or null", "Area of all faces with finite coordinates; null where it is too large for a number.",
      "座標が有限な面の面積の和。数に収まらないとき null。"},
     {figure<&Figures::area>, 15, "area", "面積"}},
    {{"volume", "number or null",
      "Volume; null where the mesh is not closed, manifold and consistently oriented with finite coordinates.",
      "体積。閉じた多様体で、向きが揃い、座標が有限でないとき null。"},
     {figure<&Figures::volume>, 16, "volume", "体積"}},
    {{"kind", "string", "What the mesh is, in one word.", "メッシュの種類。", ids_of(Ids::mesh_kinds)},
     {[](const CheckReport& r) -> Json { return row_of(r.kind.kind).id; }}},
    {{"kind_reason", "object", "Why, with the element that shows it.", "その理由と、それを示す要素。",
      objects(sentence_shape)},
     {kind_reason}},
    {{"hash", "string", "Of places and connectivity; equal for equal meshes on every machine.",
      "位置と接続のハッシュ値。同じメッシュならどの環境でも同じ。"},
     {[](const CheckReport& r) -> Json { return r.hash; }}},
    {{"problems", "array of object", "What is wrong, and what is worth to know.", "問題と注意すべきこと。",
      objects(problem_shape)},
     {problems_without_names}},
    {{"messages", "array of object", "What reading had to say.", "読み込み時のメッセージ。", objects(message_shape)},
     {[](const CheckReport& r) -> Json { return to_json(r.messages); }}},
};

JsonKey key_of(const ProblemRow& row) { return {row.figure, "integer", row.figure_en, row.figure_ja}; }

}  // namespace

Json CheckRow::print(const CheckReport& report) const { return kind ? Json(report.figures[*kind]) : value.of(report); }

std::vector<CheckRow> check_rows() {
  std::vector<CheckRow> rows(std::begin(rows_before_counts), std::end(rows_before_counts));
  for (CheckRow& row : rows)
    if (row.kind) row.key = key_of(row_of(*row.kind));
  for (const ProblemRow& row : problem_table())
    if (!row.figure.empty() &&
        std::none_of(rows.begin(), rows.end(), [&](const CheckRow& named) { return named.kind == row.kind; }))
      rows.push_back({.key = key_of(row), .kind = row.kind});
  rows.insert(rows.end(), std::begin(rows_after_counts), std::end(rows_after_counts));
  return rows;
}

bool is_absent(const CheckRow& row, const Json& value) { return row.key.limits.is_optional && value == 0; }

std::vector<JsonKey> check_keys() {
  std::vector<JsonKey> keys;
  for (const CheckRow& row : check_rows()) keys.push_back(row.key);
  return keys;
}

namespace {

void append_name(std::string_view name, std::string& out) {
  if (out.back() != '[') out += ',';
  out += '"';
  out += name;
  out += '"';
}

void append_pairs(const std::vector<FacePair>& pairs, std::string& out) {
  for (const FacePair& pair : pairs) {
    out += out.back() == '[' ? "[" : ",[";
    for (Face f : {pair.first, pair.second}) append_name("f" + std::to_string(f.index), out);
    out += ']';
  }
}

// At least what the names and pairs take.
std::size_t bytes_of_lists(const NamedProblem& named) {
  constexpr std::size_t around_two_names = std::string_view("[\"f\",\"f\"],").size();
  const std::vector<FacePair>& pairs = named.problem.intersections.pairs;
  const std::size_t digits = pairs.empty() ? 0 : std::to_string(named.problem.elements.back().index).size();
  return named.names.bytes() + 2 * named.problem.count() + pairs.size() * (around_two_names + 2 * digits);
}

}  // namespace

Json to_json(const NamedProblem& named) {
  Json json = without_names(named.problem);
  named.names.for_each(named.problem.count(), [&](std::string_view name) { json["elements"].push_back(name); });
  return json;
}

std::string json_line_of(const CheckReport& report) {
  if (report.failure) return line_of(error_object(report.failure->message, report.file, report.format));
  Json json = Json::object();
  for (const CheckRow& row : check_rows())
    if (Json value = row.print(report); !is_absent(row, value)) json[std::string(row.key.id)] = std::move(value);
  const std::string line = line_of(json);
  std::string out;
  std::size_t bytes = line.size(), done = 0;
  for (const NamedProblem& problem : report.problems) bytes += bytes_of_lists(problem);
  out.reserve(bytes);
  // Copies up to the empty array of this key. It cannot occur in file contents, since quotes in strings are escaped.
  const auto go_into = [&](std::string_view array) {
    const std::size_t at = line.find(array, done) + array.size() - 1;
    out.append(line, done, at - done);
    done = at;
  };
  for (const NamedProblem& problem : report.problems) {
    go_into("\"elements\":[]");
    problem.names.for_each(problem.problem.count(), [&](std::string_view name) { append_name(name, out); });
    if (!problem.problem.row().is_on_request()) continue;
    go_into("\"pairs\":[]");
    append_pairs(problem.problem.intersections.pairs, out);
  }
  return out.append(line, done);
}

}  // namespace ryosen::cli
