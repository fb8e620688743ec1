// The editor without window and picture: a document, what is selected and shown, where the camera is, what the pointer is
// on. The window, the command line, scripts and tests change it by the same command lines.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/editor/document.h"
#include "app/editor/recovery.h"
#include "app/editor/run_files.h"
#include "core/analysis/boundary_loop_count.h"
#include "core/analysis/euler_poincare.h"
#include "core/analysis/mesh_kind.h"
#include "core/highlights/highlight_sets.h"
#include "core/pick/picker.h"

namespace ryosen {

class Autosave;

// What the pointer is on and what a click there would do.
struct Hover {
  glm::dvec2 pixel{0};
  Picked picked;
  std::optional<AnyOp> op;  // with a tool that works on what was picked
  Preview preview;          // of that operator
};

class Session {
 public:
  explicit Session(std::unique_ptr<Document> document);

  Document& document() { return *document_; }
  const Document& document() const { return *document_; }
  const Mesh& mesh() const { return document_->mesh(); }

  // Carries out one command line (see commands.h) and logs it when it was done. Never throws for what a user types.
  Outcome run(const std::string& line);
  // The command lines done so far: a script that leads to the same state.
  const std::vector<std::string>& log() const { return log_; }

  // The state that commands change.
  Camera camera;
  Size view{1280, 720};
  glm::dvec2 view_origin{0};  // where the view begins in the picture or window that pixels are given in
  std::string tool;           // id of an operator, or empty: select
  PickMode mode = PickMode::edge;
  std::set<std::string> shown;  // ids of the highlight table
  std::vector<Element> selection;
  // The state of the user interface that commands change; it is kept, without effect, where there is none.
  Language language = Language::english;
  bool light_theme = false;
  std::string open_panel;               // the one that lies over the view; empty for none
  std::set<std::string> hidden_panels;  // of the columns
  std::string asked_algorithm;          // whose values the panel of values asks for
  std::vector<LostSession> lost;        // as they were listed last

  bool strict = false;  // warnings refuse too
  RunFiles files{
      RunFiles::Policy::by_kind};  // asked before a command writes; another policy is set by whoever runs scripts
  // Makes a picture of the session; set by whoever can draw. Commands that need it fail without.
  std::function<Status(const std::filesystem::path&)> take_picture;
  // Told how far long work is, and may cancel it; set by whoever can show it.
  Progress::Report on_progress;
  // Ends the session; set by the window.
  std::function<void()> quit;
  // Keeps what is done, for after a crash; set by the window, null elsewhere.
  Autosave* autosave = nullptr;

  // Pointing, at pixels from the upper left corner of the picture or window. The picker follows every edit.
  void point_at(glm::dvec2 pixel);
  void point_away() { hover_.reset(); }
  const std::optional<Hover>& hover() const { return hover_; }
  // What would make the operator under the pointer legal; empty where nothing was found. Looked for when asked, because
  // remedies are tried out, and remembered while neither the operator nor the mesh changes.
  const std::vector<std::string>& hover_remedy();
  // A click: applies the tool to what is under the pixel, or selects it.
  Outcome click(glm::dvec2 pixel, const std::string& with_tool);

  // The line of an operator on the selected elements, in their order; copies of a point are told apart.
  std::string line_on_selection(const OpInfo& op) const;

  // What lies under a pixel; nothing outside of the view.
  std::optional<Picked> pick(glm::dvec2 pixel, PickMode what);
  Picker& picker();
  // The sets of problems, and of the highlights that are shown.
  const HighlightSets& highlights();
  // The boundary loops on points, counted; as current as the highlights.
  const BoundaryLoopCount& boundary_loops();
  // The terms of the Euler–Poincaré sum on points. Kept through operators that keep the topology, else O(edges).
  const EulerPoincare& euler_terms();
  // What the mesh is, in one word. Where telling takes long (is_kind_evident, and a large mesh) it is not asked after
  // every edit, but only when `anew` says so; until then it is that of an earlier mesh.
  const KindOfMesh& kind(bool anew = false);
  bool is_kind_stale() const { return kind_revision_ != document_->revision(); }

  // Replaces the document; the selection, hover and log start anew.
  void set_document(std::unique_ptr<Document> document);
  // Where the mesh is: its vertices without the isolated ones, unless there are no others.
  std::vector<glm::dvec3> places_to_frame() const;
  void frame_all();
  void frame_selection();

  // An element that came into a set of the highlights, left it, or is in it and lies elsewhere now.
  using Marked = HighlightSets::Change;
  // What has changed since the last call, for what mirrors the drawn mesh. With `everything` the lists may be short:
  // take all of it anew. An entry may stand twice and may name what is dead or past the end.
  struct DrawnChanges {
    bool everything = true;
    std::vector<std::uint32_t> triangles;  // slots of picker().triangles()
    std::vector<std::uint32_t> vertices;   // made or moved
    std::vector<std::uint32_t> faces;      // with other corners, or in other sets of highlights that tint faces
    std::vector<Marked> marks;
    bool searched = true;  // for a highlight: take all marks and tints anew
  };
  DrawnChanges take_drawn_changes();

 private:
  void log_line(Outcome& outcome);
  void follow(std::size_t transaction);
  void note_marks(const TouchedElements& touched);
  void forget_hidden();
  Outcome apply_at(const OpTarget& target, const std::string& id);

  std::unique_ptr<Document> document_;
  std::optional<Picker> picker_;
  std::optional<HighlightSets> highlights_;
  std::optional<BoundaryLoopCount> boundary_loops_;
  std::optional<EulerPoincare> euler_;
  std::optional<KindOfMesh> kind_;
  std::uint64_t kind_revision_ = 0;
  std::optional<Hover> hover_;
  std::vector<std::string> log_;
  std::vector<std::string> remedy_;  // of the operator that remedy_line_ says, at remedy_revision_
  std::string remedy_line_;
  std::uint64_t remedy_revision_ = 0;
  DrawnChanges drawn_changes_;
};

}  // namespace ryosen
