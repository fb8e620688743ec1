#include "app/editor/texts/hidden_text.h"

#include "ryosen/base/count_text.h"

namespace ryosen {

Text hidden_text(const HiddenElements& hidden) {
  if (hidden.empty()) return {"nothing is hidden", "非表示の要素はありません"};
  if (const auto faces = hidden.faces().size())
    return count_text(faces, "one face is hidden", "# faces are hidden", "# 面を非表示にしています");
  return count_text(hidden.wires().size() + hidden.isolated().size(), "one element is hidden", "# elements are hidden",
                    "# 個の要素を非表示にしています");
}

}  // namespace ryosen
