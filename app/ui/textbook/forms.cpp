#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/textbook/forms/comparison.h"

namespace ryosen {

namespace {

// Short enough to run synchronously.
constexpr forms::Effort effort{0.0005, 2e7};

void right_aligned(const std::string& text) {
  ImGui::TableNextColumn();
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  if (room > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
  ImGui::TextUnformatted(text.c_str());
}

bool begin_table(const char* id, int columns, float figure_ems) {
  if (!ImGui::BeginTable(id, columns, ImGuiTableFlags_RowBg)) return false;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
  for (int i = 1; i < columns; ++i)
    ImGui::TableSetupColumn("figure", ImGuiTableColumnFlags_WidthFixed, figure_ems * ImGui::GetFontSize());
  return true;
}

void choose_relation(PanelContext& context, forms::Relation& chosen) {
  const forms::RelationRow& shown = forms::relations()[static_cast<std::size_t>(chosen)];
  ImGui::AlignTextToFramePadding();
  dim_text(context, context.text("Query", "問い合わせ"));
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (!ImGui::BeginCombo("##relation", context.text(shown.en, shown.ja))) return;
  for (const forms::RelationRow& relation : forms::relations())
    if (ImGui::Selectable(context.text(relation.en, relation.ja), relation.relation == shown.relation))
      chosen = relation.relation;
  ImGui::EndCombo();
}

void draw_form(PanelContext& context, const forms::FormFigures& figures, std::uint32_t faces,
               forms::Relation relation) {
  const forms::FormRow& row = *figures.row;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (figures.unsuitable) {
    dim_text(context, context.text(row.en, row.ja));
    tip(figures.unsuitable->in(context.language()));
    right_aligned("-");
    right_aligned("-");
    return;
  }
  wrapped_text(context.text(row.en, row.ja));
  tip(context.text(row.source_en, row.source_ja));
  right_aligned(faces > 0 ? forms::figure_text(static_cast<double>(figures.bytes) / faces) : "-");
  const auto& seconds = figures.query_seconds[static_cast<std::size_t>(relation)];
  right_aligned(seconds ? forms::figure_text(1e9 * *seconds) : "-");
}

void draw_query_times(PanelContext& context, const forms::Comparison& comparison, forms::Relation relation) {
  if (!begin_table("forms", 3, 3.4f)) return;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  right_aligned(context.text("B/face", "B/面"));
  tip(context.text("bytes per face", "面あたりのバイト数"));
  right_aligned("ns");
  tip(context.text("- : the form cannot tell, or cannot hold this mesh",
                   "- ：答えられない、またはこのメッシュを持てない"));
  for (const forms::FormFigures& figures : comparison.forms) draw_form(context, figures, comparison.faces, relation);
  ImGui::EndTable();
}

void draw_pairing_times(PanelContext& context, const forms::Comparison& comparison) {
  dim_text(context, context.text("Pairing the halfedges", "半稜線の対を見つける方法"));
  if (!begin_table("pairing", 2, 4.6f)) return;
  for (const forms::PairingFigures& figures : comparison.pairing) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    wrapped_text(context.text(figures.method->en, figures.method->ja));
    right_aligned(forms::duration_text(figures.seconds) + (figures.is_whole() ? "" : "*"));
    const std::string part = std::to_string(figures.faces), all = std::to_string(figures.all_faces);
    if (!figures.is_whole())
      tip(Text{"on the first " + part + " of " + all + " faces alone",
               "最初の " + part + " 面のみ（全 " + all + " 面）"}
              .in(context.language()));
  }
  ImGui::EndTable();
}

void draw_texts(PanelContext& context, const forms::Comparison& comparison) {
  dim_text(context, context.text("The source texts' own code at a border", "境界でのテキストのコード"));
  for (const forms::SourceReport& report : comparison.texts) {
    wrapped_text(report.what.in(context.language()).c_str());
    tip(report.outcome.sentence.in(context.language()));
    dim_text(context, report.outcome.changed_before
                          ? context.text("undefined, half done", "途中まで書き換えて未定義動作")
                          : context.text("undefined at once", "直ちに未定義動作"));
  }
}

// The forms of the source texts side by side for this mesh, measured when the button is pressed.
class FormsPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    if (measured_ && measured_->document != context.document().serial()) measured_.reset();
    const char* const label =
        measured_ ? context.text("Measure again", "もう一度測る") : context.text("Measure", "測る");
    if (ImGui::Button(label, {ImGui::GetContentRegionAvail().x, 0}))
      measured_ = {forms::compare_forms(context.mesh(), effort), context.document().serial(),
                   context.document().revision()};
    tip(context.text("Builds every form of this mesh and times what it is asked.",
                     "このメッシュのすべての表現を作り、問い合わせにかかる時間を測ります。"));
    if (!measured_) return;
    if (measured_->revision != context.document().revision())
      coloured_text(context.colours().warning,
                    context.text("The mesh has changed since.", "測った後にメッシュが変わりました。"));
    choose_relation(context, relation_);
    draw_query_times(context, measured_->comparison, relation_);
    for (const forms::ComparedClaim& compared : forms::compare_claims(measured_->comparison)) {
      dim_text(context, compared.sentence.in(context.language()).c_str());
      tip(context.text(compared.claim->why_en, compared.claim->why_ja));
    }
    draw_pairing_times(context, measured_->comparison);
    draw_texts(context, measured_->comparison);
  }

 private:
  // Of which state of which document.
  struct Measured {
    forms::Comparison comparison;
    std::uint64_t document = 0;  // its serial number
    std::uint64_t revision = 0;
  };
  std::optional<Measured> measured_;
  forms::Relation relation_ = forms::Relation::vertex_vertices;  // whose query times are shown
};

}  // namespace

std::unique_ptr<Panel> make_forms_panel() { return std::make_unique<FormsPanel>(); }

}  // namespace ryosen
