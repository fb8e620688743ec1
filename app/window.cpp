#include "app/window.h"

#include <chrono>
#include <cstdlib>
#include <fstream>

#include "app/editor/autosave.h"
#include "app/editor/keys.h"
#include "app/editor/user_files.h"
#include "app/editor/user_folders.h"
#include "app/editor/view_switches.h"
#include "app/glfw.h"
#include "app/ui/gui.h"
#include "app/ui/viewport.h"
#include "app/ui/window_input.h"
#include "app/window_cursor.h"
#include "app/window_keys.h"
#include "render/canvas.h"
#include "render/context/context.h"
#include "render/gl/api.h"

namespace ryosen {

namespace {

Failure no_window(std::string cause) {
  if (cause.empty()) cause = "no display";
  return make_failure(
      ExitCode::no_backend, "no_display",
      {"No window can be opened here (" + cause + "). `ryosen shot FILE -o PNG --panels` makes a picture without one.",
       "ここではウィンドウを開けません（" + cause +
           "）。`ryosen shot FILE -o PNG --panels` なら画面なしで画像を作れます。"});
}

// Only called after load_glfw() has succeeded.
const Glfw& glfw() { return *load_glfw(); }

std::string glfw_error() {
  const char* words = nullptr;
  glfw().get_error(&words);
  return words ? words : "";
}

// Of a new window at scale 1: no larger than the display has room for.
Size first_size() {
  Size size{1280, 800};
  GLFWmonitor* const monitor = glfw().get_primary_monitor();
  if (!monitor) return size;
  int x = 0, y = 0, width = 0, height = 0;
  float across = 1, down = 1;
  glfw().get_monitor_workarea(monitor, &x, &y, &width, &height);
  glfw().get_monitor_content_scale(monitor, &across, &down);
  if (width > 0 && across > 0) size.width = std::min(size.width, static_cast<int>(static_cast<float>(width) / across));
  if (height > 0 && down > 0) size.height = std::min(size.height, static_cast<int>(static_cast<float>(height) / down));
  return size;
}

// GLFW and one window with its OpenGL 3.3 context, current on this thread.
class GlfwWindow {
 public:
  static Result<std::unique_ptr<GlfwWindow>> make() {
    if (!load_glfw()) return no_window("libglfw.so.3 is missing");
    std::unique_ptr<GlfwWindow> made(new GlfwWindow);
    made->is_up_ = glfw().init() == GLFW_TRUE;
    if (!made->is_up_) return no_window(glfw_error());
    glfw().window_hint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfw().window_hint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfw().window_hint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfw().window_hint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfw().window_hint(GLFW_DEPTH_BITS, 0);
    glfw().window_hint(GLFW_STENCIL_BITS, 0);
    glfw().window_hint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    const Size size = first_size();
    made->handle_ = glfw().create_window(size.width, size.height, "Ryosen", nullptr, nullptr);
    if (!made->handle_) return no_window(glfw_error());
    glfw().make_context_current(made->handle_);
    glfw().swap_interval(1);
    double x = 0, y = 0;
    glfw().get_cursor_pos(made->handle_, &x, &y);
    made->moved_to(x, y);
    if (!load_gl(glfw().get_proc_address)) return no_window("no OpenGL 3.3");
    return made;
  }
  ~GlfwWindow() {
    if (handle_) glfw().destroy_window(handle_);
    if (is_up_) glfw().terminate();
  }

  GLFWwindow* handle() const { return handle_; }
  Size size() const {
    Size size;
    glfw().get_framebuffer_size(handle_, &size.width, &size.height);
    return {std::max(size.width, 1), std::max(size.height, 1)};
  }
  float scale() const {
    float x = 1, y = 1;
    glfw().get_window_content_scale(handle_, &x, &y);
    return std::max(1.f, x);
  }
  // GLFW gives screen coordinates, which may be coarser than pixels.
  glm::dvec2 to_pixels(double x, double y) const {
    int width = 1, height = 1;
    glfw().get_window_size(handle_, &width, &height);
    const Size pixels = size();
    return {x * pixels.width / std::max(width, 1), y * pixels.height / std::max(height, 1)};
  }
  // Where the last event that was handled has put the pointer. It may be elsewhere by now: a press belongs to where it was
  // made, however many events are waiting behind it.
  Pointer pointer() const { return pointer_at(pointer_px_); }
  Pointer moved_to(double x, double y) {
    pointer_px_ = to_pixels(x, y);
    return pointer();
  }

