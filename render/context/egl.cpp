#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>
#include <vector>

#include "render/context/backends.h"
#include "render/gl/api.h"

namespace ryosen {
namespace {

struct Egl {
  LoadedLibrary library = open_library({"libEGL.so.1", "libEGL.so"});
  decltype(&eglGetProcAddress) get_proc_address = library.find("eglGetProcAddress");
  decltype(&eglQueryString) query_string = find("eglQueryString");
  decltype(&eglInitialize) initialize = find("eglInitialize");
  decltype(&eglBindAPI) bind_api = find("eglBindAPI");
  decltype(&eglChooseConfig) choose_config = find("eglChooseConfig");
  decltype(&eglCreateContext) create_context = find("eglCreateContext");
  decltype(&eglDestroyContext) destroy_context = find("eglDestroyContext");
  decltype(&eglMakeCurrent) make_current = find("eglMakeCurrent");
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = find("eglGetPlatformDisplayEXT");
  PFNEGLQUERYDEVICESEXTPROC query_devices = find("eglQueryDevicesEXT");

  // EGL's own functions come from the library; extensions and client functions from eglGetProcAddress.
  LoadedFunction find(const char* name) {
    const LoadedFunction own = library.find(name);
    if (own.address || !get_proc_address) return own;
    return {reinterpret_cast<void*>(get_proc_address(name))};
  }
};

const Egl& egl() {
  static const Egl loaded;
  return loaded;
}

class EglContext : public Context {
 public:
  EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
  ~EglContext() override {
    egl().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl().destroy_context(display_, context_);
  }

  bool make_current() override {
    if (!egl().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) return false;
    return load_gl([](const char* name) { return reinterpret_cast<GLADapiproc>(egl().get_proc_address(name)); });
  }
  std::string_view name() const override { return "egl"; }

 private:
  EGLDisplay display_;
  EGLContext context_;
};

// Displays without a window system: Mesa's surfaceless platform, then every EGL device.
std::vector<EGLDisplay> headless_displays() {
  std::vector<EGLDisplay> displays;
  if (!egl().get_platform_display) return displays;
  const auto add = [&](EGLenum platform, void* native) {
    EGLDisplay display = egl().get_platform_display(platform, native, nullptr);
    if (display != EGL_NO_DISPLAY && egl().initialize(display, nullptr, nullptr)) displays.push_back(display);
  };
  const char* client = egl().query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (client && std::strstr(client, "EGL_MESA_platform_surfaceless")) add(EGL_PLATFORM_SURFACELESS_MESA, nullptr);
  if (egl().query_devices) {
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (!egl().query_devices(16, devices, &count)) count = 0;
    for (EGLint i = 0; i < count; ++i) add(EGL_PLATFORM_DEVICE_EXT, devices[i]);
  }
  return displays;
}

std::unique_ptr<Context> make_context(EGLDisplay display) {
  const char* extensions = egl().query_string(display, EGL_EXTENSIONS);
  if (!extensions || !std::strstr(extensions, "EGL_KHR_surfaceless_context")) return nullptr;
  if (!egl().bind_api(EGL_OPENGL_API)) return nullptr;
  const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  if (!egl().choose_config(display, wanted, &config, 1, &count) || count == 0) config = EGL_NO_CONFIG_KHR;
  const EGLint attributes[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  EGLContext handle = egl().create_context(display, config, EGL_NO_CONTEXT, attributes);
  if (handle == EGL_NO_CONTEXT) return nullptr;
  auto context = std::make_unique<EglContext>(display, handle);
  if (!context->make_current()) return nullptr;
  return context;
}

}  // namespace

Attempt make_egl_context() {
  Attempt attempt;
  if (!egl().library.handle) {
    explain(attempt, egl().library, "libEGL");
    return attempt;
  }
  if (!egl().get_proc_address) {
    attempt.problem = {"libEGL lacks eglGetProcAddress", "libEGL に eglGetProcAddress がありません"};
    return attempt;
  }
  attempt.library = egl().library.file;
  for (EGLDisplay display : headless_displays()) {
    attempt.context = make_context(display);
    if (attempt.context) return attempt;
  }
  attempt.problem = {"libEGL offers no OpenGL 3.3 core context without a surface",
                     "libEGL でサーフェスなしの OpenGL 3.3 コアのコンテキストを作れません"};
  return attempt;
}

}  // namespace ryosen
