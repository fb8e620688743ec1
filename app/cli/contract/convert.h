// What `convert` prints.
#pragma once

#include "app/cli/contract/shape.h"

namespace ryosen::cli {

inline constexpr JsonKey loss_keys[] = {
    {"code", "string", "What is lost, for scripts.", "失われるものを表すコード。", ids_of(Ids::codes)},
    {"count", "integer", "How many of them.", "個数。"},
    {"en", "string", "The sentence in English.", "英語の文。"},
    {"ja", "string", "The sentence in Japanese.", "日本語の文。"},
};
inline constexpr Shape loss_shape{"loss", "What the format cannot hold.", "形式が保持できないもの。", loss_keys};

inline constexpr JsonKey convert_keys[] = {
    {"file", "string", "The input, as it was named.", "指定されたとおりの入力。"},
    {"output", "string or null", "The file that was written; null where nothing was.",
     "書き出したファイル。なければ null。"},
    {"from", "string", "The format of the input.", "入力の形式。", ids_of(Ids::formats)},
    {"format", "string", "The format of the output.", "出力の形式。", ids_of(Ids::formats)},
    {"status", "string", "ok; warnings where something is lost; error where it was refused or not written.",
     "ok。失われるものがあれば warnings、拒否または書き出せなければ error。", words("ok warnings error")},
    {"vertices", "integer", "Vertices of the input.", "入力の頂点数。"},
    {"faces", "integer", "Faces of the input, after --triangulate where that is asked for.",
     "入力の面数（--triangulate を指定すれば分割後）。"},
    {"losses", "array of object", "What the format of the output cannot hold.", "出力の形式が保持できないもの。",
     objects(loss_shape)},
    {"messages", "array of object", "What reading had to say, and why nothing was written.",
     "読み込み時のメッセージと、書き出さなかった理由。", objects(message_shape)},
};
inline constexpr Shape convert_shape{"convert", "One line.", "一行。", convert_keys};

inline constexpr Contract convert_contract{
    .lines = {&convert_shape}, .exits = {ExitCode::input_missing, ExitCode::input_malformed, ExitCode::refused}};

}  // namespace ryosen::cli
