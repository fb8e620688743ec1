// Headless OpenGL contexts, for pictures, tests and machines without a display.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/resource_limits.h"
#include "ryosen/base/result.h"

namespace ryosen {

// How a context without a display is made. automatic tries OSMesa (the reference: identical pixels everywhere), then
// EGL.
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
// Fails with ExitCode::no_backend and the cause of each backend tried, or with ExitCode::out_of_memory: a driver that
// finds no memory ends the program, so the limits are asked before one is loaded.
Result<std::unique_ptr<Context>> make_headless_context(Backend backend);

// What a context takes besides what is drawn, measured with Mesa 22.3 (OSMesa and EGL, llvmpipe without threads of its
// own).
inline constexpr MemoryNeed context_need{std::uint64_t{265} << 20, std::uint64_t{60} << 20, std::uint64_t{100} << 20};
// The failure where the limits leave less than that.
std::optional<Failure> lack_of_memory_for_context();
// Lets the driver do with little memory and without threads where those are limited. Before the first context.
void spare_resources();

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
