// What the program prints as JSON: a row per key, with what it means in both languages. The commands print through
// Record, which takes its keys from these rows; `help json` lists them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/base/result.h"

namespace ryosen::cli {

// Tables of the product whose ids stand in values, in the order of id_lists().
enum class Ids : std::uint8_t {
  exit_codes,
  codes,
  rules,
  problems,
  highlights,
  operators,
  commands,
  repairs,
  algorithms,
  mesh_kinds,
  formats,
  forms,
  maps,
  relations,
  pairings,
  subcommands,
  edge_rules,
  steps,
  roles,
};

struct Shape;

// Limits of a key's value beyond its type.
struct KeyLimits {
  bool is_optional = false;      // it may be absent; the sentence says when
  std::string_view words = {};   // the only values, separated by spaces
  std::optional<Ids> ids = {};   // values are ids of this table; of an object: its keys are
  const Shape* shape = nullptr;  // of the objects in the value
};

constexpr KeyLimits words(std::string_view all) { return {.words = all}; }
constexpr KeyLimits ids_of(Ids ids) { return {.ids = ids}; }
constexpr KeyLimits objects(const Shape& shape) { return {.shape = &shape}; }
constexpr KeyLimits optional(KeyLimits limits = {}) {
  limits.is_optional = true;
  return limits;
}

struct JsonKey {
  std::string_view id;
  // string, integer, number, boolean, object or null, or "array of " and one of these; several joined by " or ".
  std::string_view type;
  std::string_view en, ja;  // one sentence, also about null and about when it is absent
  KeyLimits limits = {};
};

// The keys of several lists in one.
template <std::size_t... counts>
consteval auto joined(const JsonKey (&... lists)[counts]) {
  std::array<JsonKey, (counts + ...)> all{};
  std::size_t next = 0;
  const auto add = [&](std::span<const JsonKey> list) {
    for (const JsonKey& key : list) all[next++] = key;
  };
  (add(lists), ...);
  return all;
}

// A kind of object.
struct Shape {
  std::string_view id;
  std::string_view en, ja;
  std::span<const JsonKey> keys;
  std::vector<JsonKey> (*keys_of_tables)() = nullptr;  // instead of `keys`, where some come from tables

  std::vector<JsonKey> all_keys() const {
    return keys_of_tables ? keys_of_tables() : std::vector(keys.begin(), keys.end());
  }
};

// What a command may print and end with, in addition to shared_contract.
struct Contract {
  std::array<const Shape*, 4> lines = {};  // each object is one line; null where there are fewer
  std::array<ExitCode, 6> exits = {};      // filled up with done
};

// From here on the objects that several commands print.

inline constexpr JsonKey message_keys[] = {
    {"severity", "string", "How bad it is.", "重大さ。", words("warning error")},
    {"code", "string", "What it is about, for scripts.", "内容を表すコード。", ids_of(Ids::codes)},
    {"line", "integer", "The line of the file or of the script, from 1; absent where it belongs to none.",
     "ファイルまたはスクリプトの行（1 から）。行によらないときはない。", optional()},
    {"column", "integer", "The column in the line, in bytes from 1; absent where it is not known.",
     "行の中の位置（バイト数、1 から）。不明のときはない。", optional()},
    {"byte", "integer", "The place in a binary file, in bytes from 0; absent where there is none.",
     "バイナリファイルの中の位置（バイト数、0 から）。位置によらないときはない。", optional()},
    {"face", "integer", "The number of the face in the file, from 0; absent where there is none.",
     "ファイルの中の面の番号（0 から）。面によらないときはない。", optional()},
    {"en", "string", "The sentence in English.", "英語の文。"},
    {"ja", "string", "The sentence in Japanese.", "日本語の文。"},
};
inline constexpr Shape message_shape{"message", "What is to be said about a file or a line.",
                                     "ファイルまたは行についてのメッセージ。", message_keys};

inline constexpr JsonKey failure_keys[] = {
    {"file", "string or null", "The file, as it was named; null where the failure is about none.",
     "指定されたとおりのファイル名。ファイルによらないときは null。"},
    {"format", "string or null", "The format that check took a malformed file for; else null.",
     "check が不正なファイルに推定した形式。それ以外は null。", ids_of(Ids::formats)},
    {"status", "string", "Always error.", "常に error。", words("error")},
    {"messages", "array of object", "The failure.", "失敗の内容。", objects(message_shape)},
    {"stopped", "string", "Why it ended; there only where an algorithm with a goal was cancelled.",
     "終了の理由。目標のあるアルゴリズムが中止されたときだけある。", optional(words("cancelled"))},
};
inline constexpr Shape failure_shape{"failure", "Stands for a file or a command line that was refused.",
                                     "ファイルまたはコマンド行が受け付けられなかったときの行。", failure_keys};

inline constexpr JsonKey reason_keys[] = {
    {"rule", "string", "The rule.", "規則。", ids_of(Ids::rules)},
    {"severity", "string", "Whether the rule refuses or warns.", "拒否か警告か。", words("refuse warn")},
    {"witnesses", "array of string", "Names of the elements that stand in the way.", "妨げとなる要素の名前。"},
    {"en", "string", "The sentence in English.", "英語の文。"},
    {"ja", "string", "The sentence in Japanese.", "日本語の文。"},
};
inline constexpr Shape reason_shape{"reason", "A rule that an operator breaks, and where.",
                                    "操作が反する規則とその場所。", reason_keys};

inline constexpr JsonKey problem_keys[] = {
    {"kind", "string", "The kind.", "種類。", ids_of(Ids::problems)},
    {"severity", "string", "info for what is no fault.", "誤りでないものは info。", words("problem info")},
    {"count", "integer", "How many there are.", "個数。"},
    {"elements", "array of string", "Names of the elements.", "要素の名前。"},
    {"pairs", "array of array of string", "Pairs of faces that meet; absent but for self_intersection.",
     "交わる面の組。self_intersection 以外ではない。", optional()},
    {"complete", "boolean",
     "Whether pairs holds them all, else the sentence has their number; absent but for self_intersection.",
     "pairs がすべてを含むか。含まないとき文が総数を示す。self_intersection 以外ではない。", optional()},
    {"where", "array of number or null", "A place to look at, x y z; null where there is none.",
     "見るべき場所 x y z。ないときは null。"},
    {"line", "integer or null", "The line of the file of the first of them; null where it is not known.",
     "最初のもののファイルでの行。不明のときは null。"},
    {"en", "string", "The sentence in English.", "英語の文。"},
    {"ja", "string", "The sentence in Japanese.", "日本語の文。"},
};
inline constexpr Shape problem_shape{"problem", "A kind of problem of a mesh with all its elements.",
                                     "メッシュの問題（種類ごと）とその要素。", problem_keys};

inline constexpr JsonKey sentence_keys[] = {
    {"en", "string", "In English.", "英語。"},
    {"ja", "string", "In Japanese.", "日本語。"},
};
inline constexpr Shape sentence_shape{"sentence", "A sentence or name.", "文または名前。", sentence_keys};

// The lines and exit codes that every command may have.
inline constexpr Contract shared_contract{
    .lines = {&failure_shape},
    .exits = {ExitCode::done, ExitCode::usage, ExitCode::output_not_writable, ExitCode::cancelled,
              ExitCode::out_of_memory, ExitCode::internal_error}};

}  // namespace ryosen::cli
