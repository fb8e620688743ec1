// What `practice` prints.
#pragma once

#include "app/cli/contract/shape.h"

namespace ryosen::cli {

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
