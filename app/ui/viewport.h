// Draws what MeshView picks in: passes changes of a mesh, its highlights, selection and hover preview to the renderer.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/change_feed.h"
#include "app/ui/frame_pace.h"
#include "app/ui/viewport_layers.h"
#include "render/canvas.h"
#include "render/renderer.h"
#include "ryosen/base/element.h"
#include "ryosen/scene/pick/picker.h"

namespace ryosen {

class Compared;
class Findings;
class Pointing;
class Selecting;
class Session;
struct SeenMesh;

class Viewport {
 public:
  // Needs a current context, which must outlive it.
  static Result<std::unique_ptr<Viewport>> make();

  // Applies what changed in the session since the last call: size, settings, camera, mesh, overlays. Cheap if nothing
  // did.
  void follow(Session& session);
  // For windows, between follow() and draw(): the next draw() shows a part of the surface if the camera moves, and of
  // the rest a slice if it has come to rest. A while after the last change it refines the picture.
  void keep_pace(const ViewState& view, FramePace::Clock::time_point now);
  // What that draw() took.
  void took(FramePace::Clock::duration time);
  // When the next frame is due, though nothing happens; none if the whole is drawn.
  std::optional<FramePace::Clock::duration> time_to_next_frame(FramePace::Clock::time_point now) const;
  // For windows, once: makes what refining needs while nobody waits for a reaction.
  void prepare_refining(Session& session);
  // From now on all is drawn at once, until keep_pace() is called again, and then refined.
  void hurry();
  // Redraws what changed.
  void draw();
  // Whether the last draw() refined the picture, and the next one goes on.
  bool goes_on_refining() const;
  // Whether nothing is left to be drawn or refined.
  bool is_finished() const;

  void set_transparent(bool transparent);
  void set_supersample(int samples);
  // Forgets the document, so that the next follow() rebuilds everything.
  void forget();
  // How often the whole mesh was passed to the view.
  std::size_t rebuilds() const { return rebuilds_; }

  Renderer& renderer() { return *renderer_; }
  // The viewport of a mesh that is compared with, as of the last follow(); null where there is none.
  Viewport* compared() { return compared_.get(); }
  // The picture of the mesh, and of one that is compared with, with their places in the window.
  std::vector<Canvas::Placed> placed() const;

 private:
  explicit Viewport(std::unique_ptr<Renderer> renderer) : renderer_(std::move(renderer)) {}
  void follow_compared(Session& session);
  void follow(Compared& compared, const Pointing& pointing);
  void follow_look(const SeenMesh& seen);  // size, settings and camera
  // `selecting`: what is selected of it, null for nothing. `step`: the places are others where it is.
  void follow_mesh(const SeenMesh& seen, const Selecting* selecting, std::uint64_t step);
  std::optional<FramePace::Clock::duration> time_to_own_frame(FramePace::Clock::time_point now) const;
  // Adds the faces, and the slots of their triangles, that were selected or are no longer.
  void follow_selected_faces(Findings& findings, const Selecting& selecting, std::vector<std::uint32_t>& faces,
                             std::vector<std::uint32_t>& triangles);
  void follow_overlays(Session& session);
  void follow_highlights(const SeenMesh& seen);
  void follow_mark(const SeenMesh& seen, const HighlightRow& row, Mark mark);
  void draw_mark(const SeenMesh& seen, const HighlightRow& row, Mark mark, std::uint32_t block);

  std::unique_ptr<Renderer> renderer_;
  glm::ivec2 origin_{0};
  bool is_transparent_ = false;
  std::unique_ptr<Viewport> compared_;
  PickMode sort_ = PickMode::edge;  // of element under the pointer: vertices get dots
  LabelLayer labels_;
  NormalLines normal_lines_;
  VerdictLayer verdict_layer_;
  FramePace pace_;
  FramePace::Clock::time_point changed_at_;
  ViewSettings settings_;
  int supersample_ = 1, samples_ = 0;  // those that were set, and those that are drawn
  Size size_{};
  const Document* mesh_of_ = nullptr;
  struct Look {
    Shading shading = Shading::flat;
    std::optional<Colouring> colouring = {};
    FileColours file_colours = FileColours::on;
    double crease_deg = 30;
    bool operator==(const Look&) const = default;
  };
  Look drawn_look_;  // with which the mesh was passed
  std::vector<std::uint8_t> face_tints_;
  std::size_t rebuilds_ = 0;
  std::uint64_t mesh_revision_ = 0, gesture_step_ = 0;
  std::set<std::string> shown_;
  // Highlights are drawn in blocks of so many slots of a mark, and a block is drawn anew when a member of it has
  // changed.
  static constexpr std::uint32_t block_slots = 512;
  struct DrawnMark {
    IndexSet blocks;  // non-empty ones
    bool is_shown = false;
    double room = 0;  // of its points
  };
  std::map<std::uint32_t, DrawnMark> drawn_marks_;  // by their places in the order of drawing
  ChangeFeed::Cursor seen_;
  std::uint64_t seen_slots_ = 0;            // of the picker
  std::vector<ChangeFeed::Marked> marked_;  // to be rebuilt
  bool highlights_stale_ = true;            // all of them
  bool selection_stale_ = true;
  bool draws_links_ = false;
  std::uint64_t selection_ = 0;                           // by its stamp
  std::vector<Elements> measures_;                        // as they were drawn
  IndexSet selected_faces_;                               // as they were drawn
  std::pair<std::uint64_t, std::uint64_t> left_edges_{};  // the document and the revision of that which was drawn
  std::optional<Element> asked_;                          // that was drawn as what a question is about
  std::pair<std::uint64_t, std::size_t> step_{};  // the player that was drawn, by its serial number, and how far
};

}  // namespace ryosen
