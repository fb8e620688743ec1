#include "ryosen/algo/algorithm_rows.h"

#include <array>

#include "ryosen/algo/preparation.h"
#include "ryosen/algo/subdivide/subdivide.h"
#include "ryosen/base/count_text.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

namespace {

struct SchemeRow {
  subdivide::Scheme scheme;
  std::string_view id, en, ja;
};
constexpr std::array schemes{
    SchemeRow{subdivide::Scheme::loop, "loop", "Loop (triangles)", "Loop（三角形）"},
    SchemeRow{subdivide::Scheme::catmull_clark, "catmull_clark", "Catmull-Clark (polygons)", "Catmull-Clark（多角形）"},
    SchemeRow{subdivide::Scheme::midpoint, "midpoint", "Midpoint (shape stays)", "中点（形状は不変）"},
    SchemeRow{subdivide::Scheme::sqrt3, "sqrt3", "sqrt(3) (triangles)", "√3（三角形）"},
};

// By which most of the faces stay of the kind that they are: loop cuts polygons first.
std::string scheme_for(const Mesh& mesh) {
  const std::size_t polygons = polygons_of_mesh(mesh).size();
  return 2 * polygons > mesh.live().faces ? "catmull_clark" : "loop";
}

subdivide::Options options_of(const ParameterValues& values) {
  subdivide::Options options;
  for (const SchemeRow& row : schemes)
    if (row.id == values.choice("scheme")) options.scheme = row.scheme;
  options.steps = values.count("steps");
  if (values.has("crease_angle")) options.crease_angle_rad = values.angle_rad("crease_angle");
  if (values.has("sharp")) options.sharp = values.elements("sharp");
  if (values.has("sharp_steps")) options.sharp_steps = values.number("sharp_steps");
  options.to_limit = values.flag("limit");
  return options;
}

std::optional<Text> fault_of_sharp(const Mesh& mesh, const subdivide::Options& options) {
  for (const Element& e : options.sharp)
    if (e.kind == Element::Kind::face)
      return Text{name_of(mesh, e) + " is a face; sharp takes edges and vertices",
                  name_of(mesh, e) + " は面です（sharp には稜線と頂点を指定します）"};
  return std::nullopt;
}

AlgorithmResult subdivide_mesh(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const std::size_t before = edit.mesh().live().faces;
  if (edit.mesh().live().edges == 0)
    return {.refused = Text{"there is no face and no edge to divide", "分割する面も稜線もありません"}};
  AlgorithmResult result;
  subdivide::Options options = options_of(input.values);
  if ((result.fault = fault_of_sharp(edit.mesh(), options))) return result;
  Descent descent = edit.new_descent();
  subdivide::Subdivided made = subdivide::subdivided(edit.mesh(), options, progress, &descent);
  if (made.is_cancelled) return result;
  if ((result.fault = std::move(made.fault))) return result;
  result.goal_report.emplace();
  result.changed = std::max<std::size_t>(made.columns.live.faces, 1);
  const std::string count = std::to_string(made.columns.live.faces);
  result.text = count_text(before, "One face became " + count, "# faces became " + count,
                           "面 # 個が " + count + " 個になりました") +
                cut_text(made.cut_faces);
  if (made.seams > 0)
    result.text += count_text(made.seams, "; one edge where the texture is torn stayed a crease",
                              "; # edges where the texture is torn stayed creases",
                              "（テクスチャの継ぎ目の稜線 # 本は折り目のまま）");
  result.text += Text{".", "。"};
  if (options.sharp_steps && options.sharp.empty() && !options.crease_angle_rad)
    result.text +=
        Text{" No edges are named that would be sharp for some steps.", "回数だけ鋭くする稜線は指定されていません。"};
  result.has_normals = options.to_limit && options.scheme != subdivide::Scheme::midpoint;
  edit.replace(std::move(made.columns), descent);
  return result;
}

}  // namespace

std::vector<AlgorithmRow> subdivision_rows() {
  const std::vector<ParameterRow> parameters{
      parameter_row(
          {"scheme", "Scheme", "方式",
           "what divides a face, and where vertices come to; Loop and sqrt(3) cut polygons into "
           "triangles first, all cut faces with rings",
           "面の分け方と頂点の位置。Loop と √3 は多角形を、どの方式もリングのある面を先に三角形に分割する"},
          {.kind = ParameterKind::choice, .initial = "loop", .choices = choices_of(schemes), .proposed = scheme_for}),
      parameter_row(
          {"steps", "Steps", "回数", "how often; each makes about four times as many faces, sqrt(3) three times",
           "繰り返す回数。一回で面は約 4 倍、√3 では 3 倍になる"},
          {.kind = ParameterKind::count, .initial = "1", .smallest = 1, .largest = 16}),
      parameter_row({"limit", "Limit", "極限位置",
                     "puts the vertices where ever more steps would bring them, with the normals there",
                     "無限に繰り返したときの位置に頂点を置き、法線も付ける"},
                    {.kind = ParameterKind::flag, .initial = "off"}),
      parameter_row(
          {"crease_angle", "Crease angle", "折り目の角度", "edges whose faces bend by at least this stay sharp",
           "両側の面がこの角度以上に曲がる稜線を折り目として保つ"},
          {.kind = ParameterKind::angle}),
      parameter_row({"sharp", "Sharp", "折り目と角", "edges that stay sharp, and vertices that stay where they are",
                     "折り目にする稜線と、動かさない頂点"},
                    {.kind = ParameterKind::elements}),
      parameter_row({"sharp_steps", "Sharp for", "鋭さ",
                     "such edges are sharp in so many steps and smooth then; else they stay sharp",
                     "折り目をこの回数だけ鋭く保ち、その後は滑らかにする（省くと常に鋭い）"},
                    {.kind = ParameterKind::number, .smallest = 0, .unit_en = "steps", .unit_ja = "回"}),
  };
  return {algorithm_row({"subdivide", "Subdivide", "細分割曲面",
                         "divides all faces and smooths the surface, but for its boundary curves, creases and corners",
                         "すべての面を分割し、境界・折り目・角を保ちながら曲面を滑らかにする"},
                        {.parameters = parameters, .run = subdivide_mesh, .lineage = Lineage::told, .has_goal = true})};
}

}  // namespace ryosen
