// One call of an algorithm by the command line, and what the call did as text and as JSON.
#pragma once

#include <optional>
#include <string>

#include "app/cli/console.h"
#include "app/cli/contract/algorithms.h"
#include "app/cli/contract/json.h"
#include "ryosen/document/document.h"

namespace ryosen::cli {

// The input of an algorithm and the outputs that it is run for.
struct AlgorithmJob {
  Document* document;
  std::string input;                  // empty where it began with an empty mesh
  std::optional<std::string> output;  // -o
  const Format*
      format;  // of the output, or of the input where there is none; null: what is left is counted on the mesh
  std::vector<Message> given_up;  // warnings about what was lost already for the sake of the format of the output
};

struct Call {
  const AlgorithmRow* row;
  ParameterValues values;  // as given; on the mesh once it is done
  AlgorithmResult result = {};
};

// Gives the call the values on this mesh.
std::optional<Failure> look_up_values(Call& call, const Mesh& mesh);

// "weld_equal: 2 points were welded to others."
std::string line_of_result(const std::string& name, const AlgorithmResult& result, const Console& console);

Json value_json(const ParameterRow& row, const ParameterValue* value);
// Names only the elements that are there.
Json reason_json(const LeftForReason& left, const Mesh& mesh);

// The keys of result_keys.
template <const Shape& shape>
void add_result(Record<shape>& json, const Call& call, const Mesh& mesh) {
  json["parameters"] = Json::object();
  for (std::size_t i = 0; i < call.row->parameters.size(); ++i) {
    const ParameterRow& row = call.row->parameters[i];
    json["parameters"][std::string(row.id)] = value_json(row, call.values.at(i));
  }
  json["changed"] = call.result.changed;
  json["left"] = call.result.left;
  json["left_for"] = array_of(call.result.left_for, [&](const LeftForReason& left) { return reason_json(left, mesh); });
  json["crossings"] = or_null(call.result.crossings);
  json["solves"] = array_of(call.row->solves, [](ProblemKind kind) { return row_of(kind).id; });
  json.put(call.result.text);
}

}  // namespace ryosen::cli
