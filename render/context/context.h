// Headless OpenGL contexts, for pictures, tests and machines without a display.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace ryosen {

// automatic tries OSMesa (the reference: identical pixels everywhere), then EGL.
enum class Backend { automatic, osmesa, egl };

// An OpenGL 3.3 core context without a usable default framebuffer: draw into your own framebuffers. Objects made in a
// context must be destroyed while it is alive and current.
class Context {
 public:
  virtual ~Context() = default;
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // Makes this the calling thread's current context and loads its GL functions.
  virtual bool make_current() = 0;
  // "osmesa" or "egl".
  virtual std::string_view name() const = 0;
};

// Makes a context and leaves it current. The libraries are loaded at run time and stay loaded.
// Fails with ExitCode::no_backend and the cause of each backend tried.
Result<std::unique_ptr<Context>> make_headless_context(Backend backend);

// The availability of a backend on this machine.
struct BackendReport {
  std::string name;     // "osmesa" or "egl"
  std::string library;  // the file that was loaded, empty if none was found
  std::string version;  // GL_VERSION, empty if no context could be made
  std::string renderer;
  Text problem;  // why no context could be made; empty if it works

  bool works() const { return !version.empty(); }
};

// Tries every backend in turn. Leaves no context current.
std::vector<BackendReport> report_backends();

}  // namespace ryosen
