// The labels of a session in the picture of its view.
#pragma once

#include <memory>

#include "app/editor/labels/labels.h"

struct ImFontAtlas;

namespace ryosen {

class View;

// Loads its glyphs when there is something to write for the first time; until then it costs nothing.
class LabelLayer {
 public:
  LabelLayer();
  ~LabelLayer();

  // Of the display; 1 at first.
  void set_scale(float scale);
  // Places the labels as the session is now and passes them to the view.
  void follow(Session& session, View& view);

 private:
  void load(View& view);

  std::unique_ptr<ImFontAtlas> fonts_;  // null: to be loaded
  float scale_ = 1;
  bool has_japanese_ = false;  // from the first such text on
  bool is_empty_ = true;
};

}  // namespace ryosen
