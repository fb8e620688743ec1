#include "app/window/lost_window_manager.h"

#include <dlfcn.h>

#include <optional>

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
  Display* (*open_display)(const char* name) = nullptr;
  int (*close_display)(Display*) = nullptr;
  Window (*default_root_window)(Display*) = nullptr;
  Atom (*intern_atom)(Display*, const char* name, int only_if_there) = nullptr;
  int (*get_window_property)(Display*, Window, Atom, long offset, long length, int deletes, Atom type, Atom* its_type,
                             int* format, unsigned long* items, unsigned long* bytes_left,
                             unsigned char** value) = nullptr;
  int (*delete_property)(Display*, Window, Atom) = nullptr;
  int (*grab_server)(Display*) = nullptr;
  int (*ungrab_server)(Display*) = nullptr;
  int (*sync)(Display*, int drops_events) = nullptr;
  int (*free)(void*) = nullptr;
  OnError (*set_error_handler)(OnError) = nullptr;
};

std::optional<Xlib> load_xlib() {
  void* const library = dlopen("libX11.so.6", RTLD_NOW | RTLD_LOCAL);
  if (!library) return std::nullopt;
  Xlib x;
  bool is_complete = true;
  const auto find = [&]<class Function>(Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    is_complete = is_complete && function;
  };
  find(x.open_display, "XOpenDisplay");
  find(x.close_display, "XCloseDisplay");
  find(x.default_root_window, "XDefaultRootWindow");
  find(x.intern_atom, "XInternAtom");
  find(x.get_window_property, "XGetWindowProperty");
  find(x.delete_property, "XDeleteProperty");
  find(x.grab_server, "XGrabServer");
  find(x.ungrab_server, "XUngrabServer");
  find(x.sync, "XSync");
  find(x.free, "XFree");
  find(x.set_error_handler, "XSetErrorHandler");
  return is_complete ? std::optional(x) : std::nullopt;
}

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

}  // namespace

void forget_lost_window_manager() {
  const std::optional<Xlib> x = load_xlib();
  Display* const display = x ? x->open_display(nullptr) : nullptr;
  if (!display) return;
  const OnError before = x->set_error_handler([](Display*, void*) { return 0; });  // the window may be gone
  x->grab_server(display);                                                         // no window manager begins meanwhile
  const Window root = x->default_root_window(display);
  const Atom property = x->intern_atom(display, "_NET_SUPPORTING_WM_CHECK", 1);
  const std::optional<Window> check = property != 0 ? named_window(*x, display, root, property) : std::nullopt;
  if (check && !named_window(*x, display, *check, property)) x->delete_property(display, root, property);
  x->ungrab_server(display);
  x->sync(display, 0);
  x->set_error_handler(before);
  x->close_display(display);
}

}  // namespace ryosen
