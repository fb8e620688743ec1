// JSON as the commands print it: objects that have no keys but those of their shapes, and lines.
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/contract/shape.h"
#include "ryosen/base/message.h"
#include "ryosen/base/verdict.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::cli {

// Keys keep their insertion order. NaN and infinity are written as null.
using Json = nlohmann::ordered_json;

// An array of the JSON that `convert` makes of each.
template <class Range, class Convert>
Json array_of(const Range& range, const Convert& convert) {
  Json all = Json::array();
  for (const auto& each : range) all.push_back(convert(each));
  return all;
}
// One line with its line end, in UTF-8. An invalid byte XX (possible in file names) is written as the escape \udcXX, an
// unpaired surrogate, so that different names stay different; Python reads it and os.fsencode restores the byte.
std::string line_of(const Json& json);

// The value, or null where there is none.
template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}
Json to_json(const glm::dvec3& p);
// A sentence or name in both languages, by sentence_shape.
Json to_json(const Text& text);
Json to_json(const Message& message);
// Without those of severity info.
Json to_json(const std::vector<Message>& messages);
// Witnesses are named by the current mesh.
Json to_json(const Mesh& mesh, const Reason& reason);
Json to_json(const Mesh& mesh, const std::vector<Reason>& reasons);

// The error object for a file that failed, or for the command line (no file, no format).
// `file` is null where there is none or its name is empty.
Json error_object(const Message& message, std::optional<std::string_view> file, std::string_view format = {});

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

// An object that has no keys but those of its shape; they keep the order of insertion.
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
