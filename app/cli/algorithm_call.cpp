#include "app/cli/algorithm_call.h"

#include <utility>

#include "app/cli/contract/json.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"

namespace ryosen::cli {

std::optional<Failure> look_up_values(Call& call, const Mesh& mesh) {
  ReadValues found = call.values.on(mesh);
  if (found.lacks_extent)
    return make_failure(ExitCode::refused, "mesh_refused", {found.sentence.en + ".", found.sentence.ja + "。"});
  if (!found.values) return usage_failure("bad_value", {found.sentence.en + ".", found.sentence.ja + "。"});
  call.values = std::move(*found.values);
  return std::nullopt;
}

std::string line_of_result(const std::string& name, const AlgorithmResult& result, const Console& console) {
  return name + console.text(": ", "：").data() + console.text(result.text) + "\n";
}

Json value_json(const ParameterRow& row, const ParameterValue* value) {
  if (!value) return nullptr;
  if (row.kind == ParameterKind::count) return static_cast<std::uint64_t>(value->number);
  if (row.kind == ParameterKind::choice) return row.choices[static_cast<std::size_t>(value->number)].id;
  if (row.kind == ParameterKind::flag) return value->number != 0;
  if (row.kind == ParameterKind::place) return to_json(value->place);
  if (row.kind == ParameterKind::elements) return value->names;
  return value->number;
}

Json reason_json(const LeftForReason& left, const Mesh& mesh) {
  Record<left_shape> json;
  json["elements"] = Json::array();
  for (const Element& element : left.elements)
    if (is_alive(mesh, element)) json["elements"].push_back(ryosen::name_of(mesh, element));
  json.put(left.reason);
  return std::move(json).json();
}

}  // namespace ryosen::cli
