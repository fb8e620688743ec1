// What `hull` prints.
#pragma once

#include "app/cli/contract/shape.h"

namespace ryosen::cli {

inline constexpr JsonKey hull_figure_keys[] = {
    {"dimension", "integer", "Of what the points span: 3 a solid, 2 a polygon, 1 a segment, 0 a point, -1 no point.",
     "点が張る次元：3 立体、2 多角形、1 線分、0 点、-1 点なし。"},
    {"vertices", "integer", "How many points are extreme.", "端点（凸包の頂点）の数。"},
    {"facets", "integer", "How many facets there are, those in one plane united.",
     "面の数（同一平面の面は一枚とする）。"},
    {"volume", "number or null", "What the hull encloses; null where it is beyond the largest number.",
     "体積。表せる最大の数を超えるとき null。"},
    {"area", "number or null",
     "Of all facets, of a polygon that of one side; null where it is beyond the largest number.",
     "面積の和（多角形では片面）。表せる最大の数を超えるとき null。"},
    {"used", "integer", "How many of the points are finite.", "有限な点の数。"},
    {"points", "integer", "How many points were read.", "読み込んだ点の数。"},
    {"facet_list", "array of array of integer",
     "With -v: each facet by the numbers of its points from the lowest, counter-clockwise seen from outside, in "
     "lexicographic order; else absent.",
     "-v のとき、各面の点の番号（最小から、外から見て反時計回り、辞書順）。それ以外はない。", optional()},
    {"extreme", "array of integer", "With -v: the numbers of the extreme points, ascending; else absent.",
     "-v のとき、端点の番号（昇順）。それ以外はない。", optional()},
};

// Of each hull by --measure; with --per-component not of all together.
inline constexpr JsonKey hull_extent_keys[] = {
    {"diameter", "number or null",
     "By --measure: how far the farthest two points are apart; null where it is beyond the largest number.",
     "--measure のとき、最も遠い 2 点の距離。表せる最大の数を超えるとき null。", optional()},
    {"farthest", "array of integer", "By --measure: their numbers, ascending; none below dimension 1.",
     "--measure のとき、その 2 点の番号（昇順）。次元 1 未満では空。", optional()},
    {"width", "number or null",
     "By --measure: the least distance of parallel planes, of a polygon of lines, with the hull between them; null "
     "where "
     "it is beyond the largest number.",
     "--measure のとき、凸包を挟む平行な 2 平面（多角形では 2 直線）の最小の距離。表せる最大の数を超えるとき null。",
     optional()},
    {"between", "array of array of integer",
     "By --measure: what lies on these, by numbers of points: a facet and a point, or two edges; of a polygon a side "
     "and "
     "a point; none below dimension 2.",
     "--measure のとき、その上にあるもの（点の番号）：面と点、または 2 本の稜線。多角形では稜線と点。次元 2 "
     "未満では空。",
     optional()},
};

inline constexpr auto hull_component_keys = joined(hull_figure_keys, hull_extent_keys);
inline constexpr Shape hull_component_shape{"hull_component", "The hull of a connected component.", "連結成分の凸包。",
                                            hull_component_keys};

inline constexpr JsonKey hull_run_keys[] = {
    {"file", "string", "The input, as it was named.", "指定されたとおりの入力。"},
    {"output", "string or null", "The file that was written; null where nothing was.",
     "書き出したファイル。なければ null。"},
    {"status", "string", "ok; warnings where there is a warning; error where it was refused or not written.",
     "ok。警告があれば warnings、拒否または書き出せなければ error。", words("ok warnings error")},
};
inline constexpr JsonKey hull_end_keys[] = {
    {"components", "array of object",
     "With --per-component: the hull of each, by the lowest number of its points; the figures above are sums then, and "
     "the dimension is the largest. Else absent.",
     "--per-component のとき、連結成分ごとの凸包（最小の点の番号順）。上の数はその和、次元はその最大。それ以外はない。",
     optional(objects(hull_component_shape))},
    {"messages", "array of object", "What reading had to say, and what the output loses; or why it was not written.",
     "読み込み時のメッセージと出力で失われるもの、または書き出せなかった理由。", objects(message_shape)},
    {"en", "string", "What the hull is, in English.", "凸包の説明（英語）。"},
    {"ja", "string", "What the hull is, in Japanese.", "凸包の説明（日本語）。"},
};
inline constexpr auto hull_keys = joined(hull_run_keys, hull_figure_keys, hull_extent_keys, hull_end_keys);
inline constexpr Shape hull_shape{"hull", "One line.", "一行。", hull_keys};

inline constexpr Contract hull_contract{
    .lines = {&hull_shape}, .exits = {ExitCode::input_missing, ExitCode::input_malformed, ExitCode::refused}};

}  // namespace ryosen::cli
