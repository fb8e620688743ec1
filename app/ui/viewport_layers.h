// Layers of the viewport that keep what they have drawn, to draw anew what has changed: labels, normals, verdicts.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "app/editor/document/change_feed.h"
#include "app/editor/labels/labels.h"
#include "render/renderer.h"
#include "ryosen/ops/preview/tool_verdicts.h"
#include "ryosen/scene/view/view_settings.h"

struct ImFontAtlas;

namespace ryosen {

class Findings;
class Gesturing;
class Session;
struct SeenMesh;

// The labels of a view in its picture. Loads its glyphs when there is something to write for the first time; until then
// it costs nothing.
class LabelLayer {
 public:
  LabelLayer();
  ~LabelLayer();

  // Of the display; 1 at first.
  void set_scale(float scale);
  // Places the labels as they are now and passes them to the renderer: those of the open mesh, or of one that is
  // compared with.
  void follow(Session& session, Renderer& renderer);
  void follow(const SeenMesh& compared, Renderer& renderer);

 private:
  using Place = std::function<std::vector<PlacedLabel>(const TextSize& size_of)>;

  // `place` is asked where there are any.
  void follow(bool has_any, const Place& place, Theme theme, Renderer& renderer);
  void load(Renderer& renderer);

  std::unique_ptr<ImFontAtlas> fonts_;  // null: to be loaded
  float scale_ = 1;
  bool has_japanese_ = false;  // from the first such text on
  bool is_empty_ = true;
};

// The overlay of normals: lines from the vertices or the middles of faces along them. At a vertex one line for each
// normal that smooth shading has there: several at creases. Drawn in blocks of elements, those that changed alone.
class NormalLines {
 public:
  // What changed in the mesh since the last call of follow().
  void note(const SeenMesh& seen, const ChangeFeed::Changes& changes, std::span<const std::uint32_t> triangles,
            bool everything);
  // Passes the lines to the renderer. Linear where the setting or the whole mesh is another.
  void follow(const SeenMesh& seen, Renderer& renderer);

 private:
  Overlay block(const SeenMesh& seen, std::uint32_t number) const;

  Normals drawn_ = Normals::off;
  Theme theme_ = Theme::dark;
  bool all_stale_ = true;
  double length_ = 0;
  std::vector<std::uint32_t> stale_;  // blocks
};

// The overlay of the verdicts of the tool in hand on all elements that it acts on. Drawn in blocks of elements: at
// first so many of them in a frame as cost few milliseconds, where the session asks in slices too, and shown when all
// are there; after an edit those with an element that was asked again.
class VerdictLayer {
 public:
  // All are drawn anew: something is hidden or shown, or it has another mesh.
  void forget() { is_stale_ = true; }
  // Passes to the renderer what has changed.
  void follow(Session& session, Renderer& renderer);
  // More is to be passed in the next frame, or to be asked before it.
  bool is_waiting() const { return is_waiting_; }

 private:
  void begin(Session& session, Renderer& renderer, const ToolVerdicts* verdicts);
  // Drops what an undo has taken away, and forgets a block that was or is not full.
  void follow_slots(Renderer& renderer, std::uint32_t slots);
  void draw_block(Findings& findings, const Gesturing& gesturing, Renderer& renderer, const ToolVerdicts& verdicts,
                  std::uint32_t block) const;

  bool is_stale_ = true, is_waiting_ = false;
  std::uint64_t serial_ = 0;  // of the verdicts that are drawn; 0 for none
  Theme theme_ = Theme::dark;
  std::uint32_t drawn_ = 0, slots_ = 0;  // blocks, and how many elements there were
  double room_ = 0;                      // of points
};

}  // namespace ryosen
