#include <algorithm>

#include "app/editor/labels/labels.h"
#include "app/editor/session/session.h"
#include "app/editor/texts/message_place.h"
#include "ryosen/base/count_text.h"

namespace ryosen {

bool is_faceless(const Session& session) {
  const ElementCounts live = session.mesh().live();
  return live.faces == 0 && live.edges == 0 && !session.awaits_file && !session.shown.player() &&
         !session.document().path().empty();
}

void add_faceless(Session& session, std::vector<Label>& labels) {
  const MeshFile& file = session.document().file();
  std::vector<std::string> sentences;
  const Text what =
      session.mesh().live().vertices == 0
          ? Text{"The mesh is empty.", "メッシュは空です。"}
          : count_text(session.mesh().live().vertices, "The mesh has one vertex and no faces.",
                       "The mesh has # vertices and no faces.", "メッシュには頂点が # 個ありますが、面はありません。");
  sentences.push_back(what.in(session.preferences.language));
  const auto is_about_rest = [](const Message& m) { return m.code != "no_faces" && m.code != "no_vertices"; };
  const auto first = std::find_if(file.messages.begin(), file.messages.end(), is_about_rest);
  if (first != file.messages.end())
    sentences.push_back(
        text_with_place(*first, session.document().path().filename().string()).in(session.preferences.language));
  add_caption(session, sentences, labels);
}

}  // namespace ryosen
