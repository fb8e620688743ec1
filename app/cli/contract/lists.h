// Keys that `help` (this contract included), `formats`, `keys`, `doctor` and `--version` print, and the window where it
// does not open.
#pragma once

#include "app/cli/contract/shape.h"

namespace ryosen::cli {

inline constexpr JsonKey flag_keys[] = {
    {"flag", "string", "The flag with its dashes.", "フラグ（先頭の - を含む）。"},
    {"value", "string or null", "What stands behind it, in words; null for a switch.",
     "値の書き方。値を取らないとき null。"},
    {"repeatable", "boolean", "Whether it may be given several times.", "繰り返せるか。"},
    {"en", "string", "What it does, in English.", "動作（英語）。"},
    {"ja", "string", "What it does, in Japanese.", "動作（日本語）。"},
};
inline constexpr Shape flag_shape{"flag", "A flag of a command.", "コマンドのフラグ。", flag_keys};

inline constexpr JsonKey usage_keys[] = {
    {"command", "string", "The command.", "コマンド。", ids_of(Ids::subcommands)},
    {"operands", "string", "Its operands, in words.", "引数の書き方。"},
    {"flags", "array of object", "Its flags besides the common ones.", "共通のものを除くフラグ。", objects(flag_shape)},
    {"en", "string", "What it does, in English.", "動作（英語）。"},
    {"ja", "string", "What it does, in Japanese.", "動作（日本語）。"},
};
inline constexpr Shape usage_shape{"usage", "One per command; under COMMAND and --help of that one alone.",
                                   "コマンドごとに一行（COMMAND または --help ではそのコマンドだけ）。", usage_keys};

inline constexpr JsonKey key_keys[] = {
    {"key", "string", "The key.", "キー。"},
    {"type", "string",
     "string, integer, number, boolean, object or null, or \"array of \" and one of these; several joined by \" or \".",
     "string、integer、number、boolean、object、null、またはその前に \"array of \"。複数なら \" or \" でつなぐ。"},
    {"optional", "boolean", "Whether it may be absent.", "ないことがあるか。"},
    {"object", "string or null", "The kind of the objects in it; null where it has none.",
     "中のオブジェクトの種類。なければ null。"},
    {"words", "array of string or null", "The only texts that it holds; null where any may be.",
     "とりうる文字列。任意なら null。"},
    {"list", "string or null", "The list whose ids its texts are, or the keys of its object; null where it is of none.",
     "文字列（またはオブジェクトのキー）が属する一覧。なければ null。"},
    {"en", "string", "What it means, in English.", "意味（英語）。"},
    {"ja", "string", "What it means, in Japanese.", "意味（日本語）。"},
};
inline constexpr Shape key_shape{"key_row", "A key of an object.", "オブジェクトのキー。", key_keys};

inline constexpr JsonKey object_keys[] = {
    {"object", "string", "The kind.", "種類。"},
    {"is_line", "boolean", "Whether it is a line, not a part of another object.",
     "一行をなすか（他のオブジェクトの一部でないか）。"},
    {"en", "string", "What it is, in English.", "説明（英語）。"},
    {"ja", "string", "What it is, in Japanese.", "説明（日本語）。"},
    {"keys", "array of object", "Its keys.", "キー。", objects(key_shape)},
};
inline constexpr Shape object_shape{"object", "A kind of object that a command prints.",
                                    "コマンドが出力するオブジェクトの種類。", object_keys};

inline constexpr JsonKey contract_keys[] = {
    {"command", "string or null", "The command; null in the line of what every command may print.",
     "コマンド。すべてのコマンドに共通の行では null。", ids_of(Ids::subcommands)},
    {"objects", "array of object", "What it prints, besides what every command may.",
     "出力するもの（共通のものを除く）。", objects(object_shape)},
    {"exit_codes", "array of integer", "What it may end with.", "終了コード。", ids_of(Ids::exit_codes)},
};
inline constexpr Shape contract_shape{"contract", "help json: one per command.", "help json：コマンドごとに一行。",
                                      contract_keys};

inline constexpr JsonKey value_keys[] = {
    {"kind", "string", "An element, a number, a position X,Y,Z, or this word.", "要素、数、座標 X,Y,Z、またはこの語。",
     words("vertex edge face number position word")},
    {"called", "string", "Its name in the syntax; of a word itself.", "構文での名前。語ならその語。"},
};
inline constexpr Shape value_shape{"value", "A value that an operator takes.", "操作が取る値。", value_keys};

inline constexpr JsonKey place_keys[] = {
    {"id", "string", "Its name, unique within the list.", "名前。並びの中で一意。"},
    {"list", "integer", "Which of the operator's alternative lists it belongs to, from 0.",
     "操作の選べる並びのうち何番目に属するか（0 から）。"},
    {"need", "string", "Whether a line needs it; a list takes one value or more.",
     "必要か省略できるか。list は一つ以上の値を取る。", words("required optional list")},
    {"values", "array of object", "What it may be: one of these.", "取りうる値（いずれか）。", objects(value_shape)},
    {"en", "string", "What it is for, in English.", "用途（英語）。"},
    {"ja", "string", "What it is for, in Japanese.", "用途（日本語）。"},
};
inline constexpr Shape place_shape{"place", "A place in the line of an operator.", "操作の行の一か所。", place_keys};

inline constexpr JsonKey entry_keys[] = {
    {"id", "string", "The id.", "識別子。"},
    {"syntax", "string", "Of what takes arguments: how they are written. Absent for other entries.",
     "引数を取るものの書き方。ほかの項目にはない。", optional()},
    {"places", "array of object", "Of an operator: the places of its line. Absent for other entries.",
     "操作の行の各所。ほかの項目にはない。", optional(objects(place_shape))},
    {"severities", "array of string", "With which severities it occurs; absent where there are none.",
     "重大さ。ないものにはない。", optional()},
    {"en", "string", "What it means, in English.", "意味（英語）。"},
    {"ja", "string", "What it means, in Japanese.", "意味（日本語）。"},
};
inline constexpr Shape entry_shape{"entry", "A row of a table.", "表の一行。", entry_keys};

inline constexpr JsonKey list_keys[] = {
    {"list", "string", "The name by which keys refer to it.", "キーが参照する名前。"},
    {"en", "string", "What it is, in English.", "説明（英語）。"},
    {"ja", "string", "What it is, in Japanese.", "説明（日本語）。"},
    {"entries", "array of object", "Its rows.", "行。", objects(entry_shape)},
};
inline constexpr Shape list_shape{"list", "help json: one per table whose ids stand in values.",
                                  "help json：値に現れる識別子の表ごとに一行。", list_keys};

inline constexpr JsonKey text_place_keys[] = {
    {"text", "string", "Which of the source texts.", "どのテキストか。"},
    {"place", "object", "The figure, table, problem or listing.", "図、表、問題、コードの名前。",
     objects(sentence_shape)},
    {"commands", "string or null", "What shows it in a new window, separated by \"; \"; null for nothing.",
     "新しいウィンドウで表示するコマンド（\"; \" 区切り）。なければ null。"},
    {"where", "object", "Where to look then, or why it is not there.", "どこを見るか、またはない理由。",
     objects(sentence_shape)},
};
inline constexpr Shape text_place_shape{"text_place", "help texts: one per figure, table, problem and listing.",
                                        "help texts：図、表、問題、コードごとに一行。", text_place_keys};

inline constexpr Contract help_contract{.lines = {&usage_shape, &contract_shape, &list_shape, &text_place_shape}};

inline constexpr JsonKey format_keys[] = {
    {"format", "string", "The format.", "形式。", ids_of(Ids::formats)},
    {"extensions", "array of string", "Its extensions with the dot; the first is the usual one.",
     "拡張子（点を含む。先頭が通常のもの）。"},
    {"variants", "array of string", "Ids of its encodings for --format; empty where there is one alone.",
     "--format で指定できる符号化。一つだけなら空。"},
    {"read", "boolean", "Whether it can be read.", "読み込めるか。"},
    {"write", "boolean", "Whether it can be written.", "書き出せるか。"},
    {"gzip", "boolean", "Whether its files may be packed with gzip.", "gzip 圧縮したまま扱えるか。"},
    {"en", "string", "Its name in English.", "英語名。"},
    {"ja", "string", "Its name in Japanese.", "日本語名。"},
};
inline constexpr Shape format_shape{"format", "One per format.", "形式ごとに一行。", format_keys};
inline constexpr Contract formats_contract{.lines = {&format_shape}};

inline constexpr JsonKey chord_keys[] = {
    {"key", "string", "The key with its modifiers.", "キー（修飾キーを含む）。"},
    {"command", "string", "The command that it runs.", "実行するコマンド。"},
    {"en", "string", "What it does, in English.", "動作（英語）。"},
    {"ja", "string", "What it does, in Japanese.", "動作（日本語）。"},
};
inline constexpr Shape chord_shape{"key", "One per key of the editor.", "エディタのキーごとに一行。", chord_keys};
inline constexpr Contract keys_contract{.lines = {&chord_shape}};

inline constexpr JsonKey backend_keys[] = {
    {"backend", "string", "Its name.", "名前。"},
    {"works", "boolean", "Whether it can draw here.", "ここで描画できるか。"},
    {"library", "string or null", "The library that was opened; null where there is none.",
     "開いたライブラリ。なければ null。"},
    {"version", "string or null", "Its version of OpenGL; null where it does not work.",
     "OpenGL の版。描画できないとき null。"},
    {"renderer", "string or null", "What draws; null where it does not work.", "描画するもの。描画できないとき null。"},
    {"en", "string", "Why it does not work, in English; absent where it does.",
     "描画できない理由（英語）。描画できるときはない。", optional()},
    {"ja", "string", "Why it does not work, in Japanese; absent where it does.",
     "描画できない理由（日本語）。描画できるときはない。", optional()},
};
inline constexpr Shape backend_shape{"backend", "A way to draw.", "描画の手段。", backend_keys};

inline constexpr JsonKey font_keys[] = {
    {"file", "string", "The file of the font.", "フォントのファイル。"},
    {"found", "boolean", "Whether it is there.", "あるか。"},
};
inline constexpr Shape font_shape{"font", "A font of the editor.", "エディタのフォント。", font_keys};

inline constexpr JsonKey package_keys[] = {
    {"package", "string", "The package that building needs.", "ビルドに必要なパッケージ。"},
    {"version", "string or null", "The version that is installed; null where it is not.",
     "インストールされている版。なければ null。"},
};
inline constexpr Shape package_shape{"package", "A package of the system.", "システムのパッケージ。", package_keys};

inline constexpr JsonKey doctor_keys[] = {
    {"versions", "object", "Versions by what the program is built with.", "プログラムを構成するものと版。"},
    {"processors", "integer", "How many threads run at once.", "同時に動くスレッドの数。"},
    {"display", "string or null", "The display; null where there is none.", "ディスプレイ。なければ null。"},
    {"backends", "array of object", "The ways to draw.", "描画の手段。", objects(backend_shape)},
    {"fonts", "array of object", "The fonts.", "フォント。", objects(font_shape)},
    {"packages", "array of object", "The packages.", "パッケージ。", objects(package_shape)},
};
inline constexpr Shape doctor_shape{"doctor", "One line; the exit code is 1 where nothing can draw.",
                                    "一行。描画できなければ終了コード 1。", doctor_keys};
inline constexpr Contract doctor_contract{.lines = {&doctor_shape}, .exits = {ExitCode::found_problems}};

inline constexpr JsonKey version_keys[] = {{"version", "string", "The version of the program.", "プログラムの版。"}};
inline constexpr Shape version_shape{"version", "One line.", "一行。", version_keys};
inline constexpr Contract version_contract{.lines = {&version_shape}};

inline constexpr Contract view_contract{
    .exits = {ExitCode::input_missing, ExitCode::input_malformed, ExitCode::no_backend}};

}  // namespace ryosen::cli
