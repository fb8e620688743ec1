#include <algorithm>
#include <array>

#include "app/editor/commands.h"
#include "app/editor/quarantine_text.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "core/analysis/boundary_loops.h"
#include "core/analysis/problems.h"

namespace ryosen {

namespace {

// What was found of a kind, without a list of it. Cheap after an edit; only the list of boundary loops is made anew for
// nth() when the edit has changed loops.
class Findings {
 public:
  std::size_t count(Session& session, const ProblemRow& row);
  Element nth(Session& session, const ProblemRow& row, std::size_t n);

 private:
  void know(const Session& session);

  std::uint64_t known_document_ = 0;   // its serial number
  std::size_t known_quarantined_ = 0;  // how many faces; a repair may drop them
  std::array<std::vector<Element>, most_problem_kinds> quarantined_;
  std::vector<Element> loops_;  // by their lowest edges, as of this revision of the count
  std::optional<std::uint64_t> known_loops_;
};

void Findings::know(const Session& session) {
  const Document& document = session.document();
  if (known_document_ == document.serial() && known_quarantined_ == document.tables().quarantine.size()) return;
  known_quarantined_ = document.tables().quarantine.size();
  known_document_ = document.serial();
  known_loops_.reset();
  for (const ProblemRow& row : problem_table()) {
    std::vector<Element>& faces = quarantined_[static_cast<std::size_t>(row.kind)];
    faces.clear();
    if (!row.quarantined) continue;
    for (const QuarantinedFace& face : document.tables().quarantine)
      if (row.quarantined(face, session.mesh().file_vertices())) faces.emplace_back(Face(face.face));
  }
}

std::size_t Findings::count(Session& session, const ProblemRow& row) {
  know(session);
  if (row.quarantined) return quarantined_[static_cast<std::size_t>(row.kind)].size();
  if (row.kind == ProblemKind::boundary_loop) return session.boundary_loops().count();
  if (row.kind == ProblemKind::ring) return session.mesh().live().rings;
  return session.highlights().count(row.kind);
}

// The face of the n-th ring, face by face.
Face face_of_ring(Session& session, std::size_t n) {
  const Mesh& mesh = session.mesh();
  Face found;
  session.highlights().of(ProblemKind::ring).for_each([&](std::uint32_t i) {
    for (std::uint32_t r = mesh.first_ring(Face(i)); r != no_index && !found; r = mesh.ring(r).next)
      if (n-- == 0) found = Face(i);
  });
  return found;
}

Element Findings::nth(Session& session, const ProblemRow& row, std::size_t n) {
  know(session);
  if (row.quarantined) return quarantined_[static_cast<std::size_t>(row.kind)][n];
  if (row.kind == ProblemKind::ring) return face_of_ring(session, n);
  if (row.kind != ProblemKind::boundary_loop) {
    const std::uint32_t i = session.highlights().of(row.kind).nth(static_cast<std::uint32_t>(n));
    return row.vertex ? Element(Vertex(i)) : row.edge ? Element(Edge(i)) : Element(Face(i));
  }
  if (known_loops_ != session.boundary_loops().revision()) {
    Neighbourhood around(session.mesh());
    const BoundaryLoops loops = find_boundary_loops(around, session.highlights().of(row.kind));
    loops_.clear();
    for (std::size_t i = 0; i < loops.size(); ++i) loops_.emplace_back(edge(loops[i].front()));
    known_loops_ = session.boundary_loops().revision();
  }
  return loops_[n];
}

// Why a face is quarantined, and where in the file it stands.
Text why_quarantined(const PanelContext& context, Element face) {
  return quarantine_text(context.session.document().tables().quarantine, name_on_points(context.session.mesh(), face))
      .value_or(Text());
}

// Selects what the problem is about and flies there. Quarantined faces exist only in the file: they are told about.
void go_to(PanelContext& context, const ProblemRow& row, Element element) {
  if (row.quarantined) {
    Outcome told;
    told.sentence = why_quarantined(context, element);
    context.keep(std::move(told));
    return;
  }
  context.run("select " + std::string(row.id) + " " + name_to_select(context.session.mesh(), element));
  if (!context.session.selection.empty()) context.run("frame selected");
}

// Only visible rows are looked up and named.
void draw_elements(PanelContext& context, Findings& findings, const ProblemRow& row, std::size_t count) {
  Session& session = context.session;
  list_of_rows("elements", count, 6, [&](std::size_t i) {
    const Element element = findings.nth(session, row, i);
    const bool is_selected = !session.selection.empty() && session.selection[0] == element;
    const std::string name = fitted(name_on_points(session.mesh(), element), ImGui::GetContentRegionAvail().x);
    if (ImGui::Selectable(name.c_str(), is_selected)) go_to(context, row, element);
    if (row.quarantined) tip(why_quarantined(context, element).in(context.language()));
  });
}

// The repairs of a kind: one press does it; where a value is needed, its field is opened.
bool draw_repairs(PanelContext& context, ProblemKind kind) {
  bool is_pressed = false;
  for (const AlgorithmRow& repair : algorithm_table()) {
    if (std::find(repair.solves.begin(), repair.solves.end(), kind) == repair.solves.end()) continue;
    ImGui::PushID(repair.id.data());
    const char* const name = context.text(repair.name_en, repair.name_ja);
    const std::string shown = fitted(name, ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().FramePadding.x);
    if (ImGui::SmallButton(shown.c_str())) {
      is_pressed = true;
      if (ParameterValues(repair.parameters).missing())
        context.run("values " + std::string(repair.id));
      else
        context.run(called(repair, true));
    }
    const char* const help = context.text(repair.help_en, repair.help_ja);
    tip(shown == name ? help : std::string(name) + "\n" + help);
    ImGui::PopID();
  }
  return is_pressed;
}

void draw_kind(PanelContext& context, Findings& findings, const ProblemRow& row, std::size_t count) {
  const bool is_problem = row.severity == ProblemSeverity::problem;
  ImGui::PushID(static_cast<int>(row.kind));
  const std::string label = grouped(static_cast<std::int64_t>(count)) + "  " + context.text(row.name_en, row.name_ja);
  const float room = ImGui::GetContentRegionAvail().x - ImGui::GetTreeNodeToLabelSpacing();
  ImGui::PushStyleColor(ImGuiCol_Text,
                        is_problem ? context.colours().refused : ImGui::GetStyleColorVec4(ImGuiCol_Text));
  const bool is_open = ImGui::TreeNodeEx("kind", ImGuiTreeNodeFlags_SpanAvailWidth, "%s", fitted(label, room).c_str());
  ImGui::PopStyleColor();
  tip(row.sentence(count).in(context.language()));
  if (is_open) {
    // A repair may have removed what was counted.
    if (!draw_repairs(context, row.kind)) draw_elements(context, findings, row, count);
    ImGui::TreePop();
  }
  ImGui::PopID();
}

// Everything that is wrong with the mesh; a click goes there.
class ProblemsPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    bool found = false;
    for (const ProblemRow& row : problem_table()) {
      const std::size_t count = findings_.count(context.session, row);
      if (count == 0) continue;
      found = true;
      draw_kind(context, findings_, row, count);
    }
    if (!found) coloured_text(context.colours().legal, context.text(UiText::no_problems));
  }

 private:
  Findings findings_;
};

}  // namespace

std::unique_ptr<Panel> make_problems_panel() { return std::make_unique<ProblemsPanel>(); }

}  // namespace ryosen
