#include <algorithm>

#include "app/editor/camera/view_state.h"
#include "app/editor/labels/labels.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/texts/message_place.h"
#include "ryosen/base/count_text.h"
#include "ryosen/document/document.h"

namespace ryosen {

bool is_faceless(const Document& document) {
  const ElementCounts live = document.mesh().live();
  return live.faces == 0 && live.edges == 0 && !document.path().empty();
}

void add_faceless(const Document& document, const ViewState& view, const Preferences& preferences,
                  std::vector<Label>& labels) {
  const MeshFile& file = document.file();
  std::vector<std::string> sentences;
  const Text what =
      document.mesh().live().vertices == 0
          ? Text{"The mesh is empty.", "メッシュは空です。"}
          : count_text(document.mesh().live().vertices, "The mesh has one vertex and no faces.",
                       "The mesh has # vertices and no faces.", "メッシュには頂点が # 個ありますが、面はありません。");
  sentences.push_back(what.in(preferences.language));
  const auto is_about_rest = [](const Message& m) { return m.code != "no_faces" && m.code != "no_vertices"; };
  const auto first = std::find_if(file.messages.begin(), file.messages.end(), is_about_rest);
  if (first != file.messages.end())
    sentences.push_back(text_with_place(*first, document.path().filename().string()).in(preferences.language));
  add_caption(view, preferences, sentences, labels);
}

}  // namespace ryosen
