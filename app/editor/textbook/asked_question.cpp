#include "app/editor/textbook/asked_question.h"

#include "app/editor/session/session.h"

namespace ryosen {

std::optional<Element> asked_element(const Session& session) {
  const std::optional<AskedQuestion>& question = session.asked_question;
  const Document& document = session.document();
  if (!question || !session.layout.is_shown(panel_opened_by(PanelOpener::practised))) return std::nullopt;
  if (question->serial != document.serial() || question->revision != document.revision()) return std::nullopt;
  return question->about;
}

}  // namespace ryosen
