#include "app/editor/document/repair_trials.h"
#include "app/editor/textbook/growth_work.h"
#include "app/ui/panels.h"
#include "app/ui/textbook/growth_plots.h"
#include "app/ui/widgets.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

using forms::GrowthOf;
using forms::GrowthRow;
using forms::Relation;
using forms::RelationRow;

// How the work of the forms grows with the number of faces, as curves; measured beside the frames when it is asked for.
class GrowthPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    if (work_.is_running()) return draw_progress(context);
    draw_buttons(context);
    if (work_.is_running()) return draw_progress(context);
    const std::span<const forms::GrowthCurve> curves = work_.curves();
    if (curves.empty()) return;
    choose_curves(context);
    if (curves.front().points.size() == 1)
      dim_text(context, context.text("Too few faces to be cut into growing parts: one size, no slopes.",
                                     "分割して増やすには面が足りません（一つの大きさだけ、傾きなし）。"));
    const LogPlot plot = growth_plot(curves, of_, relation_, axis_, context.language());
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos(), size = size_of_plot(plot, width);
    draw_log_plot(*ImGui::GetWindowDrawList(), corner, width, plot, context.theme);
    ImGui::Dummy(size);
  }

 private:
  void begin(PanelContext& context, const Mesh* mesh) {
    work_.begin(mesh);
    // A picture is not drawn again when it is there.
    if (!context.trials.in_background) work_.wait();
  }

  void draw_buttons(PanelContext& context) {
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (ImGui::Button(context.text("Tori", "トーラス"), {width, 0})) begin(context, nullptr);
    tip(context.text("Measures on tori of growing size, as text 000's figure 11.",
                     "テキスト 000 の図 11 のようなトーラスを大きくしながら測ります。"));
    ImGui::SameLine();
    const Mesh& mesh = context.mesh();
    ImGui::BeginDisabled(mesh.live().faces == 0);
    if (ImGui::Button(context.text("This mesh", "このメッシュ"), {width, 0})) begin(context, &mesh);
    ImGui::EndDisabled();
    tip(context.text("Measures on growing parts of this mesh.", "このメッシュの一部を大きくしながら測ります。"),
        ImGuiHoveredFlags_AllowWhenDisabled);
  }

  void draw_progress(PanelContext& context) {
    context.state.waits_for_work = true;
    ImGui::ProgressBar(static_cast<float>(work_.share()), {ImGui::GetContentRegionAvail().x, 0});
    if (ImGui::Button(context.text("Cancel", "中止"), {ImGui::GetContentRegionAvail().x, 0})) work_.cancel();
  }

  void choose_curves(PanelContext& context) {
    const auto name = [&](GrowthOf of, Relation relation) {
      const GrowthRow& row = forms::growth_rows()[static_cast<std::size_t>(of)];
      const RelationRow& asked = forms::relations()[static_cast<std::size_t>(relation)];
      if (of != GrowthOf::query) return std::string(context.text(row.en, row.ja));
      return context.text(row.en, row.ja) + std::string(context.text(": ", "：")) + context.text(asked.en, asked.ja);
    };
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (ImGui::BeginCombo("##of", name(of_, relation_).c_str())) {
      const auto choice = [&](GrowthOf of, Relation relation) {
        if (!ImGui::Selectable(name(of, relation).c_str(), of == of_ && relation == relation_)) return;
        of_ = of;
        relation_ = relation;
      };
      choice(GrowthOf::pairing, relation_);
      for (const RelationRow& row : forms::relations()) choice(GrowthOf::query, row.relation);
      choice(GrowthOf::collapse, relation_);
      ImGui::EndCombo();
    }
    const auto axis = [&](const char* label, GrowthAxis to) {
      if (ImGui::RadioButton(label, axis_ == to)) axis_ = to;
    };
    axis(context.text("Count", "回数"), GrowthAxis::count);
    ImGui::SameLine();
    axis(context.text("Time", "時間"), GrowthAxis::time);
  }

  GrowthWork work_;
  GrowthOf of_ = GrowthOf::pairing;
  Relation relation_ = Relation::vertex_faces;
  GrowthAxis axis_ = GrowthAxis::count;
};

}  // namespace

std::unique_ptr<Panel> make_growth_panel() { return std::make_unique<GrowthPanel>(); }

}  // namespace ryosen
