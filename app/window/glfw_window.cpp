#include "app/window/glfw_window.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "render/gl/api.h"

namespace ryosen {

namespace {

// The part of Xlib.h that is used. The library is loaded, as GLFW loads it: the program is built without its package,
// and runs where it is missing.
struct Display;
using Window = unsigned long;
using Atom = unsigned long;
using OnError = int (*)(Display*, void* event);
constexpr Atom type_window = 33;  // XA_WINDOW

struct Xlib {
  LoadedLibrary library = open_library({"libX11.so.6"});
  Display* (*open_display)(const char* name) = library.find("XOpenDisplay");
  int (*close_display)(Display*) = library.find("XCloseDisplay");
  Window (*default_root_window)(Display*) = library.find("XDefaultRootWindow");
  Atom (*intern_atom)(Display*, const char* name, int only_if_there) = library.find("XInternAtom");
  int (*get_window_property)(Display*, Window, Atom, long offset, long length, int deletes, Atom type, Atom* its_type,
                             int* format, unsigned long* items, unsigned long* bytes_left,
                             unsigned char** value) = library.find("XGetWindowProperty");
  int (*delete_property)(Display*, Window, Atom) = library.find("XDeleteProperty");
  int (*grab_server)(Display*) = library.find("XGrabServer");
  int (*ungrab_server)(Display*) = library.find("XUngrabServer");
  int (*sync)(Display*, int drops_events) = library.find("XSync");
  int (*free)(void*) = library.find("XFree");
  OnError (*set_error_handler)(OnError) = library.find("XSetErrorHandler");
};

// The window that a property names; none where there is no such window, property or value.
std::optional<Window> named_window(const Xlib& x, Display* display, Window at, Atom property) {
  Atom type = 0;
  int format = 0;
  unsigned long items = 0, bytes_left = 0;
  unsigned char* value = nullptr;
  const int status =
      x.get_window_property(display, at, property, 0, 1, 0, type_window, &type, &format, &items, &bytes_left, &value);
  std::optional<Window> named;
  if (status == 0 && items > 0 && value) named = *reinterpret_cast<const Window*>(value);
  if (value) x.free(value);
  return named;
}

// Work-around for GLFW up to 3.4, which aborts at the first window where a window manager has ended without taking its
// property away (glfw issue 2601).
//
// Deletes the property _NET_SUPPORTING_WM_CHECK of the display's root where the window that it names is gone or does
// not have that property itself: no window manager runs there that could be asked. That of a running one stays. Does
// nothing without a display. Call it before glfwInit().
void forget_lost_window_manager() {
  const Xlib x;
  Display* const display = x.library.lacks ? nullptr : x.open_display(nullptr);
  if (!display) return;
  const OnError before = x.set_error_handler([](Display*, void*) { return 0; });  // the window may be gone
  x.grab_server(display);                                                         // no window manager begins meanwhile
  const Window root = x.default_root_window(display);
  const Atom property = x.intern_atom(display, "_NET_SUPPORTING_WM_CHECK", 1);
  const std::optional<Window> check = property != 0 ? named_window(x, display, root, property) : std::nullopt;
  if (check && !named_window(x, display, *check, property)) x.delete_property(display, root, property);
  x.ungrab_server(display);
  x.sync(display, 0);
  x.set_error_handler(before);
  x.close_display(display);
}

// By its place on a US keyboard.
std::string name_of_key(int key) {
  if ((key >= GLFW_KEY_A && key <= GLFW_KEY_Z) || (key >= GLFW_KEY_0 && key <= GLFW_KEY_9))
    return std::string(1, static_cast<char>(key));
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return "Numpad" + std::to_string(key - GLFW_KEY_KP_0);
  constexpr std::pair<int, const char*> others[] = {
      {GLFW_KEY_ESCAPE, "Escape"},
      {GLFW_KEY_LEFT, "Left"},
      {GLFW_KEY_RIGHT, "Right"},
      {GLFW_KEY_UP, "Up"},
      {GLFW_KEY_DOWN, "Down"},
      {GLFW_KEY_HOME, "Home"},
      {GLFW_KEY_END, "End"},
      {GLFW_KEY_PAGE_UP, "PageUp"},
      {GLFW_KEY_PAGE_DOWN, "PageDown"},
      {GLFW_KEY_TAB, "Tab"},
      {GLFW_KEY_SPACE, "Space"},
      {GLFW_KEY_DELETE, "Delete"},
      {GLFW_KEY_BACKSPACE, "Backspace"},
      {GLFW_KEY_ENTER, "Enter"},
      {GLFW_KEY_KP_ENTER, "Enter"},
      {GLFW_KEY_PERIOD, "."},
      {GLFW_KEY_KP_DECIMAL, "."},
      {GLFW_KEY_KP_ADD, "+"},
      {GLFW_KEY_EQUAL, "+"},
      {GLFW_KEY_KP_SUBTRACT, "-"},
      {GLFW_KEY_MINUS, "-"},
  };
  const auto found =
      std::find_if(std::begin(others), std::end(others), [&](const auto& row) { return row.first == key; });
  return found == std::end(others) ? "" : found->second;
}

bool is_on_numpad(int key) { return key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_EQUAL; }

// What is printed there, where keys are called so.
std::string name_printed(const char* printed) {
  const char c = printed && printed[0] != '\0' && printed[1] == '\0' ? printed[0] : '\0';
  if (c >= 'a' && c <= 'z') return std::string(1, static_cast<char>(c - 'a' + 'A'));
  if (c == '=') return "+";
  return c == '+' || c == '-' || c == '.' ? std::string(1, c) : std::string();
}

// The names in the key table of a GLFW key: "Ctrl+Shift+Z", "Numpad1", ".", "+"; empty for an unnamed key. `printed` is
// what the user's layout writes there, or null: letters and signs follow it, a letter of another alphabet is that of
// the same place on a US keyboard. A sign that takes Shift is the sign alone.
std::string chord_of_glfw(int key, int modifiers, const char* printed) {
  // The right one writes letters on some keyboards.
  if (key == GLFW_KEY_LEFT_ALT) return (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SHIFT)) == 0 ? "Alt" : "";
  std::string name = is_on_numpad(key) ? std::string() : name_printed(printed);
  if (name.empty()) name = name_of_key(key);
  if (name.empty()) return {};
  std::string chord;
  if ((modifiers & GLFW_MOD_CONTROL) != 0) chord += "Ctrl+";
  if ((modifiers & GLFW_MOD_ALT) != 0) chord += "Alt+";
  if ((modifiers & GLFW_MOD_SHIFT) != 0 && name != "+") chord += "Shift+";
  return chord + name;
}

struct CursorRow {
  PointerShape shape;
  int glfw;
};
constexpr CursorRow cursors[] = {
    {PointerShape::arrow, GLFW_ARROW_CURSOR},
    {PointerShape::text, GLFW_IBEAM_CURSOR},
    {PointerShape::hand, GLFW_HAND_CURSOR},
    {PointerShape::sideways, GLFW_HRESIZE_CURSOR},
};
static_assert(rows_are_in_order(cursors, &CursorRow::shape));

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

void GlfwWindow::show_pointer(PointerShape shape) {
  if (shape == shown_pointer_) return;
  shown_pointer_ = shape;
  GLFWcursor*& cursor = cursors_[static_cast<std::size_t>(shape)];
  if (!cursor) cursor = glfw().create_standard_cursor(cursors[static_cast<std::size_t>(shape)].glfw);
  glfw().set_cursor(handle_, cursor);  // null, where it cannot be made: the usual one
}

}  // namespace ryosen
