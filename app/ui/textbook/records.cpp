#include <utility>

#include "app/editor/session/selecting.h"
#include "app/editor/textbook/record_text.h"
#include "app/ui/panels.h"
#include "app/ui/textbook/records_of_mesh.h"
#include "app/ui/widgets.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/textbook/forms/all.h"

namespace ryosen {

namespace {

// What each form of the source texts stores of the selected element, or else of the one under the pointer.
class RecordsPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    // Those of an older mesh are given back, also while nothing is pointed at.
    keep_records(context);
    const std::optional<Element> asked = element(context.selecting);
    if (!asked || !is_alive(context.mesh(), *asked))
      return dim_text(context, context.text("Point at an element, or select one.", "要素を指すか、選択してください。"));
    ImGui::PushFont(context.fonts.bold);
    wrapped_text(name_and_slot(context.mesh(), *asked).c_str());
    ImGui::PopFont();
    const RecordBook* const book = records_of_mesh(context);
    if (!book) return;
    choose_form(context);
    chosen_.clear();
    for (const forms::Records& records : book->records())
      if (shown_ == nullptr || shown_ == &records.row()) draw_record(context, records, *asked);
    if (!chosen_.empty()) context.run(chosen_);
  }

 private:
  std::optional<Element> element(const Selecting& selecting) {
    if (!selecting.selection.empty()) return selecting.selection.back();
    return selecting.hover() ? std::optional(selecting.hover()->picked.element) : std::nullopt;
  }

  void choose_form(PanelContext& context) {
    const char* const all = context.text("All forms", "すべての表現");
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (!ImGui::BeginCombo("##form", shown_ == nullptr ? all : context.text(shown_->en, shown_->ja))) return;
    if (ImGui::Selectable(all, shown_ == nullptr)) shown_ = nullptr;
    for (const forms::FormRow& row : forms::all_forms())
      if (ImGui::Selectable(context.text(row.en, row.ja), shown_ == &row)) shown_ = &row;
    ImGui::EndCombo();
  }

  void draw_record(PanelContext& context, const forms::Records& records, Element element) {
    const forms::FormRow& row = records.row();
    ImGui::Separator();
    ImGui::PushFont(context.fonts.bold);
    wrapped_text(context.text(row.en, row.ja));
    ImGui::PopFont();
    tip(context.text(row.source_en, row.source_ja));
    const forms::ElementRecord record = records.of(element);
    if (record.none) return dim_text(context, record.none->in(context.language()).c_str());
    ImGui::PushID(row.id.data(), row.id.data() + row.id.size());
    for (const RecordLine& line : record_lines(record.fields, context.language())) draw_line(context, line);
    ImGui::PopID();
  }

  // Values that have no room go on in the next line.
  void draw_line(PanelContext& context, const RecordLine& line) {
    const float right_edge = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float gap = 0.6f * ImGui::GetFontSize();
    const auto go_on = [&](const std::string& text) {
      if (ImGui::GetItemRectMax().x + gap + ImGui::CalcTextSize(text.c_str()).x < right_edge) ImGui::SameLine(0, gap);
    };
    ImGui::PushID(line.key.c_str());
    wrapped_text(line.key.c_str());
    go_on(line.word);
    if (needs_japanese(line.word.c_str()) && !std::exchange(context.state.shows_japanese, true))
      context.state.unsettle();
    dim_text(context, line.word.c_str());
    for (std::size_t i = 0; i < line.values.size(); ++i) {
      go_on(line.values[i]);
      draw_value(context, line, i);
    }
    if (!line.stored.empty()) {
      go_on(line.stored);
      dim_text(context, line.stored.c_str());
    }
    ImGui::PopID();
  }

  void draw_value(PanelContext& context, const RecordLine& line, std::size_t i) {
    const bool leads = !line.links.empty() && line.links[i].index != no_index;
    if (!leads) return wrapped_text(line.values[i].c_str());
    const Mesh& mesh = context.mesh();
    ImGui::PushID(static_cast<int>(i));
    if (link(context, line.values[i].c_str())) {
      const Element to = line.links[i];
      chosen_ =
          "select " + (to.kind == Element::Kind::vertex ? name_of_copy(mesh, to.vertex()) : name_to_select(mesh, to));
    }
    tip(name_and_slot(mesh, line.links[i]) + "\n" + context.text("A click selects it.", "クリックすると選択します。"));
    ImGui::PopID();
  }

  const forms::FormRow* shown_ = nullptr;  // null: all
  std::string chosen_;                     // the line of a link that was clicked in this frame
};

}  // namespace

std::unique_ptr<Panel> make_records_panel() { return std::make_unique<RecordsPanel>(); }

}  // namespace ryosen
