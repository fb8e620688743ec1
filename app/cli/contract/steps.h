// What `steps` prints.
#pragma once

#include "app/cli/contract/shape.h"

namespace ryosen::cli {

inline constexpr JsonKey mark_keys[] = {
    {"role", "string", "The part that the element takes.", "要素の役割。", ids_of(Ids::roles)},
    {"element", "string", "The element, by its slot; it may be one that the step deletes.",
     "要素（スロット名）。その手順で消えたものもある。"},
};
inline constexpr Shape mark_shape{"mark", "An element that takes part in a step.", "手順に関わる要素。", mark_keys};

inline constexpr JsonKey row_keys[] = {
    {"table", "string", "The table.", "表。"},
    {"row", "string", "The row of the table.", "表の行。"},
    {"field", "string", "The field of the row.", "行の項目。"},
    {"old", "string or null", "What stood there; null for nothing, or where the row was not there.",
     "前の値。値または行がなかったとき null。"},
    {"new", "string or null", "What stands there now; the same where it is only read.",
     "後の値。読むだけのときは前と同じ。"},
};
inline constexpr Shape row_shape{"step_row", "A cell of a table that a step writes or reads.",
                                 "手順が書く、または読む表の項目。", row_keys};

inline constexpr JsonKey step_source_keys[] = {
    {"text", "string", "The number of the source text.", "テキストの番号。"},
    {"listing", "object", "The listing, section or figure.", "リスト、節、または図。", objects(sentence_shape)},
    {"line", "integer or null", "The line of the listing as printed, blank lines included, from 1; null for no line.",
     "印刷されたリストの行（空行も数え、1 から）。行でないとき null。"},
};
inline constexpr Shape step_source_shape{"step_source", "Where a source text says what a step does.",
                                         "手順を述べているテキストの箇所。", step_source_keys};

inline constexpr JsonKey delta_keys[] = {
    {"V", "integer", "By how many vertices.", "頂点数の増減。"},
    {"E", "integer", "By how many edges.", "稜線数の増減。"},
    {"F", "integer", "By how many faces.", "面数の増減。"},
    {"B", "integer or null", "By how many boundary loops; null where some boundary edges close to no loop.",
     "境界ループの数の増減。閉じない境界があるとき null。"},
    {"W", "integer", "By how many cycles along wires.", "稜線だけの輪の数の増減。"},
    {"I", "integer", "By how many isolated points.", "稜線のない点の数の増減。"},
    {"H", "integer", "By how many rings.", "リング数の増減。"},
    {"S", "integer", "By how many parts.", "部分の数の増減。"},
    {"G", "integer or null", "By how many handles; null where there is no genus.", "種数の増減。種数がないとき null。"},
};
inline constexpr Shape delta_shape{"delta", "By how much the terms of the Euler-Poincare sum change.",
                                   "オイラー・ポアンカレの式の項の増減。", delta_keys};

inline constexpr JsonKey step_keys[] = {
    {"at", "integer", "Which step it is, from 1.", "何番目の手順か（1 から）。"},
    {"of", "integer", "How many there are.", "手順の総数。"},
    {"caption", "object", "What is done.", "何をするか。", objects(sentence_shape)},
    {"marks", "array of object", "The elements that take part.", "関わる要素。", objects(mark_shape)},
    {"rows", "array of object", "What changes, or is read, in tables.", "表で変わる、または読まれる項目。",
     objects(row_shape)},
    {"count", "integer",
     "Of what has a number that grows with the steps, as the faces made by a hull: that number; else absent.",
     "手順とともに増える数（凸包で作った面の数など）。なければ省く。", optional()},
    {"source", "object or null", "Where the source texts say so; null where none does.",
     "テキストでの箇所。どこにもないとき null。", objects(step_source_shape)},
    {"delta", "object", "By how much the step changes the sum; absent where it does not edit the mesh.",
     "和の項の増減。メッシュを変えないときはない。", optional(objects(delta_shape))},
};
inline constexpr Shape step_shape{"played_step", "One line per step.", "手順ごとに一行。", step_keys};

inline constexpr Contract steps_contract{.lines = {&step_shape},
                                         .exits = {ExitCode::input_missing, ExitCode::input_malformed, ExitCode::usage,
                                                   ExitCode::refused, ExitCode::no_backend, ExitCode::found_problems}};

}  // namespace ryosen::cli
