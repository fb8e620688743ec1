// What follows from the mesh of an open document and is kept up with its edits: the picker, highlights, values, counts,
// normals and kind; and which of its elements are hidden.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/change_feed.h"
#include "app/editor/document/preparation.h"
#include "app/editor/preferences/preference_values.h"
#include "ryosen/algo/repair/report.h"
#include "ryosen/analysis/measure/measured_surface.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/base/element.h"
#include "ryosen/base/message.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/scene/pick/hidden_elements.h"
#include "ryosen/scene/view/corner_normals.h"

namespace ryosen {

// The reasons why an algorithm with a goal left edges: under which rule each edge stands that it left. It means nothing
// after the next change.
struct LeftEdges {
  std::uint64_t serial, revision;   // of the document
  std::vector<std::uint8_t> rules;  // by edge slot, as EdgeRule, or no_rule
  std::vector<std::size_t> counts;  // by rule, counted on points
};

class Findings {
 public:
  // Each is found when it is first asked for. The views and the preferences say which highlights, values and normals
  // are wanted. All three outlive it.
  Findings(const Document& document, const ViewState& view, const Preferences& preferences);

  // Another view: what it shows is found and kept up, too. It outlives this or is removed.
  void add_view(const ViewState& view) { views_.push_back(&view); }
  void remove_view(const ViewState& view);
  // The further views of another document, whose place this one takes.
  void take_views_of(const Findings& other);

  const Mesh& mesh() const { return document_.mesh(); }

  // Brings what has been found up to date with a change of the document. Cost: of what was touched.
  void follow(const Journal& journal, std::size_t transaction, Document::Change change, const TouchedElements& touched);
  // Forgets everything that was found, and shows what was hidden: there was no memory to keep it up to date.
  void forget();

  // The triangles of the surface, and what picks among them; with a view as that cuts the mesh, until it is asked anew.
  Picker& picker();
  Picker& picker(const ViewState& view);
  // For smooth shading, and where normals of vertices are drawn. Kept up with edits as long as one of them is set.
  const CornerNormals& corner_normals();
  // The sets of problems, and of the highlights that are shown.
  const HighlightSets& highlights();
  // The values of a map, kept through edits as long as a view is coloured by it; and from the lowest to the highest.
  const MapValues& map_values(const Colouring& colouring);
  MapRange map_extent(const Colouring& colouring);
  // The number of boundary loops on points; as up to date as the highlights.
  const BoundaryLoopCount& boundary_loops();
  // The terms of the Euler–Poincaré sum on points. Kept through operators that keep the topology, else O(edges).
  const EulerPoincare& euler_terms();
  // The kind of mesh, in one word. If it is expensive (is_kind_evident, and a large mesh) it is recomputed only if
  // `anew`, not after every edit; until then it is that of an earlier mesh.
  const KindOfMesh& kind(bool anew = false);
  bool is_kind_stale() const { return kind_revision_ != document_.revision(); }

  // The findings of a kind that is searched for on request (ProblemRow::is_on_request): marked and listed until the
  // next edit. `pairs`: which of them belong together, as far as that is known.
  void put(ProblemKind kind, std::span<const std::uint32_t> found, std::vector<FacePair> pairs = {});
  void forget(ProblemKind kind);
  // Whether it was searched for since the last edit.
  bool has_searched(ProblemKind kind) const;
  struct Searched {
    ProblemKind kind;
    std::uint64_t document, revision;
    std::vector<FacePair> pairs;
  };
  // The last kind that was searched for; perhaps before an edit.
  const std::optional<Searched>& searched() const { return searched_; }
  // What a problem of this kind at an element is about; the element alone where it has none of it (of equal faces it is
  // the higher one that has it).
  std::vector<Element> about(const ProblemRow& row, Element element);

  // Hidden elements are neither drawn nor picked. No entry of the history: it lasts until they are shown, deleted or
  // renumbered. These return whether anything changed.
  const HiddenElements& hidden() const { return hidden_; }
  bool hide(std::span<const Element> elements);
  bool isolate(std::span<const Element> elements);
  bool unhide();
  void drop_hidden(Elements& elements) const;

