// The start of the window on a display whose window manager has ended, or runs.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include "tests/support/app/real_window.h"

namespace ryosen {
namespace {

using Window = unsigned long;

// A connection to the display that writes the property by which window managers are known. What it has made lives on
// after it, as what a window manager left does.
class LeftBehind {
 public:
  explicit LeftBehind(const std::string& display) : library_(dlopen("libX11.so.6", RTLD_NOW)) {
    if (library_) display_ = call<void*(const char*)>("XOpenDisplay")(display.c_str());
  }
  ~LeftBehind() {
    if (display_) call<int(void*)>("XCloseDisplay")(display_);
  }
  LeftBehind(const LeftBehind&) = delete;
  LeftBehind& operator=(const LeftBehind&) = delete;

  bool is_open() const { return display_; }
  Window root() const { return call<Window(void*)>("XDefaultRootWindow")(display_); }
  Window make_window() const {
    using Create = Window(void*, Window, int, int, unsigned, unsigned, unsigned, unsigned long, unsigned long);
    const Window made = call<Create>("XCreateSimpleWindow")(display_, root(), 0, 0, 1, 1, 0, 0, 0);
    flush();
    return made;
  }
  void destroy(Window window) const {
    call<int(void*, Window)>("XDestroyWindow")(display_, window);
    flush();
  }
  static constexpr unsigned long of_window = 33, of_number = 6;  // XA_WINDOW, XA_CARDINAL
  void write(Window at, Window value, unsigned long type = of_window, int values = 1) const {
    using Change = int(void*, Window, unsigned long, unsigned long, int, int, const unsigned char*, int);
    call<Change>("XChangeProperty")(display_, at, property(), type, 32, 0,
                                    reinterpret_cast<const unsigned char*>(&value), values);
    flush();
  }
  bool has_root_property() const {
    using Get = int(void*, Window, unsigned long, long, long, int, unsigned long, unsigned long*, int*, unsigned long*,
                    unsigned long*, unsigned char**);
    unsigned long type = 0, items = 0, left = 0;
    int format = 0;
    unsigned char* value = nullptr;
    call<Get>("XGetWindowProperty")(display_, root(), property(), 0, 1, 0, 0, &type, &format, &items, &left, &value);
    if (value) call<int(void*)>("XFree")(value);
    return type != 0;
  }

 private:
  template <class Function>
  Function* call(const char* name) const {
    return reinterpret_cast<Function*>(dlsym(library_, name));
  }
  unsigned long property() const {
    return call<unsigned long(void*, const char*, int)>("XInternAtom")(display_, "_NET_SUPPORTING_WM_CHECK", 0);
  }
  void flush() const { call<int(void*, int)>("XSync")(display_, 0); }

  void* library_;
  void* display_ = nullptr;
};

class WindowManagerTest : public test::RealWindow {
 protected:
  void SetUp() override {
    RealWindow::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    left_ = std::make_unique<LeftBehind>(":" + number_);
    ASSERT_TRUE(left_->is_open());
  }
  // Starts the editor, and ends it by what an exit in order is.
  void expect_start(const char* what) {
    SCOPED_TRACE(what);
    std::filesystem::remove(folder_.at("frames"));
    open(test::asset("cube.obj"));
    EXPECT_EQ(last().vertices, 8) << test::read_file(folder_.at("err"));
    xdotool("mousemove 640 400 key ctrl+q");
    ASSERT_TRUE(test::wait_for([&] { return editor_->is_over(); }));
    EXPECT_EQ(editor_->exit_code(), 0);
  }

  std::unique_ptr<LeftBehind> left_;
};

// GLFW ended the program by an assertion.
TEST_F(WindowManagerTest, that_left_its_property_behind_does_not_end_the_start) {
  const Window gone = left_->make_window();
  left_->destroy(gone);
  left_->write(left_->root(), gone);
  expect_start("a window that is gone");
  EXPECT_FALSE(left_->has_root_property()) << "it names no window manager";
  left_->write(left_->root(), 0x123456);
  expect_start("a window that never was");
  left_->write(left_->root(), 0);
  expect_start("no window");
  left_->write(left_->root(), left_->make_window());
  expect_start("a window that has taken the number, without the property");
  left_->write(left_->root(), left_->root());
  expect_start("the root itself, which has the property");
}

TEST_F(WindowManagerTest, that_runs_keeps_its_property) {
  const Window check = left_->make_window();
  left_->write(check, check);
  left_->write(left_->root(), check);
  expect_start("a window with the same property");
  EXPECT_TRUE(left_->has_root_property());
  left_->write(left_->root(), 7, LeftBehind::of_number);
  expect_start("a property of another type");
  EXPECT_TRUE(left_->has_root_property());
  left_->write(left_->root(), 7, LeftBehind::of_window, 0);
  expect_start("a property without a value");
}

}  // namespace
}  // namespace ryosen
