// The window's content: the panels laid out around the view by Dear ImGui. Knows neither GL nor the window; whoever has
// them gives it input and draws what it lays out.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/ui/panels.h"

struct ImGuiContext;
struct ImDrawData;
struct ImFontAtlas;

namespace ryosen {

// Owns a Dear ImGui context, which is the current one from construction on.
class Gui {
 public:
  // `scale` is that of the display: 1 for about 96 pixels an inch.
  explicit Gui(float scale);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  // A panel beside those of the list, for programs with panels of their own: behind them in its column and the menu, and
  // known to the command `panel` while this lives. The row's texts must live as long.
  void add_panel(const PanelRow& row, std::unique_ptr<Panel> panel);
  // Another scale, as of the next prepare().
  void set_scale(float scale);
  // The part of a window that the view has.
  PixelRect view_area(Size window) const;
  // Gives the session that part.
  void place_view(Session& session, Size window) const;

  // Takes over theme and language. True when the glyphs have changed: their texture must be made anew before the frame.
  bool prepare(const Session& session);
  // Lays out one frame and does the long work that it asks for; prepare() comes first. The very first frame shows
  // nothing and a panel may need two more to find its size, so a picture takes three.
  void frame(Session& session, Size window, double seconds);
  // Lays out nothing but how far long work is, for the time that it goes on; the mesh is not looked at. True when the
  // user asks to cancel it. Call it between frames.
  bool progress_frame(Language language, Size window, double seconds, double share);
  const ImDrawData& draw_data() const;
  ImFontAtlas& fonts() const;

  // Input. Presses are kept until a frame has seen them, however short they are. Keys are those that edit text.
  void pointer(glm::dvec2 pixel);
  void button(int number, bool is_down);
  void wheel(double steps);
  void character(unsigned code);
  void key(int imgui_key, bool is_down);
  void modifiers(bool shift, bool ctrl);
  // Is a pixel the panels', or are the keys?
  bool owns_pointer(const Session& session, Size window, glm::dvec2 pixel) const;
  bool owns_keys() const;

  // As panels do: with the outcome kept for the status line.
  Outcome run(Session& session, const std::string& line);
  Outcome click(Session& session, glm::dvec2 pixel);
  void leave(Session& session, PendingLeave where);
  // What the status line says of the last command.
  const Text& said() const { return state_.last_outcome; }
  // Between the begin and the end of a frame, when no other can be laid out.
  bool is_laying_out() const { return state_.is_laying_out; }
  bool wants_quit() const { return state_.wants_quit; }

 private:
  struct OwnPanel {
    PanelRow row;
    std::unique_ptr<Panel> panel;
    std::unique_ptr<ScopedPanel> added;  // null for those of the list
  };

  PanelContext context(Session& session);
  void draw_column(PanelContext& context, PanelPlace place, float x, float y, float width, float height);
  void begin_frame(Size window, double seconds);
  void end_frame();

  ImGuiContext* imgui_;
  float scale_;
  GuiState state_;
  std::vector<OwnPanel> panels_;
  Fonts fonts_;
  bool has_fonts_ = false, has_japanese_ = false;
  Theme theme_ = Theme::dark;
  bool is_down_[3] = {}, was_pressed_[3] = {};
  std::set<int> unseen_keys_, released_keys_;  // pressed since the last frame, and among them up again
};

}  // namespace ryosen
