#include <algorithm>
#include <array>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "app/ui/panels.h"
#include "app/ui/repair_rows.h"
#include "app/ui/widgets.h"
#include "ryosen/algo/repair/side_effects.h"
#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/analysis/problems.h"
#include "ryosen/document/outcome.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

// The face of the n-th ring, face by face.
Face face_of_ring(Findings& findings, std::size_t n) {
  const Mesh& mesh = findings.mesh();
  Face found;
  findings.highlights().of(ProblemKind::ring).for_each([&](std::uint32_t i) {
    for (std::uint32_t r = mesh.first_ring(Face(i)); r != no_index && !found; r = mesh.ring(r).next)
      if (n-- == 0) found = Face(i);
  });
  return found;
}

// What was found of a kind, without a list of it. Cheap after an edit; only the list of boundary loops is made anew for
// nth() when the edit has changed loops.
class ProblemFindings {
 public:
  std::size_t count(const Document& document, Findings& findings, const ProblemRow& row) {
    know(document);
    if (row.quarantined) return quarantined_[static_cast<std::size_t>(row.kind)].size();
    if (row.kind == ProblemKind::boundary_loop) return findings.boundary_loops().count();
    if (row.kind == ProblemKind::ring) return document.mesh().live().rings;
    return findings.highlights().count(row.kind);
  }

  Element nth(const Document& document, Findings& findings, const ProblemRow& row, std::size_t n) {
    know(document);
    if (row.quarantined) return quarantined_[static_cast<std::size_t>(row.kind)][n];
    if (row.kind == ProblemKind::ring) return face_of_ring(findings, n);
    if (row.kind != ProblemKind::boundary_loop) {
      const std::uint32_t i = findings.highlights().of(row.kind).nth(static_cast<std::uint32_t>(n));
      return row.element(i);
    }
    if (known_loops_ != findings.boundary_loops().revision()) {
      Neighbourhood around(document.mesh());
      const BoundaryLoops loops = find_boundary_loops(around, findings.highlights().of(row.kind));
      loops_.clear();
      for (std::size_t i = 0; i < loops.size(); ++i) loops_.emplace_back(edge(loops[i].front()));
      known_loops_ = findings.boundary_loops().revision();
    }
    return loops_[n];
  }

 private:
  void know(const Document& document) {
    if (known_document_ == document.serial() && known_quarantined_ == document.tables().quarantine.size()) return;
    known_quarantined_ = document.tables().quarantine.size();
    known_document_ = document.serial();
    known_loops_.reset();
    for (const ProblemRow& row : problem_table()) {
      std::vector<Element>& faces = quarantined_[static_cast<std::size_t>(row.kind)];
      faces.clear();
      if (!row.quarantined) continue;
      for (const QuarantinedFace& face : document.tables().quarantine)
        if (row.quarantined(face, document.mesh().file_vertices())) faces.emplace_back(Face(face.face));
    }
  }

  std::uint64_t known_document_ = 0;   // its serial number
  std::size_t known_quarantined_ = 0;  // how many faces; a repair may drop them
  std::array<std::vector<Element>, most_problem_kinds> quarantined_;
  std::vector<Element> loops_;  // by their lowest edges, as of this revision of the count
  std::optional<std::uint64_t> known_loops_;
};

// Why a face is quarantined, and where in the file it stands.
Text why_quarantined(const PanelContext& context, Element face) {
  return quarantine_text(context.document().tables().quarantine, name_on_points(context.mesh(), face)).value_or(Text());
}

// Selects what the problem is about and flies there. Quarantined faces exist only in the file: they are told about.
void go_to(PanelContext& context, const ProblemRow& row, Element element) {
  if (row.quarantined) {
    Outcome told;
    told.sentence = why_quarantined(context, element);
    context.keep(std::move(told));
    return;
  }
  context.run(select_line(row, name_to_select(context.mesh(), element)));
  if (!context.selecting.selection.empty()) context.run("frame selected");
}

// What a kind keeps while the pointer stays in the panel after a repair, so that no row moves under it.
struct HeldKind {
  ProblemKind kind;
  std::size_t rows;  // of its list of elements, at least
};

constexpr std::size_t most_rows = 6;

