// OpenGL contexts without a display, for pictures, tests and machines without a screen.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace ryosen {

// automatic tries OSMesa (the reference: same pixels everywhere), then EGL.
enum class Backend { automatic, osmesa, egl };

// A current-able OpenGL 3.3 core context. It has no useful default framebuffer: draw into framebuffers of your own.
// Objects made in a context must be destroyed while it is current and alive.
class Context {
 public:
  virtual ~Context() = default;
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // Makes this the calling thread's context and loads the gl functions that belong to it.
  virtual bool make_current() = 0;
  // "osmesa" or "egl".
  virtual std::string_view name() const = 0;
};

// Makes a context and leaves it current. The libraries are loaded at run time and stay loaded.
// Fails with ExitCode::no_backend and the cause of each backend tried.
Result<std::unique_ptr<Context>> make_headless_context(Backend backend);

// What a backend offers on this machine.
struct BackendReport {
  std::string name;     // "osmesa" or "egl"
  std::string library;  // the file that was loaded, empty when none was found
  std::string version;  // GL_VERSION, empty when no context could be made
  std::string renderer;
  Text problem;  // why no context could be made; empty when it works

  bool works() const { return !version.empty(); }
};

// Tries every backend in turn. Leaves no context current.
std::vector<BackendReport> report_backends();

}  // namespace ryosen
