// Keys that `why` and `edit` print.
#pragma once

#include "app/cli/contract/shape.h"

namespace ryosen::cli {

inline constexpr JsonKey why_keys[] = {
    {"op", "string", "The operator.", "操作。", ids_of(Ids::operators)},
    {"edge", "string or null", "The name of the edge; null for an operator that works on none.",
     "稜線の名前。稜線に対する操作でないとき null。"},
    {"legal", "boolean", "Whether no rule refuses.", "可能か（拒否する規則がないか）。"},
    {"reasons", "array of object", "The rules that refuse.", "拒否する規則。", objects(reason_shape)},
    {"warnings", "array of object",
     "The rules that warn; under --all only where --geometry asks for them, and none where it is refused.",
     "警告する規則（--all では --geometry を指定したときだけ。拒否されるときは空）。", objects(reason_shape)},
    {"remedy", "array of string or string",
     "Commands after which it is legal, empty where it is already; never where the bounded search found none.",
     "可能にするコマンド。すでに可能なら空。限られた探索で見つからなければ never。", words("never")},
};
inline constexpr Shape why_shape{"why", "One per question: the verdict on an operator.", "問いごとに一行。操作の可否。",
                                 why_keys};

inline constexpr Contract why_contract{.lines = {&why_shape},
                                       .exits = {ExitCode::input_missing, ExitCode::input_malformed}};

inline constexpr JsonKey edit_step_keys[] = {
    {"line", "integer", "The line of the script, or the number of the command, from 1.",
     "スクリプトの行、またはコマンドの番号（1 から）。"},
    {"command", "string", "The command as it was given.", "与えられたコマンド。"},
    {"result", "string", "What became of it; skipped after one that stopped the run.",
     "結果。実行が止まった後のものは skipped。", words("done refused failed skipped")},
    {"created", "array of string", "Names of new elements.", "作られた要素の名前。"},
    {"deleted", "array of string", "Names of elements that are gone.", "なくなった要素の名前。"},
    {"reasons", "array of object", "The rules that refused.", "拒否した規則。", objects(reason_shape)},
    {"warnings", "array of object", "The rules that warn.", "警告する規則。", objects(reason_shape)},
    {"messages", "array of object", "Why it was refused or failed; absent else.",
     "拒否または失敗の理由。それ以外ではない。", optional(objects(message_shape))},
};
inline constexpr Shape edit_step_shape{"step", "One per command, in their order.", "コマンドごとに一行（順に）。",
                                       edit_step_keys};

inline constexpr JsonKey edit_keys[] = {
    {"file", "string or null", "The input, as it was named; null with --new.",
     "指定されたとおりの入力。--new では null。"},
    {"output", "string or null", "The last file that was written; null where nothing was.",
     "最後に書き出したファイル。なければ null。"},
    {"status", "string",
     "ok; warnings where something was refused and skipped, or is lost; error where the run or the output failed.",
     "ok。拒否を飛ばしたか、失われるものがあれば warnings、途中で止まるか書き出せなければ error。",
     words("ok warnings error")},
    {"vertices", "integer", "As in check, of the mesh at the end.", "最後のメッシュの頂点数（check と同じ）。"},
    {"edges", "integer", "As in check, of the mesh at the end.", "最後のメッシュの稜線数（check と同じ）。"},
    {"faces", "integer", "As in check, of the mesh at the end.", "最後のメッシュの面数（check と同じ）。"},
    {"rings", "integer", "As in check, of the mesh at the end.", "最後のメッシュのリング数（check と同じ）。"},
    {"hash", "string", "As in check, of the mesh at the end; a file read again may number its elements anew.",
     "最後のメッシュのハッシュ値（check と同じ）。ファイルを読み直すと要素の番号が変わり、異なることがある。"},
    {"applied", "integer", "How many commands were done.", "実行されたコマンドの数。"},
    {"refused", "integer", "How many commands were refused.", "拒否されたコマンドの数。"},
    {"messages", "array of object", "What -o loses, and why it was not written; absent where there is nothing to say.",
     "-o で失われるもの、書き出せなかった理由。なければない。", optional(objects(message_shape))},
};
inline constexpr Shape edit_shape{"edit", "The last line, once the commands have run.",
                                  "最後の行（コマンドの実行後）。", edit_keys};

inline constexpr Contract edit_contract{.lines = {&edit_step_shape, &edit_shape},
                                        .exits = {ExitCode::found_problems, ExitCode::input_missing,
                                                  ExitCode::input_malformed, ExitCode::refused, ExitCode::no_backend}};

}  // namespace ryosen::cli
