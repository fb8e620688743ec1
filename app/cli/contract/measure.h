// What `measure` prints.
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

}  // namespace ryosen::cli
