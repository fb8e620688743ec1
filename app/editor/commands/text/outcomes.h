// Outcomes of lines that are not carried out, or that have only something to tell.
#pragma once

#include <string>
#include <string_view>

#include "ryosen/base/result.h"
#include "ryosen/document/outcome.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

class Document;

Outcome failed(const Failure& failure);
Outcome usage_error(std::string en, std::string ja);
Outcome usage_error(const Text& sentence);
// Done, with a remark.
Outcome done_with(Text remark);
// Long work that was given up.
Outcome cancelled();
// An operator's line names no element of the mesh, with this error: a refusal by the rule `deleted` where the element
// stands at another place of the history, else usage; with a sentence that says which, and of quarantined faces.
Outcome no_element(Document& document, std::string_view line, NameError error, const Text& sentence);

}  // namespace ryosen
