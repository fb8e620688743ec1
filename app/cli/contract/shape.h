// What the program prints as JSON: a row per key, with what it means in both languages. The commands print through
// Record, which takes its keys from these rows; `help json` lists them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/result.h"

namespace ryosen::cli {

// Tables of the product whose ids stand in values, in the order of id_lists().
enum class Ids : std::uint8_t {
  none,
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
  relations,
  pairings,
  subcommands,
};

struct Shape;

// What can be said of a key beyond its type.
struct KeyLimits {
  bool is_optional = false;      // it may be absent; the sentence says when
  std::string_view words = {};   // the only values, separated by spaces
  Ids ids = Ids::none;           // values are ids of this table; of an object: its keys are
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

// A kind of object.
struct Shape {
  std::string_view id;
  std::string_view en, ja;
  std::span<const JsonKey> keys;
};

// What a command may print and end with, besides what every command may.
struct Contract {
  std::span<const Shape* const> lines;  // each object is one line
  std::span<const ExitCode> exits;
};

}  // namespace ryosen::cli
