#include "app/window/window.h"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/document/large_files.h"
#include "app/editor/preferences/keys.h"
#include "app/editor/preferences/user_files.h"
#include "app/editor/preferences/user_folders.h"
#include "app/editor/preferences/view_switches.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "app/ui/gui.h"
#include "app/ui/viewport.h"
#include "app/ui/window_input.h"
#include "app/window/frame_log.h"
#include "app/window/glfw_window.h"
#include "app/window/opening.h"
#include "render/canvas.h"
#include "render/context/context.h"
#include "render/gl/api.h"

namespace ryosen {

namespace {

class Editor {
 public:
  Editor(GlfwWindow& window, std::unique_ptr<Document> document, std::unique_ptr<Viewport> viewport,
         std::unique_ptr<Canvas> canvas, const WindowOptions& options)
      : window_(window),
        session_(std::move(document)),
        viewport_(std::move(viewport)),
        canvas_(std::move(canvas)),
        gui_(window.scale()),
        user_files_(user_folder(UserFolder::config), options.preferences) {
    session_.preferences.display_scale = window.scale();
    begin_as_window(session_);
    session_.preferences.language = options.usual_language;
    const Text said = user_files_.begin(session_);
    if (options.language) session_.preferences.language = *options.language;
    user_files_.take_as_given(session_);
    session_.frontend.quit = [this] { gui_.leave(session_, {true, {}}); };
    session_.frontend.take_picture = [this](const std::filesystem::path& path) {
      draw_whole();
      return write_png(canvas_->read_pixels(), path);
    };
    session_.trials.in_background = true;
    session_.frontend.asks_in_slices = true;
    session_.frontend.read_document = [this](const std::filesystem::path& file) {
      return is_long_to_read(file) && !gui_.is_laying_out() ? read_beside(file) : Document::open(file);
    };
    session_.frontend.turns_to_solids = true;
    session_.frontend.on_progress = [this](double share) { return show_progress(share); };
    gui_.set_clipboard(
        window.handle(), [](void* w) { return glfw().get_clipboard_string(static_cast<GLFWwindow*>(w)); },
        [](void* w, const char* text) { glfw().set_clipboard_string(static_cast<GLFWwindow*>(w), text); });
    if (!said.en.empty()) gui_.keep(session_, failed(ExitCode::input_malformed, said));
    if (gui_.prepare(session_)) canvas_->set_fonts(gui_.fonts());  // of the size that the user prefers
    resize();
    session_.framing.frame_all();
    viewport_->prepare_refining(session_);
    session_.frontend.autosave = &autosave_;
    autosave_.begin(session_.document());
  }

  // Shows an empty view until the file is read. Given up, it goes on without it.
  Status open(const std::filesystem::path& file) {
    show_empty();
    Result<std::unique_ptr<Document>> document = read_beside(file);
    if (!document) return document.failure().exit_code == ExitCode::cancelled ? success() : document.failure();
    session_.set_document(std::move(document).value());
    session_.framing.frame_all();
    return success();
  }

  void run() {
    begun_ = Clock::now();
    offer_recovery();
    while (!gui_.wants_quit()) {
      std::optional<Clock::duration> next;
      for (int i = 0; !next && (i < settling_frames || (i < most_frames && gui_.wants_frames())); ++i) {
        show();
        next = viewport_->time_to_next_frame(Clock::now());
        if (!next && (session_.findings().preparing() || session_.trials.share() || gui_.waits_for_work()))
          next = std::chrono::milliseconds(100);
      }
      if (!next)
        if (const auto seconds = gui_.seconds_to_step())
          next = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*seconds));
      if (keep_user_files()) continue;
      // The text cursor blinks; otherwise wait for events.
      if (next ? *next == Clock::duration(0) : gui_.wants_frames())
        glfw().poll_events();
      else if (next)
        glfw().wait_events_timeout(std::chrono::duration<double>(*next).count());
      else if (gui_.owns_keys())
        glfw().wait_events_timeout(0.5);
      else
        glfw().wait_events_timeout(std::chrono::duration<double>(looks_at_disk_after).count());
      look_at_disk();
    }
    keep_user_files();
    autosave_.finish();
  }

 private:
  // Not while a file is read: that has a dialog of its own.
  void offer_recovery() {
    // Why the folder cannot be read is said to whoever asks for the list.
    if (!list_lost_sessions(session_.lost) || session_.lost.empty()) return;
    session_.layout.show(panel_opened_by(PanelOpener::lost_sessions), true);
    has_offered_ = true;
  }

  // True when there is something to say about it.
  bool keep_user_files() {
    const auto fault = user_files_.keep(session_);
    if (fault) gui_.keep(session_, failed(ExitCode::output_not_writable, *fault));
    return fault.has_value();
  }