  // For windows, before each frame: begins to find in the background what a large mesh needs to be picked and for its
  // lists of problems, or takes it over when it is found. Until then nothing is picked and no highlights are drawn;
  // what else asks for findings waits for them. An edit ends it, and waits for that.
  void prepare();
  // The share that is done while that goes on; none when everything is there.
  std::optional<double> preparing() const { return preparation_ ? std::optional(preparation_->share()) : std::nullopt; }
  // Ends that and waits for it: the document is about to be written.
  void end_preparation() { preparation_.reset(); }

  // What the last repair did and left; null where the document has changed since.
  const RepairReport* last_repair() const;
  void keep_report(RepairReport report);
  // What holds the edges that the last simplification left; null where the document has changed since.
  const LeftEdges* left_edges() const;
  void keep_left_edges(LeftEdges edges);

  // The findings of a mesh that this one is compared with, and that one's with this; null for none.
  Findings* against = nullptr;
  // The surface of the mesh, to which distances of another are measured. Made anew where the mesh has changed.
  std::shared_ptr<const OtherSurface> surface();

  // The changes of what is drawn.
  const ChangeFeed& changes() const { return changes_; }
  ChangeFeed& changes() { return changes_; }

  // For gestures, which draw vertices elsewhere than they are: the sets of highlights (null where nobody has asked for
  // them), what is called when they have been found anew, and a record of members that may have moved.
  HighlightSets* found_highlights() { return highlights_ ? &*highlights_ : nullptr; }
  std::function<void()> after_search;
  void note_marks(const TouchedElements& touched);

 private:
  struct KeptMap {
    MapValues values;
    std::optional<MapRange> extent;  // while the values are the same
  };

  template <class Wants>
  bool any_view(Wants wants) const;  // wants(view)
  bool is_shown(const HighlightRow& row) const;
  bool is_coloured_by(const ColourMap& map) const;
  bool needs_corner_normals() const;
  KeptMap& kept_map(const ColourMap& map);
  void follow_picker(const TouchedElements& touched);
  void follow_map_values(std::size_t transaction, bool is_trial);
  // The triangles at elements of that sort look otherwise.
  void note_coloured(Element::Kind sort, std::span<const std::uint32_t> changed);
  void follow_highlights(const Journal& journal, std::size_t transaction, const TouchedElements& touched);
  void follow_counts(std::size_t transaction, bool is_trial, const TouchedElements& touched);
  bool note_hiding(const HiddenElements::Parts& changed);
  void forget_unshown();
  void finish_preparation();
  std::shared_ptr<const OtherSurface> other_surface() { return against ? against->surface() : nullptr; }

  const Document& document_;
  std::vector<const ViewState*> views_;
  const Preferences& preferences_;
  ChangeFeed changes_;
  HiddenElements hidden_;
  std::optional<Picker> picker_;
  FileNormals file_normals_;
  std::optional<CornerNormals> corner_normals_;  // of the triangles of the picker
  std::optional<HighlightSets> highlights_;
  std::optional<Searched> searched_;
  std::list<KeptMap> maps_;  // of which views are coloured
  std::optional<BoundaryLoopCount> boundary_loops_;
  std::optional<EulerPoincare> euler_;
  std::optional<KindOfMesh> kind_;
  std::uint64_t kind_revision_ = 0;
  std::optional<std::uint64_t> unprepared_revision_;  // of the mesh that was too large to prepare
  std::shared_ptr<const OtherSurface> surface_;
  std::uint64_t surface_revision_ = 0;
  struct LastRepair {
    std::uint64_t serial, revision;  // of the document behind it
    RepairReport report;
  };
  std::optional<LastRepair> last_repair_;
  std::shared_ptr<const LeftEdges> left_edges_;
  std::unique_ptr<Preparation> preparation_;  // reads what stands above, so that it ends first
};

// How much is hidden, as a sentence.
Text hidden_text(const HiddenElements& hidden);

// A document with what is found in it; the findings keep what is hidden, too, and the feed of its changes.
struct OpenDocument {
  std::unique_ptr<Document> document;
  std::unique_ptr<Findings> findings;  // reads the document, so that it ends first
};

}  // namespace ryosen
