#include "app/ui/textbook/records_of_mesh.h"

#include <utility>

#include "app/editor/document/repair_trials.h"
#include "app/ui/widgets.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

const RecordBook* records_of_mesh(PanelContext& context) {
  constexpr std::uint32_t most_unasked = 100'000, most_at_once = 1'000;  // those take less than a frame
  if (!context.state.records) context.state.records = std::make_shared<RecordBook>();
  RecordBook& book = *context.state.records;
  const std::uint32_t faces = context.mesh().live().faces;
  context.state.wants_records = true;
  if (!book.is_of(context.document()) && faces > most_unasked) {
    constexpr std::uint64_t bytes_per_face = 1900;  // of all forms with their numbers, measured on the bunny
    const std::string size = std::to_string(faces * bytes_per_face / 1'000'000);
    const Text why{"Over 100,000 faces: the forms are built when you ask for them. They take about " + size +
                       " MB, until no panel shows them.",
                   "10 万面を超えるため、ボタンを押したときに構築します。約 " + size +
                       " MB を使い、表示するパネルがなくなると解放します。"};
    dim_text(context, why.in(context.language()).c_str());
    if (!ImGui::Button(context.text("Build the forms", "形状表現を構築"), {ImGui::GetContentRegionAvail().x, 0}))
      return nullptr;
  }
  book.ask(context.document());
  // A picture is not drawn again when they are there.
  if (!context.trials.in_background || faces <= most_at_once) book.wait_for(context.document());
  if (book.is_ready()) return &book;
  context.state.waits_for_work = true;
  dim_text(context, context.text("Building the forms...", "形状表現を構築中..."));
  return nullptr;
}

void keep_records(PanelContext& context) {
  const std::shared_ptr<RecordBook>& book = context.state.records;
  context.state.wants_records |= book && book->is_of(context.document());
}

bool rest_records(GuiState& state) {
  return std::exchange(state.wants_records, false) || !state.records || state.records->rest();
}

}  // namespace ryosen