  // Where another program may change the file meanwhile.
  void look_at_disk() {
    const Clock::time_point now = Clock::now();
    if (now - looked_at_disk_ < looks_at_disk_after) return;
    looked_at_disk_ = now;
    session_.look_at_disk();
    // A process that is killed holds its edits until it is gone.
    if (!has_offered_ && now - begun_ < offers_recovery_for) offer_recovery();
  }

  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds looks_at_disk_after{2}, offers_recovery_for{15};
  static constexpr std::chrono::milliseconds patience{300};
  static constexpr int settling_frames = 3;  // a panel may need this many to settle its size
  static constexpr int most_frames = 20;     // that are drawn before it is seen what the hand does meanwhile

  // All that has happened since the last time, in its order.
  void handle_events() {
    while (const std::optional<WindowEvent> event = window_.take_event()) {
      handle(*event);
      if (is_working_) end_work();
    }
  }

  void handle(const WindowEvent& event) {
    switch (event.kind) {
      case WindowEvent::Kind::resized:
        return resize();
      case WindowEvent::Kind::focused:
        session_.look_at_disk();
        return;
      case WindowEvent::Kind::unfocused:
        return input_.let_go();
      case WindowEvent::Kind::close_asked:
        return session_.frontend.quit();
      case WindowEvent::Kind::moved:
        return input_.move(event.at);
      case WindowEvent::Kind::left:
        return input_.leave();
      case WindowEvent::Kind::button:
        if (event.way == WindowEvent::Way::down)
          input_.press(event.button, event.at);
        else
          input_.release(event.button, event.at);
        return;
      case WindowEvent::Kind::wheel:
        return input_.wheel(event.steps, event.at);
      case WindowEvent::Kind::key:
        if (event.way == WindowEvent::Way::up)
          input_.key_up(event.chord);
        else
          input_.key_down(event.chord, event.way == WindowEvent::Way::again);
        return input_.point(event.at);
      case WindowEvent::Kind::character:
        return gui_.character(event.character);
      case WindowEvent::Kind::dropped:
        return gui_.leave(session_, {false, event.path});
    }
  }

  // The mesh is in an intermediate state: only the window of the progress has input. Keys that are let go are seen
  // behind the work; how large the window is and which buttons are up, too.
  void handle_at_work(const WindowEvent& event) {
    const bool is_down = event.way == WindowEvent::Way::down;
    switch (event.kind) {
      case WindowEvent::Kind::close_asked:
        return cancel_work();
      case WindowEvent::Kind::moved:
        return gui_.pointer(event.at.pixel);
      case WindowEvent::Kind::button:
        return gui_.button(static_cast<int>(event.button), is_down);
      case WindowEvent::Kind::key:
        if (event.way == WindowEvent::Way::up) let_go_at_work_.push_back(event.chord);
        if (is_down && key_of(event.chord) == "Escape") cancel_work();
        return;
      default:
        return;
    }
  }

  void resize() {
    const Size size = window_.size();
    const bool frames_anew = size != canvas_->size() && session_.framing.is_framed();
    canvas_->resize(size);
    gui_.set_scale(window_.scale());
    session_.preferences.display_scale = window_.scale();
    gui_.place_view(session_, size);
    if (frames_anew) session_.framing.frame_all();
    input_.resize(size);
  }

  void cancel_work() { is_cancelled_ = true; }

  // Called while a command runs. After a short delay shows progress over the previous picture; the only input accepted
  // is cancelling.
  bool show_progress(double share) {
    if (gui_.is_laying_out()) return true;
    const Clock::time_point now = Clock::now();
    if (!is_working_) {
      is_working_ = true;
      is_cancelled_ = false;
      work_began_ = now;
    }
    if (now - work_began_ < patience) return true;
    show_work({share, session_.at_work()});
    log_.progress(share);
    return !is_cancelled_;
  }

  // Says meanwhile what is read. What was given up ends beside the frames, at the latest with the window.
  Result<std::unique_ptr<Document>> read_beside(const std::filesystem::path& file) {
    std::erase_if(given_up_, [](const auto& opening) { return opening->is_done({}); });
    log_.reading(session_.layout, file);
    auto opening = std::make_unique<Opening>(file);
    is_working_ = true;
    is_cancelled_ = false;
    const Clock::time_point began = Clock::now();
    while (!opening->is_done(std::chrono::milliseconds(30)) && !is_cancelled_)
      if (Clock::now() - began > patience) show_work({{}, opening->told()});
    end_work();
    if (!is_cancelled_) return opening->take();
    opening->give_up();
    given_up_.push_back(std::move(opening));
    return Failure{ExitCode::cancelled, {}};
  }

  void show_work(const WorkShown& work) {
    glfw().poll_events();
    while (const std::optional<WindowEvent> event = window_.take_event()) handle_at_work(*event);
    if (gui_.progress_frame(session_.preferences.language, canvas_->size(), 0.05, work)) cancel_work();
    canvas_->draw_over(gui_.draw_data());
    canvas_->present(0);
    glfw().swap_buffers(window_.handle());
  }

  void show_empty() {
    session_.frontend.awaits_file = true;
    catch_up();
    viewport_->follow(session_);
    compose();
    canvas_->present(0);
    glfw().swap_buffers(window_.handle());
    session_.frontend.awaits_file = false;
  }

