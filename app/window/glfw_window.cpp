#include "app/window/glfw_window.h"

#include <algorithm>
#include <utility>

#include "app/window/lost_window_manager.h"
#include "app/window/window_keys.h"
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

}  // namespace

const Glfw& glfw() { return *load_glfw(); }

Result<std::unique_ptr<GlfwWindow>> GlfwWindow::make() {
  if (!load_glfw()) return no_window("libglfw.so.3 is missing");
  std::unique_ptr<GlfwWindow> made(new GlfwWindow);
  forget_lost_window_manager();
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
  made->pointer_px_ = made->to_pixels(x, y);
  if (!load_gl(glfw().get_proc_address)) return no_window("no OpenGL 3.3");
  made->set_callbacks();
  return made;
}

GlfwWindow::~GlfwWindow() {
  if (handle_) glfw().destroy_window(handle_);
  if (is_up_) glfw().terminate();
}

Size GlfwWindow::size() const {
  Size size;
  glfw().get_framebuffer_size(handle_, &size.width, &size.height);
  return {std::max(size.width, 1), std::max(size.height, 1)};
}

float GlfwWindow::scale() const {
  float x = 1, y = 1;
  glfw().get_window_content_scale(handle_, &x, &y);
  return std::max(1.f, x);
}

bool GlfwWindow::take_exposure() { return std::exchange(is_exposed_, false); }

std::optional<WindowEvent> GlfwWindow::take_event() {
  if (events_.empty()) return std::nullopt;
  WindowEvent event = std::move(events_.front());
  events_.pop_front();
  return event;
}

bool GlfwWindow::has_event() {
  glfw().poll_events();
  return !events_.empty() || is_exposed_;
}

glm::dvec2 GlfwWindow::to_pixels(double x, double y) const {
  int width = 1, height = 1;
  glfw().get_window_size(handle_, &width, &height);
  const Size pixels = size();
  return {x * pixels.width / std::max(width, 1), y * pixels.height / std::max(height, 1)};
}

Pointer GlfwWindow::pointer() const {
  const auto holds = [&](int left, int right) {
    return glfw().get_key(handle_, left) == GLFW_PRESS || glfw().get_key(handle_, right) == GLFW_PRESS;
  };
  const Modifiers modifiers{holds(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
                            holds(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
                            holds(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
  return {pointer_px_, modifiers, glfw().get_time()};
}

void GlfwWindow::note(WindowEvent event) {
  event.at = pointer();
  events_.push_back(std::move(event));
}

void GlfwWindow::note_key(int key, int place, int action, int modifiers) {
  using Way = WindowEvent::Way;
  const Way way = action == GLFW_RELEASE ? Way::up : action == GLFW_REPEAT ? Way::again : Way::down;
  note({.kind = WindowEvent::Kind::key,
        .way = way,
        .chord = chord_of_glfw(key, modifiers, glfw().get_key_name(key, place))});
}

void GlfwWindow::set_callbacks() {
  using Kind = WindowEvent::Kind;
  GLFWwindow* const w = handle_;
  glfw().set_window_user_pointer(w, this);
  glfw().set_framebuffer_size_callback(w, [](GLFWwindow* x, int, int) { of(x).note({.kind = Kind::resized}); });
  glfw().set_window_content_scale_callback(w, [](GLFWwindow* x, float, float) { of(x).note({.kind = Kind::resized}); });
  glfw().set_window_focus_callback(
      w, [](GLFWwindow* x, int focused) { of(x).note({.kind = focused ? Kind::focused : Kind::unfocused}); });
  glfw().set_window_refresh_callback(w, [](GLFWwindow* x) { of(x).is_exposed_ = true; });
  glfw().set_window_close_callback(w, [](GLFWwindow* x) {
    glfw().set_window_should_close(x, GLFW_FALSE);
    of(x).note({.kind = Kind::close_asked});
  });
  glfw().set_cursor_pos_callback(w, [](GLFWwindow* x, double px, double py) {
    of(x).pointer_px_ = of(x).to_pixels(px, py);
    of(x).note({.kind = Kind::moved});
  });
  glfw().set_cursor_enter_callback(w, [](GLFWwindow* x, int entered) {
    if (!entered) of(x).note({.kind = Kind::left});
  });
  glfw().set_mouse_button_callback(w, [](GLFWwindow* x, int button, int action, int) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    of(x).note({.kind = Kind::button,
                .button = static_cast<MouseButton>(button),  // GLFW's order
                .way = action == GLFW_PRESS ? WindowEvent::Way::down : WindowEvent::Way::up});
  });
  glfw().set_scroll_callback(
      w, [](GLFWwindow* x, double, double steps) { of(x).note({.kind = Kind::wheel, .steps = steps}); });
  glfw().set_key_callback(w, [](GLFWwindow* x, int key, int place, int action, int modifiers) {
    of(x).note_key(key, place, action, modifiers);
  });
  glfw().set_char_callback(
      w, [](GLFWwindow* x, unsigned code) { of(x).note({.kind = Kind::character, .character = code}); });
  glfw().set_drop_callback(w, [](GLFWwindow* x, int count, const char** paths) {
    if (count > 0) of(x).note({.kind = Kind::dropped, .path = paths[0]});
  });
}

}  // namespace ryosen
