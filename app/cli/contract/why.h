// What `why` prints.
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

}  // namespace ryosen::cli
