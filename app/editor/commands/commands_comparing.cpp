// The command `compare`: another mesh beside the open one.
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"

namespace ryosen {

std::optional<Text> fault_of_compare(Words arguments, const std::string&) {
  return arguments.empty() ? std::optional(wrong_arguments("compare").sentence) : std::nullopt;
}

Outcome run_compare(Session& session, Words arguments, std::string_view whole) {
  if (arguments.empty()) return wrong_arguments("compare");
  if (arguments.size() == 1 && arguments[0] == "off") {
    session.compare_with(nullptr);
    return {};
  }
  const std::string name = file_name(whole);
  auto document = session.frontend.read_document(name);
  if (!document) return not_read(document.failure(), name);
  session.files.reads(name, FileRole::mesh);
  session.compare_with(std::move(document).value());
  return {};
}

}  // namespace ryosen
