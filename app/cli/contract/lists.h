// What `formats`, `keys`, `doctor` and `--version` print, and the window where it does not open.
#pragma once

#include "app/cli/contract/shape.h"

namespace ryosen::cli {

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
