#include "app/cli/contract/json.h"

#include "app/cli/contract/shape.h"
#include "ryosen/base/utf8.h"
#include "ryosen/document/document.h"

namespace ryosen::cli {

namespace {

// Placeholders for the two hex digits of an invalid byte until the text is dumped: Unicode noncharacters, which occur
// in no name.
constexpr std::string_view high_halves = "\xef\xb7\x90", low_halves = "\xef\xb7\xa0";

bool is_stand_in(std::string_view character) {
  return character.starts_with("\xef\xb7") && character >= high_halves && character < "\xef\xb7\xb0";
}

std::string with_stand_ins(std::string_view text) {
  std::string out;
  const auto add = [&](std::string_view halves, int half) {
    out += halves;
    out.back() = static_cast<char>(static_cast<unsigned char>(out.back()) + half);
  };
  while (!text.empty()) {
    std::size_t length = utf8_length(text);
    if (length == 0 || is_stand_in(text.substr(0, length))) {
      length = 1;
      const auto byte = static_cast<unsigned char>(text[0]);
      add(high_halves, byte >> 4);
      add(low_halves, byte & 15);
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return out;
}

void put_stand_ins(Json& json) {
  if (json.is_string())
    json = with_stand_ins(json.get_ref<const std::string&>());
  else if (json.is_structured())
    for (Json& item : json) put_stand_ins(item);
}

std::string with_escapes(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto half = [](char last, std::string_view halves) {
    return static_cast<std::size_t>(static_cast<unsigned char>(last) - static_cast<unsigned char>(halves.back()));
  };
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    if (!is_stand_in(text.substr(at, 3))) {
      out += text[at++];
      continue;
    }
    out += "\\udc";
    out += digits[half(text[at + 2], high_halves)];
    out += digits[half(text[at + 5], low_halves)];
    at += 6;
  }
  return out;
}

}  // namespace

std::string line_of(const Json& json) {
  try {
    return json.dump() + "\n";
  } catch (const Json::type_error&) {  // some string is not UTF-8
    Json copy = json;
    put_stand_ins(copy);
    return with_escapes(copy.dump()) + "\n";
  }
}

Json to_json(const glm::dvec3& p) { return Json::array({p.x, p.y, p.z}); }

Json to_json(const Text& text) {
  Record<sentence_shape> json;
  json.put(text);
  return std::move(json).json();
}

Json to_json(const Message& message) {
  Record<message_shape> json;
  json["severity"] = message.severity == Severity::error ? "error" : "warning";
  json["code"] = message.code.row().id;
  if (message.line) json["line"] = *message.line;
  if (message.line && message.column) json["column"] = *message.column;
  if (message.byte) json["byte"] = *message.byte;
  if (message.face) json["face"] = *message.face;
  json.put(message.text);
  return std::move(json).json();
}

Json to_json(const std::vector<Message>& messages) {
  Json json = Json::array();
  for (const Message& message : messages)
    if (message.severity != Severity::info) json.push_back(to_json(message));
  return json;
}

Json to_json(const Mesh& mesh, const Reason& reason) {
  const RuleText& rule = text_of(reason.rule);
  const Text text = describe(mesh, reason);
  Record<reason_shape> json;
  json["rule"] = rule.id;
  json["severity"] = rule.severity == RuleSeverity::refuse ? "refuse" : "warn";
  json["witnesses"] = names_of(mesh, reason.witnesses);
  json.put(text);
  return std::move(json).json();
}

Json to_json(const Mesh& mesh, const std::vector<Reason>& reasons) {
  return array_of(reasons, [&](const Reason& reason) { return to_json(mesh, reason); });
}

Json error_object(const Message& message, std::optional<std::string_view> file, std::string_view format) {
  Record<failure_shape> json;
  json["file"] = file && !file->empty() ? Json(*file) : Json();
  json["format"] = format.empty() ? Json() : Json(format);
  json["status"] = "error";
  json["messages"] = Json::array({to_json(message)});
  return std::move(json).json();
}

}  // namespace ryosen::cli
