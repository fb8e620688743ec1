// The window's content: the panels around the view, laid out by Dear ImGui. Independent of GL and the window: the
// caller provides input and renders the draw data.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/ui/panels.h"
#include "app/ui/side_columns.h"
#include "app/ui/start_page.h"
#include "app/ui/whole_lines.h"
#include "ryosen/scene/view/camera.h"

struct ImGuiContext;
struct ImDrawData;
struct ImFontAtlas;

namespace ryosen {

class Shown;

struct ViewState;

class Framing;

struct Layout;

// What the pointer looks like over what it is on.
enum class PointerShape { arrow, text, hand, sideways };

// Owns a Dear ImGui context, which is current from construction on.
class Gui {
 public:
  // `scale`: display scale, 1 for about 96 pixels per inch.
  explicit Gui(float scale);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  // A panel beside those of the list, for programs with panels of their own: behind them in its column and the menu,
  // and known to the command `panel` while this lives. The row's texts must live as long.
  void add_panel(const PanelRow& row, std::unique_ptr<Panel> panel);
  // Changes the scale of the display; letters at the next prepare().
  void set_scale(float scale);
  // The area of the view within a window.
  PixelRect view_area(Size window, const Layout& layout) const { return areas_of(layout, window, size_).view; }
  // Sets the session's view to that area, as each frame does.
  void place_view(Session& session, Size window) const;

  // Applies theme, language and sizes. True if the glyphs have changed: rebuild their texture before the frame.
  bool prepare(const Session& session);
  // Lays out one frame and runs the long operations it requests; call prepare() first. The first frame is empty and a
  // panel may need two more to settle its size, so a picture takes three.
  void frame(Session& session, Size window, double seconds);
  // Lays out only the progress window of a long operation, without reading the mesh. True if the user cancels. Call it
  // between frames.
  bool progress_frame(Language language, Size window, double seconds, const WorkShown& work);
  const ImDrawData& draw_data() const;
  ImFontAtlas& fonts() const;

  // Input. Presses are queued until a frame has processed them, however short. Keys are text editing keys.
  void pointer(glm::dvec2 pixel);
  void button(int number, bool is_down);
  void wheel(double steps);
  void character(unsigned code);
  void text(const std::string& utf8);
  void key(int imgui_key, bool is_down);
  void modifiers(bool shift, bool ctrl);
  // Whether the panels own a pixel, or keyboard input.
  bool owns_pointer(const Layout& layout, Size window, glm::dvec2 pixel) const;
  bool owns_keys() const;
  // A menu is open, which Escape closes; while it is, keys are not for what lies behind it.
  bool has_menu(const Layout& layout) const;
  void close_menus();
  // A key was pressed that no frame has seen, or what it opened or closed is not laid out yet: who has the keyboard may
  // change.
  bool awaits_frame(const Layout& layout) const;
  // The next key is for a panel that asks which one it is to be (GuiState::asks_for_key); true where it took it.
  bool wants_chord(const Layout& layout) const;
  bool take_chord(const Layout& layout, const std::string& chord);
  // The start page takes the arrow keys and Enter.
  bool has_start(const Session& session) const { return StartPage::is_shown(session); }
  // As of the last frame.
  PointerShape pointer_shape() const;

  // Like the panels: keeps the outcome for the status line.
  Outcome run(Session& session, const std::string& line);
  Outcome click(Session& session, const Navigation::Click& click);
  Outcome keep(Session& session, Outcome outcome);
  void leave(Session& session, PendingLeave where);
  // Opens the menu of what is selected at the pointer.
  void open_element_menu();
  // Where fields copy to and paste from; before the first frame.
  void set_clipboard(void* system, const char* (*get)(void* system), void (*set)(void* system, const char* text));
  // The status line's text on the last command.
  const Text& said() const { return state_.last.sentence; }
  // True between begin and end of a frame, when no other can be laid out.
  bool is_laying_out() const { return state_.is_laying_out; }
  bool wants_quit() const { return state_.wants_quit; }
  // A panel waits for what is found beside the frames: a further one now and then shows it when it is there.
  bool waits_for_work() const { return state_.waits_for_work; }
  // Until what is played goes on by itself, in a frame then; none where nothing does.
  std::optional<double> seconds_to_step() const;
  // Lines wait for further frames, or what is laid out has not settled after an input or a command.
  bool wants_frames() const { return !state_.waiting.empty() || state_.unsettled_frames > 0; }

 private:
  PanelContext context(Session& session);
  void begin_frame(Size window, double seconds);
  void follow_view(Session& session, Size window) const;
  void follow_covered(ViewState& view, Framing& framing, const Shown& shown, const Layout& layout, Size window);
  void play_on(Session& session);
  void end_frame();
  ImGuiContext* imgui_;
  float display_scale_;
  UiSize size_, styled_;  // with what the user prefers, and what style and letters are made for
  GuiState state_;
  std::vector<OwnPanel> panels_;
  SideColumns columns_;
  StartPage start_;
  WholeLines whole_lines_;
  Fonts fonts_;
  bool has_fonts_ = false, has_japanese_ = false;
  Theme theme_ = Theme::dark;
  Camera framed_;  // the last one that was framed, and whether that was beside what a tab had opened
  bool is_framed_beside_ = false;
  std::optional<double> next_step_at_;  // by the time of frames
  bool is_down_[3] = {}, was_pressed_[3] = {};
  std::string laid_out_panel_;                 // that was open over the view in the last frame
  std::set<int> unseen_keys_, released_keys_;  // pressed since the last frame, and those already released
  struct HeldModifiers {
    bool shift, ctrl;
  };
  std::optional<HeldModifiers> next_modifiers_;  // once a frame has seen those keys with theirs
};

}  // namespace ryosen
