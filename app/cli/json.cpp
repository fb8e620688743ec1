#include "app/cli/json.h"

#include "app/editor/document.h"

namespace ryosen::cli {

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json to_json(const glm::dvec3& p) { return Json::array({p.x, p.y, p.z}); }

Json to_json(const Message& message) {
  Json json;
  json["severity"] = message.severity == Severity::error ? "error" : "warning";
  json["code"] = message.code;
  if (message.line) json["line"] = *message.line;
  if (message.line && message.column) json["column"] = *message.column;
  if (message.byte) json["byte"] = *message.byte;
  if (message.face) json["face"] = *message.face;
  json["en"] = message.text.en;
  json["ja"] = message.text.ja;
  return json;
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
  Json json;
  json["rule"] = rule.id;
  json["severity"] = rule.severity == RuleSeverity::refuse ? "refuse" : "warn";
  json["witnesses"] = names_of(mesh, reason.witnesses);
  json["en"] = text.en;
  json["ja"] = text.ja;
  return json;
}

Json to_json(const Mesh& mesh, const std::vector<Reason>& reasons) {
  Json json = Json::array();
  for (const Reason& reason : reasons) json.push_back(to_json(mesh, reason));
  return json;
}

Json error_object(const Message& message, std::optional<std::string_view> file, std::string_view format) {
  Json json;
  json["file"] = file ? Json(*file) : Json();
  json["format"] = format.empty() ? Json() : Json(format);
  json["status"] = "error";
  json["messages"] = Json::array({to_json(message)});
  return json;
}

}  // namespace ryosen::cli
