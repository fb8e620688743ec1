// What lies over the view while there is no mesh: ways to begin, and how to go on.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/ui/panels.h"

namespace ryosen {

// The arrow keys go from one entry to the next, Enter takes it, as a click does.
class StartPage {
 public:
  // While the session is at its start and no panel lies over the view.
  static bool is_shown(const Session& session) { return session.is_at_start() && session.open_panel.empty(); }
  // Whether it takes a key in place of the command that this is bound to.
  static bool takes(std::string_view chord);

  void draw(PanelContext& context);

 private:
  struct Entry {
    std::string line;  // what it sends; empty where it cannot be taken
    ImVec2 first, last;
  };

  void draw_beginnings(PanelContext& context);
  void draw_recent(PanelContext& context);
  void draw_shapes(PanelContext& context);
  void draw_figures(PanelContext& context);
  void look_for_recent(const std::vector<std::string>& files);
  // An entry as wide as there is room, or as its name.
  void entry(PanelContext& context, const std::string& name, const std::string& line, bool fills);
  void follow_keys();

  std::vector<Entry> entries_;  // of this frame, in their order
  std::size_t focus_ = 0;
  bool has_keys_ = false;                             // an arrow key was pressed: the focus is drawn
  std::string taken_;                                 // the line of what was clicked or entered in this frame
  std::vector<std::pair<std::string, bool>> recent_;  // and whether each is there
};

}  // namespace ryosen
