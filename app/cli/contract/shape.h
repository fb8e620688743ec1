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

}  // namespace ryosen::cli
