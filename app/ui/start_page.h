// What lies over the view while there is no mesh: ways to begin, and how to go on.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/ui/panels.h"

namespace ryosen {

// The arrow keys go from one entry to the next, Enter takes it, as a click does. Where not all of it has room its parts
// stand behind tabs.
class StartPage {
 public:
  // While the session is at its start and no panel lies over the view.
  static bool is_shown(const Session& session);
  // Whether it takes a key in place of the command that this is bound to.
  static bool takes(std::string_view chord);

  void draw(PanelContext& context);

 private:
  enum class Part : std::uint8_t { beginnings, shapes, exercises, figures };
  struct Entry {
    std::string line;  // what it sends; empty where it cannot be taken
    ImVec2 first, last;
    std::optional<Part> opens{};  // of a tab
  };
  // What the page is as high by.
  struct Measured {
    float width, em;
    Language language;
    std::size_t recent;
    bool operator==(const Measured&) const = default;
  };

  void draw_whole(PanelContext& context);
  void draw_tabs(PanelContext& context, float height);
  void draw_beginnings(PanelContext& context, std::size_t most_recent);
  void draw_recent(PanelContext& context, std::size_t most);
  void draw_shapes(PanelContext& context);
  void draw_exercises(PanelContext& context);  // this and the next: textbook/offered.cpp
  void draw_figures(PanelContext& context);
  void look_for_recent(const std::vector<std::string>& files);
  // An entry as wide as there is room, or as its name.
  void entry(PanelContext& context, const std::string& name, const std::string& line, bool fills);
  // That of the keys, where the last entry has it.
  void mark_focus(PanelContext& context) const;
  void take(const Entry& entry);
  void follow_keys();

  std::vector<Entry> entries_;  // of this frame, in their order
  std::size_t focus_ = 0;
  bool has_keys_ = false;                             // an arrow key was pressed: the focus is drawn
  std::string taken_;                                 // the line of what was clicked or entered in this frame
  std::vector<std::pair<std::string, bool>> recent_;  // and whether each is there
  Part part_ = Part::beginnings;                      // that is shown where the page is too high for its window
  std::optional<Measured> measured_;                  // when it was last drawn whole,
  float whole_height_ = 0;                            // and how high it was then
};

}  // namespace ryosen
