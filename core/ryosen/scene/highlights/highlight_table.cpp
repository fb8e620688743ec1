#include "ryosen/scene/highlights/highlight_table.h"

#include <algorithm>
#include <array>

#include "ryosen/base/open_table.h"
#include "ryosen/scene/highlights/feature_edges.h"

namespace ryosen {

namespace {

using Kind = ProblemKind;

constexpr std::array built_in{
    HighlightRow{.id = "boundary",
                 .name_en = "Boundary",
                 .name_ja = "境界",
                 .legend_en = "Edges with a face on one side only.",
                 .legend_ja = "片側にしか面のない稜線。",
                 .kinds = {Kind::boundary_loop},
                 .looks = {0x6CC2FF, 0x70C2FA, LineStyle::solid, 3, PointShape::ring, 4.5f}},
    HighlightRow{.id = "nonmanifold",
                 .name_en = "Non-manifold",
                 .name_ja = "非多様体",
                 .legend_en = "Edges with three or more faces, and vertices at one or between several fans of faces.",
                 .legend_ja = "三つ以上の面が接する稜線と、その端または複数の面の扇が集まる頂点。",
                 .kinds = {Kind::nonmanifold_edge, Kind::nonmanifold_vertex},
                 .looks = {0xB2222B, 0x95141B, LineStyle::dash_dot, 4, PointShape::diamond, 6},
                 .tier = 2},
    HighlightRow{.id = "misoriented",
                 .name_en = "Misoriented",
                 .name_ja = "向きの不一致",
                 .legend_en = "Edges whose two faces are turned against each other.",
                 .legend_ja = "両側の面の向きが揃っていない稜線。",
                 .kinds = {Kind::misoriented_edge},
                 .looks = {0x2B6499, 0x25608A, LineStyle::dashed, 3.5f, PointShape::ring, 5},
                 .tier = 3},
    HighlightRow{.id = "degenerate",
                 .name_en = "Degenerate",
                 .name_ja = "面積ゼロの面",
                 .legend_en = "Faces whose corners lie on a line.",
                 .legend_ja = "角が一直線に並ぶ面。",
                 .kinds = {Kind::degenerate_area},
                 .looks = {0x9481B6, 0xB860CE, LineStyle::dotted, 4, PointShape::cross, 6},
                 .tint = FaceTint{FacePattern::horizontal, 0.8f},
                 .tier = 2},
    HighlightRow{.id = "duplicate",
                 .name_en = "Duplicate",
                 .name_ja = "重複面",
                 .legend_en = "Faces with the same vertices as an earlier one.",
                 .legend_ja = "前の面と同じ頂点を持つ面。",
                 .kinds = {Kind::duplicate_face},
                 .looks = {0xEDEDED, 0x666666, LineStyle::dash_dot, 2.5f, PointShape::square, 4.5f},
                 .tint = FaceTint{FacePattern::chessboard, 0.8f},
                 .tier = 4},
    HighlightRow{.id = "intersecting",
                 .name_en = "Intersecting",
                 .name_ja = "自己交差",
                 .legend_en = "Faces that meet others elsewhere than in common vertices and edges.",
                 .legend_ja = "共有する頂点・稜線以外で他の面と交わる面。",
                 .kinds = {Kind::self_intersection},
                 .looks = {0xFF6B8B, 0xB0003A, LineStyle::solid, 1.6f, PointShape::cross, 5},
                 .tint = FaceTint{FacePattern::diagonal, 0.7f},
                 .tier = 2},
    HighlightRow{.id = "hanging",
                 .name_en = "Hanging pairs",
                 .name_ja = "背中合わせ",
                 .legend_en = "Pairs of triangles that lie back to back and hang on one edge at most.",
                 .legend_ja = "背中合わせに重なり、高々一本の稜線でつながる三角形の組。",
                 .kinds = {Kind::hanging_pair},
                 .looks = {0xA154EF, 0x8F1151, LineStyle::dotted, 3, PointShape::diamond, 5},
                 .tier = 4},
    HighlightRow{.id = "isolated",
                 .name_en = "Isolated",
                 .name_ja = "孤立頂点",
                 .legend_en = "Vertices that stand alone.",
                 .legend_ja = "どこにもつながっていない頂点。",
                 .kinds = {Kind::isolated_vertex},
                 .looks = {0xFFFFFF, 0x000000, LineStyle::solid, 2, PointShape::ring, 5}},
    HighlightRow{.id = "wires",
                 .name_en = "Wires",
                 .name_ja = "面のない稜線",
                 .legend_en = "Edges without a face.",
                 .legend_ja = "どちら側にも面のない稜線。",
                 .kinds = {Kind::wire},
                 .looks = {0xE4E8EE, 0x303846, LineStyle::solid, 1.8f, PointShape::disc, 3.5f}},
    HighlightRow{.id = "rings",
                 .name_en = "Rings",
                 .name_ja = "面の穴",
                 .legend_en = "Faces with rings, inner loops.",
                 .legend_ja = "内側のループ（穴）を持つ面。",
                 .kinds = {Kind::ring},
                 .looks = {0x8FA8C8, 0x55708F, LineStyle::dashed, 2, PointShape::disc, 3.5f},
                 .tier = 4},
    HighlightRow{.id = "creases",
                 .name_en = "Creases",
                 .name_ja = "折り目",
                 .legend_en = "Edges at which two faces bend by more than 30 degrees.",
                 .legend_ja = "二つの面が 30 度を超えて折れ曲がる稜線。",
                 .edge = is_crease,
                 .reads_whole_faces = true,
                 .looks = {0xFFD08A, 0x6B3D0C, LineStyle::solid, 2.2f, PointShape::square, 4},
                 .tier = 1},
    HighlightRow{.id = "seams",
                 .name_en = "Seams",
                 .name_ja = "継ぎ目",
                 .legend_en = "Edges at which the texture coordinates or normals of two faces differ.",
                 .legend_ja = "両側の面でテクスチャ座標または法線が異なる稜線。",
                 .edge = is_seam_edge,
                 .reads_values = true,
                 .looks = {0xB3E05A, 0x4B7A00, LineStyle::dashed, 2.8f, PointShape::square, 4},
                 .tier = 3},
};

constinit OpenTable<HighlightRow, most_highlights> table(built_in);

}  // namespace

std::span<const HighlightRow> highlight_table() { return table.rows(); }
std::size_t drawing_rank(const HighlightRow& row) {
  const std::span<const HighlightRow> rows = highlight_table();
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](const HighlightRow& other) {
    return other.tier != row.tier ? other.tier < row.tier : &other > &row;
  }));
}

bool HighlightRow::is_on_request() const {
  const std::span<const ProblemRow> problems = problem_table();
  return std::any_of(problems.begin(), problems.end(), [&](const ProblemRow& problem) {
    return problem.is_on_request() && kinds.contains(problem.kind);
  });
}

const HighlightRow* find_highlight(std::string_view id) { return table.find(id); }

ScopedHighlight::ScopedHighlight(const HighlightRow& row) { table.add(row); }
ScopedHighlight::~ScopedHighlight() { table.remove_last(); }

Mark mark_of(ProblemKind kind) {
  return {static_cast<std::uint16_t>(own_marks + static_cast<std::size_t>(kind)), row_of(kind).sort()};
}

Mark own_mark(const HighlightRow& row, Element::Kind sort) {
  const auto number = static_cast<std::size_t>(&row - highlight_table().data());
  return {static_cast<std::uint16_t>(number * enum_count<Element::Kind> + static_cast<std::size_t>(sort)), sort};
}

}  // namespace ryosen
