// What `shot` prints.
#pragma once

#include "app/cli/contract/shape.h"

namespace ryosen::cli {

inline constexpr JsonKey shot_keys[] = {
    {"file", "string", "The input, as it was named.", "指定されたとおりの入力。"},
    {"output", "string or null", "The picture that was written; null where none was.",
     "書き出した画像。なければ null。"},
    {"status", "string", "error where the exit code is not 0.", "終了コードが 0 以外なら error。", words("ok error")},
    {"size", "array of integer", "Width and height in pixels.", "幅と高さ（画素）。"},
    {"backend", "string", "What drew.", "描画に使ったもの。"},
    {"reference", "string or null", "The picture to compare with; null without --compare.",
     "比較する画像。--compare がなければ null。"},
    {"different_percent", "number or null", "How many of the pixels differ; null where nothing was compared.",
     "異なる画素の割合。比較しなかったとき null。"},
    {"messages", "array of object", "What was refused, failed or differs.", "拒否、失敗、差異の内容。",
     objects(message_shape)},
};
inline constexpr Shape shot_shape{"shot", "One line.", "一行。", shot_keys};

inline constexpr Contract shot_contract{.lines = {&shot_shape},
                                        .exits = {ExitCode::found_problems, ExitCode::input_missing,
                                                  ExitCode::input_malformed, ExitCode::refused, ExitCode::no_backend}};

}  // namespace ryosen::cli
