// An object of JSON that has no keys but those of its shape.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "app/cli/contract/json.h"
#include "app/cli/contract/shape.h"

namespace ryosen::cli {

// A key of the shape, made from a literal; one without a row in the shape does not compile.
template <const Shape& shape>
class KeyOf {
 public:
  consteval KeyOf(const char* id) : id_(find(id)) {}
  constexpr std::string_view id() const { return id_; }

 private:
  static consteval std::string_view find(std::string_view id) {
    for (const JsonKey& row : shape.keys)
      if (row.id == id) return row.id;
    throw "a key that the shape has no row for";
  }

  std::string_view id_;
};

// Keys keep the order of insertion.
template <const Shape& shape>
class Record {
 public:
  Json& operator[](KeyOf<shape> key) { return json_[std::string(key.id())]; }

  // The keys en and ja.
  void put(std::string_view en, std::string_view ja) {
    (*this)["en"] = en;
    (*this)["ja"] = ja;
  }
  void put(const Text& text) { put(text.en, text.ja); }

  const Json& json() const& { return json_; }
  Json&& json() && { return std::move(json_); }

 private:
  Json json_ = Json::object();
};

template <const Shape& shape>
std::string line_of(const Record<shape>& record) {
  return line_of(record.json());
}

}  // namespace ryosen::cli