  void end_work() {
    is_working_ = false;
    input_.let_go();
    for (const std::string& chord : std::exchange(let_go_at_work_, {})) input_.key_up(chord);
    resize();
  }

  void lay_out(Clock::time_point now) {
    if (gui_.prepare(session_)) canvas_->set_fonts(gui_.fonts());
    gui_.frame(session_, canvas_->size(), std::chrono::duration<double>(now - last_frame_).count());
    if (is_working_) end_work();
    last_frame_ = now;
  }

  // Until all that came in has been done, though not until a panel rests that goes on by itself.
  void catch_up() {
    for (int i = 0; i < settling_frames || (i < 2 * settling_frames && gui_.wants_frames()); ++i) lay_out(Clock::now());
  }

  // Lays out a frame, redraws what changed, and presents it if anything did.
  void show() {
    handle_events();
    const Clock::time_point start = Clock::now();
    session_.prepare();
    lay_out(start);
    viewport_->follow(session_);
    const std::int64_t pixels = draw(start);
    show_title();
    window_.show_pointer(gui_.pointer_shape());
    const bool is_exposed = window_.take_exposure();
    if (pixels == 0 && !is_exposed) return;
    canvas_->present(0);
    glFinish();
    const double took_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    glfw().swap_buffers(window_.handle());
    log_.frame(session_, gui_.said(), pixels, took_ms);
  }

  // The pixels that were drawn. While the picture is refined several parts are shown at once, unless something comes
  // in: to show one takes as long as to show them all.
  std::int64_t draw(Clock::time_point start) {
    constexpr auto at_once = std::chrono::milliseconds(50);
    std::int64_t pixels = 0, drawn = 0;
    do {
      const Clock::time_point drawing = Clock::now();
      viewport_->keep_pace(session_.view, drawing);
      drawn = compose();
      pixels += drawn;
      if (drawn == 0) break;
      glFinish();
      viewport_->took(Clock::now() - drawing);
    } while (viewport_->goes_on_refining() && Clock::now() - start < at_once && !window_.has_event());
    return pixels;
  }

  std::int64_t compose() { return canvas_->compose(viewport_->placed(), gui_.draw_data()); }

  // What is shown may be a part of it. Between frames only: a panel that is being laid out has nothing to be drawn.
  void draw_whole() {
    if (gui_.is_laying_out()) return;
    session_.frontend.asks_in_slices = false;
    viewport_->follow(session_);
    session_.frontend.asks_in_slices = true;
    viewport_->hurry();
    while (!viewport_->is_finished()) compose();
  }

  void show_title() {
    const std::string name = shown_name(session_);
    const std::string title = name.empty() ? "Ryosen" : name + " - Ryosen";
    if (title == title_) return;
    glfw().set_window_title(window_.handle(), title.c_str());
    title_ = title;
  }

  GlfwWindow& window_;
  Session session_;
  std::unique_ptr<Viewport> viewport_;
  std::unique_ptr<Canvas> canvas_;
  Gui gui_;
  WindowInput input_{gui_, session_, {}, [this] { catch_up(); }};
  UserFiles user_files_;
  Autosave autosave_{recovery_folder()};
  std::vector<std::unique_ptr<Opening>> given_up_;  // that were read
  std::string title_;
  FrameLog log_;
  bool is_working_ = false, is_cancelled_ = false;
  std::vector<std::string> let_go_at_work_;  // keys
  Clock::time_point work_began_;
  Clock::time_point looked_at_disk_, begun_;
  bool has_offered_ = false;  // to recover what a crash left
  Clock::time_point last_frame_ = Clock::now();
};

}  // namespace

Status run_window(const WindowOptions& options) {
  const bool shows_reading = is_long_to_read(options.file);
  auto document = std::make_unique<Document>();
  if (!options.file.empty() && !shows_reading) {
    Result<std::unique_ptr<Document>> opened = Document::open(options.file);
    if (!opened) return opened.failure();
    document = std::move(opened).value();
  }
  // What is wrong with the file is said before what is wrong with the display.
  const auto failing = [&](Failure failure) -> Status {
    if (shows_reading)
      if (auto opened = Document::open(options.file); !opened) return opened.failure();
    return failure;
  };
  if (auto lack = lack_of_memory_for_context()) return failing(std::move(*lack));
  Result<std::unique_ptr<GlfwWindow>> window = GlfwWindow::make();
  if (!window) return failing(window.failure());
  Result<std::unique_ptr<Viewport>> viewport = Viewport::make();
  if (!viewport) return failing(viewport.failure());
  Result<std::unique_ptr<Canvas>> canvas = Canvas::make();
  if (!canvas) return failing(canvas.failure());
  Editor editor(**window, std::move(document), std::move(viewport).value(), std::move(canvas).value(), options);
  if (shows_reading)
    if (Status opened = editor.open(options.file); !opened) return opened;
  editor.run();
  return success();
}

}  // namespace ryosen
