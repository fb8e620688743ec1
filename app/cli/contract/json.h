// JSON helpers for the commands.
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/base/verdict.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::cli {

// Keys keep their insertion order. NaN and infinity are written as null.
using Json = nlohmann::ordered_json;

// One line with its line end, in UTF-8. An invalid byte XX (possible in file names) is written as the escape \udcXX, an
// unpaired surrogate, so that different names stay different; Python reads it and os.fsencode restores the byte.
std::string line_of(const Json& json);

Json to_json(const glm::dvec3& p);
Json to_json(const Message& message);
// Without those of severity info.
Json to_json(const std::vector<Message>& messages);
// Witnesses are named by the current mesh.
Json to_json(const Mesh& mesh, const Reason& reason);
Json to_json(const Mesh& mesh, const std::vector<Reason>& reasons);

// The error object for a file that failed, or for the command line (no file, no format).
// `file` is null where there is none or its name is empty.
Json error_object(const Message& message, std::optional<std::string_view> file, std::string_view format = {});

}  // namespace ryosen::cli
