// What the commands' JSON is made of.
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/base/verdict.h"
#include "core/mesh/mesh.h"

namespace ryosen::cli {

// Keys stay in the order of insertion. NaN and infinity are written as null.
using Json = nlohmann::ordered_json;

// One line with its line end, in UTF-8. A byte XX that is none (file names may hold such) is written as the escape \udcXX,
// a surrogate without its other half, so that different names stay different; Python reads it and its os.fsencode gives
// the byte back.
std::string line_of(const Json& json);

Json to_json(const glm::dvec3& p);
Json to_json(const Message& message);
Json to_json(const std::vector<Message>& messages);
// With its witnesses named as the mesh is now.
Json to_json(const Mesh& mesh, const Reason& reason);
Json to_json(const Mesh& mesh, const std::vector<Reason>& reasons);

// The object for a file that was refused, or for a command line that was (no file, no format).
Json error_object(const Message& message, std::optional<std::string_view> file, std::string_view format = {});

}  // namespace ryosen::cli
