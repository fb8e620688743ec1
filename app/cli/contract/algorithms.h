// What `repair` and the subcommands of the algorithms print.
#pragma once

#include "app/cli/contract/measure.h"
#include "app/cli/contract/shape.h"

namespace ryosen::cli {

inline constexpr JsonKey left_keys[] = {
    {"elements", "array of string", "One for each place, where it is still there.",
     "箇所ごとに一つの要素名（残っているもの）。"},
    {"en", "string", "The reason, in English.", "理由（英語）。"},
    {"ja", "string", "The reason, in Japanese.", "理由（日本語）。"},
};
inline constexpr Shape left_shape{"left_for_reason", "What was left for one reason.", "一つの理由で残したもの。",
                                  left_keys};

// What one algorithm did.
inline constexpr JsonKey result_keys[] = {
    {"parameters", "object", "By parameter the value that was used; null where none was given.",
     "パラメーターごとの値。指定がなければ null。"},
    {"changed", "integer", "How many places were changed.", "変更した箇所の数。"},
    {"left", "integer", "How many were found and could not be changed.", "見つけたが変更できなかった箇所の数。"},
    {"left_for", "array of object", "Those of them for which a reason is known.", "そのうち理由の分かるもの。",
     objects(left_shape)},
    {"crossings", "integer or null", "How many pairs of faces meet now that did not; null where it is not counted.",
     "新たに交わるようになった面の組の数。数えないとき null。"},
    {"solves", "array of string", "The kinds of problems it is for.", "対象とする問題の種類。", ids_of(Ids::problems)},
    {"en", "string", "What was done, in English.", "したこと（英語）。"},
    {"ja", "string", "What was done, in Japanese.", "したこと（日本語）。"},
};

inline constexpr JsonKey repair_id_keys[] = {
    {"kind", "string", "The repair.", "修復。", ids_of(Ids::repairs)},
    {"number", "number or null", "The first of its parameters; null where it takes none or none was given.",
     "最初のパラメーターの数値。取らない、または指定がないとき null。"},
};
inline constexpr auto repair_step_keys = joined(repair_id_keys, result_keys);
inline constexpr Shape repair_step_shape{"repair_step", "One repair.", "一つの修復。", repair_step_keys};

// What a run of one or several began with and came to.
inline constexpr JsonKey run_keys[] = {
    {"file", "string or null", "The input, as it was named; null where it began with an empty mesh.",
     "指定されたとおりの入力。空のメッシュから始めたとき null。"},
    {"output", "string or null", "The file that was written; null where nothing was.",
     "書き出したファイル。なければ null。"},
    {"status", "string", "ok; warnings where problems are left or something is lost; error where it was not written.",
     "ok。問題が残るか失われるものがあれば warnings、書き出せなければ error。", words("ok warnings error")},
};
inline constexpr JsonKey outcome_keys[] = {
    {"vertices", "integer", "As in check, at the end.", "実行後の頂点数（check と同じ）。"},
    {"edges", "integer", "As in check, at the end.", "実行後の稜線数（check と同じ）。"},
    {"faces", "integer", "As in check, at the end.", "実行後の面数（check と同じ）。"},
    {"hash", "string", "As in check, at the end.", "実行後のハッシュ値（check と同じ）。"},
    {"problems", "array of object", "What is left, named as in the output.", "残った問題（出力での名前）。",
     objects(problem_shape)},
    {"messages", "array of object", "What reading had to say, and what the output loses; or why it was not written.",
     "読み込み時のメッセージと出力で失われるもの、または書き出せなかった理由。", objects(message_shape)},
};

inline constexpr JsonKey kind_count_keys[] = {
    {"kind", "string", "The kind of finding.", "問題の種類。", ids_of(Ids::problems)},
    {"before", "integer", "How many there were.", "修復前の数。"},
    {"after", "integer", "How many there are now.", "修復後の数。"},
};
inline constexpr Shape kind_count_shape{"kind_count", "The findings of one kind.", "一種類の問題の数。",
                                        kind_count_keys};

inline constexpr JsonKey repairs_keys[] = {
    {"repairs", "array of object", "The repairs in the order in which they were done, each over all rounds.",
     "行った修復（順に、全巡の合計）。", objects(repair_step_shape)},
    {"rounds", "integer",
     "How often the repairs were done and changed something; a round that was undone does not count.",
     "修復を繰り返して変更があった回数。元に戻した回は数えない。"},
    {"boundary_edges", "object",
     "The number of edges with one face, before and after: a round that lowers no problem must lower it.",
     "面が一枚だけの稜線の数（before、after）。問題が減らない巡回では、これが減ること。"},
    {"findings", "array of object", "Every kind that is looked for unasked, with its number before and after.",
     "既定で調べるすべての種類について、修復前後の数。", objects(kind_count_shape)},
};
inline constexpr auto repair_keys = joined(run_keys, repairs_keys, outcome_keys);
inline constexpr Shape repair_shape{"repair", "One line.", "一行。", repair_keys};

inline constexpr JsonKey algorithm_id_keys[] = {
    {"algorithm", "string", "The algorithm.", "アルゴリズム。", ids_of(Ids::algorithms)},
};
inline constexpr auto algorithm_keys = joined(run_keys, algorithm_id_keys, result_keys, outcome_keys);
inline constexpr Shape algorithm_shape{"algorithm", "One line.", "一行。", algorithm_keys};

inline constexpr Shape result_distance_shape{"result_distance", "Both directions together, as distance prints them.",
                                             "両方向を合わせた距離（distance と同じ）。", distance_figure_keys};

// The keys of an algorithm with a goal.
inline constexpr JsonKey goal_keys[] = {
    {"faces_before", "integer", "The faces of the input, as in check.", "入力の面数（check と同じ）。"},
    {"faces_after", "integer", "The same as faces.", "faces と同じ。"},
    {"stopped", "string",
     "Why it ended: the goal was reached, the error or the distance does not allow more, nothing more can be done, "
     "more would lose the shape, or it was cancelled.",
     "終了の理由：目標に達した、許容誤差に達した、距離の上限に達した、それ以上できない、それ以上は形が崩れる、"
     "中止された。",
     words("goal error distance blocked shape cancelled")},
    {"remaining", "object", "By rule the number of edges that it holds as the first; they add up to edges.",
     "最初に当てはまる規則ごとの稜線の数。合計は edges。", ids_of(Ids::edge_rules)},
    {"error_max", "number or null",
     "The largest error of a vertex, in units: the root of the mean square of its distances from planes, no bound for "
     "points of the surface; null where it is not measured.",
     "頂点の誤差の最大値（座標の単位）。平面との距離の二乗平均平方根で、面上の点の上限ではない。測らないとき null。"},
    {"distance", "object or null",
     "How far the result is from the input; null without --distance, and where there is nothing to measure.",
     "結果の入力からの距離。--distance がないとき、測るものがないとき null。", objects(result_distance_shape)},
};
inline constexpr auto goal_run_keys = joined(run_keys, algorithm_id_keys, result_keys, goal_keys, outcome_keys);
inline constexpr Shape goal_shape{"algorithm_with_goal", "One line, of an algorithm with a goal.",
                                  "一行（目標のあるアルゴリズム）。", goal_run_keys};

inline constexpr Contract repair_contract{
    .lines = {&repair_shape}, .exits = {ExitCode::found_problems, ExitCode::input_missing, ExitCode::input_malformed}};
inline constexpr Contract algorithm_contract{.lines = {&algorithm_shape}, .exits = repair_contract.exits};
inline constexpr Contract goal_contract{
    .lines = {&goal_shape},
    .exits = {ExitCode::found_problems, ExitCode::input_missing, ExitCode::input_malformed, ExitCode::refused}};

}  // namespace ryosen::cli
