// Keys that `measure` and `distance` print.
#pragma once

#include "app/cli/contract/shape.h"

namespace ryosen::cli {

inline constexpr JsonKey bar_keys[] = {
    {"low", "number", "From this value on.", "この値から。"},
    {"high", "number", "Up to this value, which the last bar has too.", "この値まで（最後の区間は上端を含む）。"},
    {"count", "integer", "How many elements lie there.", "その区間の要素数。"},
};
inline constexpr Shape bar_shape{"bar", "A bar of a histogram.", "ヒストグラムの一区間。", bar_keys};

inline constexpr JsonKey map_keys[] = {
    {"file", "string", "The input, as it was named.", "指定されたとおりの入力。"},
    {"map", "string", "What was measured of each element.", "各要素について測ったもの。", ids_of(Ids::maps)},
    {"en", "string", "Its name in English.", "英語名。"},
    {"ja", "string", "Its name in Japanese.", "日本語名。"},
    {"sort", "string", "Of which elements.", "対象の要素。", words("vertex edge face")},
    {"unit", "string", "The unit: lengths are in that of the file.", "単位（長さはファイルの単位）。",
     words("none length area degrees per_length per_area")},
    {"count", "integer", "How many elements have a value.", "値を持つ要素の数。"},
    {"lowest", "number or null", "The lowest value; null without values.", "最小値。値がないとき null。"},
    {"highest", "number or null", "The highest value; null without values.", "最大値。値がないとき null。"},
    {"mean", "number or null", "The mean; null without values.", "平均。値がないとき null。"},
    {"deviation", "number or null", "The standard deviation; null without values.", "標準偏差。値がないとき null。"},
    {"percentile_5", "number or null", "Five percent of the values lie below; null without values.",
     "5 パーセンタイル。値がないとき null。"},
    {"quartile_1", "number or null", "A quarter of the values lies below; null without values.",
     "第一四分位数。値がないとき null。"},
    {"median", "number or null", "Half of the values lies below; null without values.", "中央値。値がないとき null。"},
    {"quartile_3", "number or null", "Three quarters of the values lie below; null without values.",
     "第三四分位数。値がないとき null。"},
    {"percentile_95", "number or null", "Five percent of the values lie above; null without values.",
     "95 パーセンタイル。値がないとき null。"},
    {"lowest_at", "string or null", "The first element with the lowest value; null without values.",
     "最小値を持つ最初の要素。値がないとき null。"},
    {"highest_at", "string or null", "The first element with the highest value; null without values.",
     "最大値を持つ最初の要素。値がないとき null。"},
    {"histogram", "array of object or null", "Bars of equal width; null without --bars, or without values.",
     "等幅の区間。--bars がないとき、値がないとき null。", objects(bar_shape)},
};
inline constexpr Shape map_shape{"map", "Without names: one line per map.", "名前がないとき、項目ごとに一行。",
                                 map_keys};

inline constexpr JsonKey measured_keys[] = {
    {"en", "string", "What it is, in English.", "内容（英語）。"},
    {"ja", "string", "What it is, in Japanese.", "内容（日本語）。"},
    {"unit", "string", "The unit: lengths are in that of the file.", "単位（長さはファイルの単位）。",
     words("none length area degrees")},
    {"value", "number", "The number.", "値。"},
};
inline constexpr Shape measured_shape{"measured", "A number that was measured.", "測った値。", measured_keys};

inline constexpr JsonKey measurement_keys[] = {
    {"file", "string", "The input, as it was named.", "指定されたとおりの入力。"},
    {"elements", "array of string", "What was measured, as it was named.", "測った要素（指定された名前）。"},
    {"values", "array of object", "The numbers.", "値。", objects(measured_shape)},
};
inline constexpr Shape measurement_shape{"measurement", "With names: one line.", "名前があるとき、一行。",
                                         measurement_keys};

inline constexpr Contract measure_contract{
    .lines = {&map_shape, &measurement_shape},
    .exits = {ExitCode::input_missing, ExitCode::input_malformed, ExitCode::refused}};

// The figures of one direction, or of both.
inline constexpr JsonKey distance_figure_keys[] = {
    {"rms", "number or null",
     "The root of the mean square distance over the area, in the unit of the files; null where it is too large for a "
     "number.",
     "距離の二乗平均平方根（面積についての平均、ファイルの単位）。数に収まらないとき null。"},
    {"rms_rel", "number or null",
     "The same as a fraction of the diagonal; null where that is 0 or either is too large for a number.",
     "同、対角線に対する比。対角線が 0 のとき、数に収まらないとき null。"},
    {"mean", "number or null", "The mean distance over the area; null where it is too large for a number.",
     "距離の平均（面積についての平均）。数に収まらないとき null。"},
    {"mean_rel", "number or null",
     "The same as a fraction of the diagonal; null where that is 0 or either is too large for a number.",
     "同、対角線に対する比。対角線が 0 のとき、数に収まらないとき null。"},
    {"hausdorff", "number or null",
     "An upper bound of the largest distance of all points of the surfaces; null where it is too large for a number.",
     "曲面のすべての点についての最大距離の上界。数に収まらないとき null。"},
    {"hausdorff_rel", "number or null",
     "The same as a fraction of the diagonal; null where that is 0 or either is too large for a number.",
     "同、対角線に対する比。対角線が 0 のとき、数に収まらないとき null。"},
    {"hausdorff_gap", "number or null",
     "How much the bound is at most above the largest distance; null where it is too large for a number.",
     "上界が最大距離を超えうる幅。数に収まらないとき null。"},
    {"hausdorff_gap_rel", "number or null",
     "The same as a fraction of the diagonal; null where that is 0 or either is too large for a number.",
     "同、対角線に対する比。対角線が 0 のとき、数に収まらないとき null。"},
};

inline constexpr JsonKey direction_place_keys[] = {
    {"from", "array of number", "The point with the largest distance that was found, x y z.",
     "最大の距離が見つかった点 x y z。"},
    {"to", "array of number", "The point of the other surface that is nearest to it.",
     "それに最も近い相手の曲面の点。"},
    {"face", "string", "The face that it is on.", "その点がある面。"},
    {"samples", "integer", "How many samples the means are made of.", "平均に用いた標本の数。"},
    {"area", "number or null", "The area that was measured; null where it is too large for a number.",
     "測った面積。数に収まらないとき null。"},
    {"faces", "integer", "How many faces were measured.", "測った面の数。"},
    {"left_out", "integer", "How many faces were not, since they were set aside or have a corner that is not finite.",
     "隔離されたか座標が有限でないため、測らなかった面の数。"},
};
inline constexpr auto direction_keys = joined(distance_figure_keys, direction_place_keys);
inline constexpr Shape direction_shape{"direction", "The points of one surface from the other.",
                                       "一方の曲面の点から他方への距離。", direction_keys};

inline constexpr JsonKey distance_file_keys[] = {
    {"file", "string", "The first input, as it was named.", "一つ目の入力（指定された名前）。"},
    {"other", "string", "The second input, as it was named.", "二つ目の入力（指定された名前）。"},
    {"status", "string", "ok; warnings where there are messages.", "ok。メッセージがあれば warnings。",
     words("ok warnings")},
    {"diagonal", "number or null",
     "The diagonal of the box around the faces of the first input; null where it is too large for a number.",
     "一つ目の入力の面を囲む直方体の対角線。数に収まらないとき null。"},
};
inline constexpr JsonKey distance_end_keys[] = {
    {"forward", "object", "From the first to the second.", "一つ目から二つ目へ。", objects(direction_shape)},
    {"backward", "object", "From the second to the first.", "二つ目から一つ目へ。", objects(direction_shape)},
    {"messages", "array of object", "What reading had to say, also about faces that are left out.",
     "読み込み時のメッセージ（測らない面の理由を含む）。", objects(message_shape)},
};
inline constexpr auto distance_keys = joined(distance_file_keys, distance_figure_keys, distance_end_keys);
inline constexpr Shape distance_shape{
    "distance", "One line; mean and rms of both directions over their areas together, the larger hausdorff.",
    "一行。平均は両方向の面積を合わせたもの、最大距離は大きい方。", distance_keys};

inline constexpr Contract distance_contract{
    .lines = {&distance_shape}, .exits = {ExitCode::input_missing, ExitCode::input_malformed, ExitCode::refused}};

}  // namespace ryosen::cli
