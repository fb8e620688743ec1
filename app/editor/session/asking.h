// A line of an operator, or of another command about elements, that are still to be pointed at: each click adds one,
// and the last one carries it out.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "ryosen/document/outcome.h"
#include "ryosen/scene/pick/picker.h"

namespace ryosen {

class Session;

// The kind of the element that an operator's line lacks next; none where it is no operator's, is complete, or lacks
// something else. A list of any length always takes one more.
std::optional<PickMode> asked_for(std::string_view line);
// Also where another command takes one more, which may be of any kind: it is of that of the mode.
bool can_be_asked(std::string_view line);
// Whether nothing can follow that would have to be pointed at.
bool is_answered(std::string_view line);
// Adds what is under the pixel to the session's asked line. Where nothing is missing then, it is carried out, and what
// was asked begins anew after a refusal.
Outcome answer(Session& session, glm::dvec2 pixel);
Outcome carry_out_asked(Session& session);
// "make_edge v3: point at a vertex"
Text asked_text(std::string_view line);

}  // namespace ryosen
