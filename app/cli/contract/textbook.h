// Keys that `forms`, `steps` and `practice` print.
#pragma once

#include "app/cli/contract/shape.h"

namespace ryosen::cli {

inline constexpr JsonKey form_keys[] = {
    {"form", "string", "The form.", "形状表現。", ids_of(Ids::forms)},
    {"en", "string", "Its name in English.", "英語名。"},
    {"ja", "string", "Its name in Japanese.", "日本語名。"},
    {"source", "object", "Where the source texts describe it.", "テキストでの出典。", objects(sentence_shape)},
    {"suitable", "boolean", "Whether it can hold this mesh.", "このメッシュを持てるか。"},
    {"reason", "object or null", "Why it cannot; null where it can.", "持てない理由。持てるとき null。",
     objects(sentence_shape)},
    {"bytes", "integer or null", "Its memory; null where it cannot hold the mesh.",
     "メモリ量。メッシュを持てないとき null。"},
    {"bytes_per_face", "number or null", "The same per face; null also without faces.",
     "面あたりのメモリ量。面がないときも null。"},
    {"build_ms", "number or null", "Milliseconds to build it; null where it cannot hold the mesh.",
     "構築時間（ミリ秒）。メッシュを持てないとき null。"},
    {"query_ns", "object",
     "Nanoseconds per query by relation; null where the form cannot tell, or the mesh has nothing to ask.",
     "関係ごとの問い合わせ時間（ナノ秒）。答えられない、または問う要素がないとき null。", ids_of(Ids::relations)},
};
inline constexpr Shape form_shape{"form", "A representation of the source texts.", "テキストの形状表現。", form_keys};

inline constexpr JsonKey pairing_keys[] = {
    {"method", "string", "The method.", "方法。", ids_of(Ids::pairings)},
    {"en", "string", "Its name in English.", "英語名。"},
    {"ja", "string", "Its name in Japanese.", "日本語名。"},
    {"faces", "integer", "On how many faces it ran.", "実行した面の数。"},
    {"whole", "boolean", "Whether these are all.", "すべての面か。"},
    {"ms", "number", "Milliseconds it took.", "所要時間（ミリ秒）。"},
};
inline constexpr Shape pairing_shape{"pairing", "A way to pair the halfedges.", "半稜線の対を見つける方法。",
                                     pairing_keys};

inline constexpr JsonKey source_keys[] = {
    {"operation", "string", "The operator of the source texts.", "テキストの操作。", ids_of(Ids::operators)},
    {"place", "string", "Where it was tried.", "試した場所。", words("boundary_edge beside_boundary")},
    {"completed", "boolean", "Whether its code came to its end.", "コードが最後まで進んだか。"},
    {"en", "string", "What happened, in English.", "起きたこと（英語）。"},
    {"ja", "string", "What happened, in Japanese.", "起きたこと（日本語）。"},
};
inline constexpr Shape source_shape{"text", "What the source texts' own code does at a boundary.",
                                    "境界でテキストのコードがすること。", source_keys};

inline constexpr JsonKey forms_keys[] = {
    {"file", "string", "The input, as it was named.", "指定されたとおりの入力。"},
    {"vertices", "integer", "Vertices of the mesh.", "頂点数。"},
    {"edges", "integer", "Edges of the mesh.", "稜線数。"},
    {"faces", "integer", "Faces of the mesh.", "面数。"},
    {"forms", "array of object", "The forms.", "形状表現。", objects(form_shape)},
    {"pairing", "array of object", "The ways to pair the halfedges.", "半稜線の対を見つける方法。",
     objects(pairing_shape)},
    {"texts", "array of object", "What the source texts' own code does at a boundary.",
     "境界でテキストのコードがすること。", objects(source_shape)},
};
inline constexpr Shape forms_shape{"forms", "One line.", "一行。", forms_keys};

inline constexpr JsonKey form_record_keys[] = {
    {"form", "string", "The form.", "形状表現。", ids_of(Ids::forms)},
    {"element", "string", "The element that is asked about, by its slot.", "問われた要素（スロット名）。"},
    {"fields", "object or null",
     "The fields of its record in the form by Ryosen's words: a link as the slot name of an element or null, several "
     "as "
     "an array, a place as an array of numbers; null where the form has no record of it.",
     "その要素のデータ（キーは Ryosen の語）。リンクはスロット名または "
     "null、複数なら配列、座標は数の配列。データがないとき null。"},
    {"none", "object or null", "Why there is no record; null where there is one.", "データがない理由。あるとき null。",
     objects(sentence_shape)},
    {"words", "object", "What the source text calls each field.", "各項目のテキストでの呼び名。"},
    {"stored", "object", "What the form stores in each field: for a link a number, a code below 0, or null; places.",
     "各項目に格納されている値（リンクは番号、負の符号値、または null。座標はそのまま）。"},
};
inline constexpr Shape form_record_shape{"form_record", "With --element: one line per form, and per element of all.",
                                         "--element のとき、形状表現ごと（all では要素ごとにも）一行。",
                                         form_record_keys};

inline constexpr JsonKey growth_point_keys[] = {
    {"faces", "integer", "The number of faces.", "面の数。"},
    {"comparisons", "number", "How much was counted.", "数えた回数。"},
    {"ms", "number", "Milliseconds it took.", "所要時間（ミリ秒）。"},
};
inline constexpr Shape growth_point_shape{"growth_point", "A mesh that was measured on.", "測ったメッシュ。",
                                          growth_point_keys};

inline constexpr JsonKey growth_keys[] = {
    {"of", "string", "What is done.", "測るもの。", words("pairing query collapse")},
    {"id", "string", "By which pairing, on which form, or in which way.",
     "対の探索の方法、形状表現、または削除の方法。"},
    {"relation", "string or null", "The relation that is asked; null where none is.", "問う関係。ないとき null。",
     ids_of(Ids::relations)},
    {"en", "string", "Its name in English.", "英語名。"},
    {"ja", "string", "Its name in Japanese.", "日本語名。"},
    {"counted", "object", "What is counted.", "数えるもの。", objects(sentence_shape)},
    {"points", "array of object", "On meshes of growing size.", "大きくなるメッシュでの値。",
     objects(growth_point_shape)},
    {"slope", "number or null",
     "The power of the number of faces that the count grows with; null of fewer than two that are not 0.",
     "回数が面の数の何乗で増えるか。0 でない値が 2 つないとき null。"},
    {"time_slope", "number or null", "The same of the time.", "時間について同じ値。"},
};
inline constexpr Shape growth_shape{"growth", "With --growth: one line per curve.", "--growth のとき、曲線ごとに一行。",
                                    growth_keys};

inline constexpr Contract forms_contract{.lines = {&forms_shape, &form_record_shape, &growth_shape},
                                         .exits = {ExitCode::input_missing, ExitCode::input_malformed, ExitCode::usage,
                                                   ExitCode::refused, ExitCode::no_backend}};

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

inline constexpr JsonKey practice_keys[] = {
    {"seed", "integer", "What the question was drawn from.", "問題のもとになった数。"},
    {"kind", "string", "What is asked for.", "問題の種類。", words("next twin record legal valence")},
    {"mesh", "string", "The file, or the figure of the source texts that is asked about.",
     "ファイル、またはテキストの図。"},
    {"about", "string", "The element that is asked about, by its slot.", "問われた要素（スロット名）。"},
    {"form", "string or null", "The form whose record is asked about; null in other questions.",
     "問われた形状表現。他の問題では null。", ids_of(Ids::forms)},
    {"field", "string or null", "The field of the record; null in other questions.",
     "問われた項目。他の問題では null。"},
    {"command", "string or null", "The command that is judged; null in other questions.",
     "可否を問うコマンド。他の問題では null。"},
    {"question", "object", "The question.", "問題文。", objects(sentence_shape)},
    {"answers", "array of string", "The words that are right, the plainest first.",
     "正解となる語。最も簡単なものが先頭。"},
    {"why", "object", "Why.", "理由。", objects(sentence_shape)},
    {"witnesses", "array of string", "The elements that show it, by their slots.", "根拠となる要素（スロット名）。"},
    {"given", "string or null", "What --answer said; null without it.", "--answer の答え。省いたとき null。"},
    {"right", "boolean or null", "Whether that is right; null without it.", "正しいか。答えがないとき null。"},
};
inline constexpr Shape practice_shape{"practice", "One line for each question.", "問題ごとに一行。", practice_keys};

inline constexpr Contract practice_contract{
    .lines = {&practice_shape},
    .exits = {ExitCode::found_problems, ExitCode::input_missing, ExitCode::input_malformed, ExitCode::refused}};

}  // namespace ryosen::cli