// Everything that is wrong with the mesh; a click goes there.
class ProblemsPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    const ImVec2 pointer = ImGui::GetIO().MousePos, first = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const bool is_inside = pointer.x >= first_.x && pointer.x < last_.x && pointer.y >= first_.y && pointer.y < last_.y;
    if (!is_inside || held_document_ != context.document().serial()) held_.clear();
    bool has_finding = false;
    for (const ProblemRow& row : problem_table())
      has_finding |= findings_.count(context.document(), context.findings(), row) > 0;
    if ((context.session.frontend.begins_empty || context.session.frontend.awaits_file) &&
        context.mesh().live() == ElementCounts()) {
      dim_text(context, context.text("There is no mesh yet.", "まだメッシュがありません。"));
    } else if (!has_finding && held_.empty()) {
      coloured_text(context.colours().legal, context.text(UiText::no_problems));
    } else {
      if (held_.empty()) offers_more_ = is_only_degenerate(context.document(), context.findings());
      if (repairs_.draw_all(context, !has_finding)) hold(context.document(), context.findings());
      if (offers_more_ && repairs_.draw_beyond_all(context, ProblemKind::degenerate_area, !has_finding))
        hold(context.document(), context.findings());
      draw_kinds(context);
    }
    draw_left(context);
    draw_loose(context);
    draw_searches(context);
    repairs_.end_frame(context);
    first_ = first;
    last_ = {first.x + width, ImGui::GetCursorScreenPos().y};
  }

 private:
  // Those that are held keep their places; what a repair has brought forth comes behind them.
  void draw_kinds(PanelContext& context) {
    std::vector<ProblemKind> kinds;
    for (const HeldKind& held : held_) kinds.push_back(held.kind);
    for (const ProblemRow& row : problem_table())
      if (!held(row.kind) && findings_.count(context.document(), context.findings(), row) > 0)
        kinds.push_back(row.kind);
    for (const ProblemKind kind : kinds)
      draw_kind(context, row_of(kind), findings_.count(context.document(), context.findings(), row_of(kind)));
  }

  void draw_kind(PanelContext& context, const ProblemRow& row, std::size_t count) {
    const bool is_mended = count == 0;
    const bool is_problem = row.severity == ProblemSeverity::problem;
    ImGui::PushID(static_cast<int>(row.kind));
    std::string label = grouped(static_cast<std::int64_t>(count)) + "  " + row.name_of(count).in(context.language());
    if (is_mended) label += context.text(": mended", "：修復済み");
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetTreeNodeToLabelSpacing();
    ImGui::PushStyleColor(ImGuiCol_Text, is_mended    ? context.colours().legal
                                         : is_problem ? context.colours().refused
                                                      : ImGui::GetStyleColorVec4(ImGuiCol_Text));
    const bool is_open =
        ImGui::TreeNodeEx("kind", ImGuiTreeNodeFlags_SpanAvailWidth, "%s", fitted(label, room).c_str());
    ImGui::PopStyleColor();
    tip(row.sentence(count).in(context.language()));
    if (is_open) {
      // Carried out behind this frame.
      if (repairs_.draw(context, row.kind, is_mended)) hold(context.document(), context.findings());
      if (!row.by_hand_en.empty() && !is_mended) dim_text(context, context.text(row.by_hand_en, row.by_hand_ja));
      draw_elements(context, row, count);
      ImGui::TreePop();
    }
    ImGui::PopID();
  }

  // Only visible rows are looked up and named.
  void draw_elements(PanelContext& context, const ProblemRow& row, std::size_t count) {
    const std::size_t rows = std::min(count, most_rows);
    if (rows > 0)
      list_of_rows("elements", count, most_rows, [&](std::size_t i) {
        const Element element = findings_.nth(context.document(), context.findings(), row, i);
        const bool is_selected = !context.selecting.selection.empty() && context.selecting.selection[0] == element;
        const std::string name = fitted(name_on_points(context.mesh(), element), ImGui::GetContentRegionAvail().x);
        if (ImGui::Selectable(name.c_str(), is_selected)) go_to(context, row, element);
        if (row.quarantined) tip(why_quarantined(context, element).in(context.language()));
      });
    const HeldKind* const held = this->held(row.kind);
    if (!held || held->rows <= rows) return;
    const float pitch = ImGui::GetTextLineHeightWithSpacing(), gap = rows > 0 ? ImGui::GetStyle().ItemSpacing.y : 0;
    ImGui::Dummy({1, static_cast<float>(held->rows - rows) * pitch - gap});
  }

  // What the last repair left, and why: below all rows, so that it moves none of them.
  void draw_left(PanelContext& context) {
    const RepairReport* const report = context.findings().last_repair();
    if (!report || report->left.empty()) return;
    ImGui::Separator();
    ImGui::TextUnformatted(context.text("Not mended", "直せなかったもの"));
    const std::vector<LeftForReason> all = report->left;  // a press may take it away
    for (std::size_t i = 0; i < all.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      dim_text(context, capitalized((all[i].reason + Text{".", "。"}).in(context.language())).c_str());
      std::vector<Element> there;
      constexpr std::size_t most = 24;
      for (const Element& element : all[i].elements)
        if (there.size() < most && is_alive(context.mesh(), element)) there.push_back(element);
      const std::uint64_t revision = context.document().revision();
      if (!there.empty() && element_links(context, there) && revision == context.document().revision())
        context.run("frame selected");
      ImGui::PopID();
    }
  }

  // Offers to delete the loose pieces of the last repair.
  void draw_loose(PanelContext& context) {
    const RepairReport* const report = context.findings().last_repair();
    if (!report) return;
    const auto loose = std::find_if(report->left.begin(), report->left.end(), tells_of_loose_pieces);
    if (loose == report->left.end()) return;
    std::string names;
    for (const Element& face : loose->elements) names += " f" + std::to_string(face.index);
    const std::string count = grouped(static_cast<std::int64_t>(loose->elements.size()));
    const Text select{"Select the loose pieces (" + count + ")", "離れた部分を選択（" + count + "）"};
    const Text remove{"Delete the loose pieces (" + count + ")", "離れた部分を削除（" + count + "）"};
    for (const auto& [text, command] : {std::pair(select, "frame selected"), std::pair(remove, "delete selected")})
      if (link(context, text.in(context.language()).c_str())) {
        context.run("select" + names);
        context.run("select linked");
        context.run(command);
        return;
      }
  }

  // Whether nothing is wrong but faces without area, for which no repair is that keeps geometry.
  bool is_only_degenerate(const Document& document, Findings& findings) {
    return std::all_of(problem_table().begin(), problem_table().end(), [&](const ProblemRow& row) {
      const bool is_degenerate = row.kind == ProblemKind::degenerate_area;
      return row.severity != ProblemSeverity::problem ||
             (findings_.count(document, findings, row) > 0) == is_degenerate;
    });
  }

  // What nobody searches for unasked, until it is asked for.
  void draw_searches(PanelContext& context) {
    if (context.mesh().live().faces == 0 || context.findings().has_searched(ProblemKind::self_intersection)) return;
    if (link(context, context.text("Search for self-intersections", "自己交差を探す")))
      context.run("self_intersections");
    tip(context.text("Faces that meet others elsewhere than in common vertices and edges. It may take a moment.",
                     "共有する頂点・稜線以外で他の面と交わる面を探します。少し時間がかかることがあります。"));
  }

  const HeldKind* held(ProblemKind kind) const {
    const auto at = std::find_if(held_.begin(), held_.end(), [&](const HeldKind& h) { return h.kind == kind; });
    return at == held_.end() ? nullptr : &*at;
  }

  void hold(const Document& document, Findings& findings) {
    held_document_ = document.serial();
    for (const ProblemRow& row : problem_table())
      if (const std::size_t count = findings_.count(document, findings, row); count > 0 && !held(row.kind))
        held_.push_back({row.kind, std::min(count, most_rows)});
  }

  ProblemFindings findings_;
  RepairRows repairs_;
  std::vector<HeldKind> held_;       // as they are drawn; empty: nothing is held
  std::uint64_t held_document_ = 0;  // its serial number
  bool offers_more_ = false;         // beside Repair all; as long as rows are held, as before
  ImVec2 first_, last_;              // the corners of the panel in the last frame
};

}  // namespace

std::unique_ptr<Panel> make_problems_panel() { return std::make_unique<ProblemsPanel>(); }

}  // namespace ryosen
