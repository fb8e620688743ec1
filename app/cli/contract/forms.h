// What `forms` prints.
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

}  // namespace ryosen::cli
