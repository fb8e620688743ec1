#include "app/editor/session/asked_question.h"

#include "app/editor/preferences/layout.h"
#include "ryosen/document/document.h"

namespace ryosen {

std::optional<Element> asked_element(const Document& document, const Layout& layout,
                                     const std::optional<AskedQuestion>& asked_question) {
  const std::optional<AskedQuestion>& question = asked_question;
  if (!question || !layout.is_shown(panel_opened_by(PanelOpener::practised))) return std::nullopt;
  if (question->serial != document.serial() || question->revision != document.revision()) return std::nullopt;
  return question->about;
}

}  // namespace ryosen
