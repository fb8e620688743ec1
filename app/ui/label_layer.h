// The labels of a view in its picture.
#pragma once

#include <memory>

#include "app/editor/labels/labels.h"
#include "ryosen/scene/view/view_settings.h"

struct ImFontAtlas;

namespace ryosen {

class Renderer;

// Loads its glyphs when there is something to write for the first time; until then it costs nothing.
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

}  // namespace ryosen