 private:
  GlfwWindow() = default;
  Pointer pointer_at(glm::dvec2 pixel) const {
    const auto holds = [&](int left, int right) {
      return glfw().get_key(handle_, left) == GLFW_PRESS || glfw().get_key(handle_, right) == GLFW_PRESS;
    };
    const Modifiers modifiers{holds(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
                              holds(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
                              holds(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
    return {pixel, modifiers, glfw().get_time()};
  }

  GLFWwindow* handle_ = nullptr;
  glm::dvec2 pointer_px_{0};
  bool is_up_ = false;
};

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
    session_.display_scale = window.scale();
    begin_as_window(session_);
    session_.language = options.usual_language;
    const Text said = user_files_.begin(session_);
    if (options.language) session_.language = *options.language;
    user_files_.take_as_given(session_);
    session_.quit = [this] { gui_.leave(session_, {true, {}}); };
    session_.take_picture = [this](const std::filesystem::path& path) {
      draw_whole();
      return write_png(canvas_->read_pixels(), path);
    };
    session_.trials().in_background = true;
    session_.on_progress = [this](double share) { return show_progress(share); };
    if (const char* const path = std::getenv("RYOSEN_FRAME_LOG")) log_.open(path, std::ios::app);
    gui_.set_clipboard(
        window.handle(), [](void* w) { return glfw().get_clipboard_string(static_cast<GLFWwindow*>(w)); },
        [](void* w, const char* text) { glfw().set_clipboard_string(static_cast<GLFWwindow*>(w), text); });
    if (!said.en.empty()) gui_.keep(session_, failed(ExitCode::input_malformed, said));
    if (gui_.prepare(session_)) canvas_->set_fonts(gui_.fonts());  // of the size that the user prefers
    set_callbacks();
    resize();
    session_.frame_all();
    session_.autosave = &autosave_;
    autosave_.begin(session_.document());
    // Why the folder cannot be read is said to whoever asks for the list.
    if (list_lost_sessions(session_) && !session_.lost.empty())
      session_.show(panel_opened_by(PanelOpener::lost_sessions), true);
  }

  void run() {
    while (!gui_.wants_quit()) {
      std::optional<Clock::duration> next;
      for (int i = 0; !next && (i < settling_frames || gui_.wants_frames()); ++i) {
        show();
        next = viewport_->time_to_next_frame(Clock::now());
        if (!next && (session_.preparing() || session_.trials().share() || gui_.waits_for_work()))
          next = std::chrono::milliseconds(100);
      }
      if (!next)
        if (const auto seconds = gui_.seconds_to_step())
          next = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*seconds));
      if (keep_user_files()) continue;
      // The text cursor blinks; otherwise wait for events.
      if (next && *next == Clock::duration(0))
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
  }

  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds looks_at_disk_after{2};
  static constexpr std::chrono::milliseconds patience{300};
  static constexpr int settling_frames = 3;  // a panel may need this many to settle its size

  static Editor& of(GLFWwindow* window) { return *static_cast<Editor*>(glfw().get_window_user_pointer(window)); }

  void set_callbacks() {
    GLFWwindow* const w = window_.handle();
    glfw().set_window_user_pointer(w, this);
    glfw().set_framebuffer_size_callback(w, [](GLFWwindow* x, int, int) { of(x).resize(); });
    glfw().set_window_content_scale_callback(w, [](GLFWwindow* x, float, float) { of(x).resize(); });
    glfw().set_window_focus_callback(w, [](GLFWwindow* x, int focused) {
      if (of(x).is_working_) return;
      if (focused)
        of(x).session_.look_at_disk();
      else
        of(x).input_.let_go();
    });
    glfw().set_window_refresh_callback(w, [](GLFWwindow* x) { of(x).must_present_ = true; });
    glfw().set_window_close_callback(w, [](GLFWwindow* x) {
      glfw().set_window_should_close(x, GLFW_FALSE);
      of(x).is_working_ ? of(x).cancel_work() : of(x).session_.quit();
    });
    glfw().set_cursor_pos_callback(w, [](GLFWwindow* x, double px, double py) {
      const Pointer at = of(x).window_.moved_to(px, py);
      of(x).is_working_ ? of(x).gui_.pointer(at.pixel) : of(x).input_.move(at);
    });
    glfw().set_cursor_enter_callback(w, [](GLFWwindow* x, int entered) {
      if (!entered && !of(x).is_working_) of(x).input_.leave();
    });
    glfw().set_mouse_button_callback(
        w, [](GLFWwindow* x, int button, int action, int) { of(x).button(button, action == GLFW_PRESS); });
    glfw().set_scroll_callback(w, [](GLFWwindow* x, double, double steps) {
      if (!of(x).is_working_) of(x).input_.wheel(steps, of(x).window_.pointer());
    });
    glfw().set_key_callback(
        w, [](GLFWwindow* x, int key, int place, int action, int mods) { of(x).key(key, place, action, mods); });
    glfw().set_char_callback(w, [](GLFWwindow* x, unsigned code) {
      if (!of(x).is_working_) of(x).gui_.character(code);
    });
    glfw().set_drop_callback(w, [](GLFWwindow* x, int count, const char** paths) {
      if (count > 0 && !of(x).is_working_) of(x).gui_.leave(of(x).session_, {false, paths[0]});
    });
  }

  // Input is ignored while an operation runs: the mesh is in an intermediate state.
  void resize() {
    if (is_working_) return;
    const Size size = window_.size();
    canvas_->resize(size);
    gui_.set_scale(window_.scale());
    session_.display_scale = window_.scale();
    gui_.place_view(session_, size);
    input_.resize(size);
  }

  void button(int number, bool is_down) {
    if (number > GLFW_MOUSE_BUTTON_MIDDLE) return;
    if (is_working_) return gui_.button(number, is_down);
    const auto which = static_cast<MouseButton>(number);  // GLFW's order
    if (is_down)
      input_.press(which, window_.pointer());
    else
      input_.release(which, window_.pointer());
  }

  void key(int key, int place, int action, int modifiers) {
    if (is_working_ && key == GLFW_KEY_ESCAPE && action == GLFW_PRESS) cancel_work();
    if (is_working_ && action != GLFW_RELEASE) return;
    const std::string chord = chord_of_glfw(key, modifiers, glfw().get_key_name(key, place));
    if (action == GLFW_RELEASE)
      input_.key_up(chord);
    else
      input_.key_down(chord, action == GLFW_REPEAT);
    input_.point(window_.pointer());
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
    glfw().poll_events();
    if (gui_.progress_frame(session_.language, canvas_->size(), 0.05, share)) cancel_work();
    canvas_->draw_over(gui_.draw_data());
    canvas_->present(0);
    glfw().swap_buffers(window_.handle());
    if (log_.is_open()) log_ << "progress " << share << std::endl;
    return !is_cancelled_;
  }

  // After an operation with progress display: the window may have been resized and buttons released.
  void end_work() {
    is_working_ = false;
    input_.let_go();
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
    const Clock::time_point start = Clock::now();
    session_.prepare();
    lay_out(start);
    viewport_->follow(session_);
    viewport_->keep_pace(session_, start);
    const Clock::time_point drawing = Clock::now();
    const std::int64_t pixels = compose();
    show_title();
    cursor_.show(window_.handle(), gui_.pointer_shape());
    if (pixels == 0 && !must_present_) return;
    canvas_->present(0);
    must_present_ = false;
    glFinish();
    viewport_->took(Clock::now() - drawing);
    const double took_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    glfw().swap_buffers(window_.handle());
    log_frame(pixels, took_ms);
  }

  std::int64_t compose() { return canvas_->compose(viewport_->placed(), gui_.draw_data()); }

  // What is shown may be a part of it. Between frames only: a panel that is being laid out has nothing to be drawn.
  void draw_whole() {
    if (gui_.is_laying_out()) return;
    viewport_->hurry();
    while (!viewport_->is_finished()) compose();
  }

  void show_title() {
    const Document& document = session_.document();
    const std::string name = session_.document_name();
    const std::string title = (document.is_modified() ? "* " : "") + (name.empty() ? "Ryosen" : name + " - Ryosen");
    if (title == title_) return;
    glfw().set_window_title(window_.handle(), title.c_str());
    title_ = title;
  }

  std::string hovered() const {
    if (session_.pointed_handle() || session_.pointed_axis_end()) return "handle";
    return session_.hover() ? name_of(session_.mesh(), session_.hover()->picked.element) : "-";
  }

  void log_frame(std::int64_t pixels, double took_ms) {
    if (!log_.is_open()) return;
    const ElementCounts live = session_.mesh().live();
    log_ << "frame " << ++frames_ << " pixels " << pixels << " ms " << took_ms << " V " << live.vertices << " E "
         << live.edges << " F " << live.faces << " history " << session_.document().position() << " hover " << hovered()
         << " held " << session_.is_verdict_held() << " selected " << session_.selection.size() << " eye "
         << session_.camera.eye.x << ' ' << session_.camera.eye.y << ' ' << session_.camera.eye.z << std::endl;
  }

  GlfwWindow& window_;
  Session session_;
  std::unique_ptr<Viewport> viewport_;
  std::unique_ptr<Canvas> canvas_;
  Gui gui_;
  WindowInput input_{gui_, session_, {}, [this] { catch_up(); }};
  UserFiles user_files_;
  Autosave autosave_{recovery_folder()};
  std::string title_;
  WindowCursor cursor_;
  std::ofstream log_;
  std::uint64_t frames_ = 0;
  bool is_working_ = false, is_cancelled_ = false;
  Clock::time_point work_began_;
  Clock::time_point looked_at_disk_;
  Clock::time_point last_frame_ = Clock::now();
  bool must_present_ = true;
};

}  // namespace

Status run_window(const WindowOptions& options) {
  auto document = std::make_unique<Document>();
  if (!options.file.empty()) {
    Result<std::unique_ptr<Document>> opened = Document::open(options.file);
    if (!opened) return opened.failure();
    document = std::move(opened).value();
  }
  if (auto lack = lack_of_memory_for_context()) return std::move(*lack);
  Result<std::unique_ptr<GlfwWindow>> window = GlfwWindow::make();
  if (!window) return window.failure();
  Result<std::unique_ptr<Viewport>> viewport = Viewport::make();
  if (!viewport) return viewport.failure();
  Result<std::unique_ptr<Canvas>> canvas = Canvas::make();
  if (!canvas) return canvas.failure();
  Editor(**window, std::move(document), std::move(viewport).value(), std::move(canvas).value(), options).run();
  return success();
}

}  // namespace ryosen
