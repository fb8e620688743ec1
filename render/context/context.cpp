#include "render/context/context.h"

#include <dlfcn.h>
#include <malloc.h>

#include "render/context/backends.h"
#include "render/gl/api.h"

namespace ryosen {
namespace {

struct BackendRow {
  Backend backend;
  const char* name;
  Attempt (*make)();
};

// In the order in which Backend::automatic tries them.
constexpr BackendRow backend_rows[] = {
    {Backend::osmesa, "osmesa", make_osmesa_context},
    {Backend::egl, "egl", make_egl_context},
};

std::string gl_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

// Software renderers allocate and free tens of megabytes per frame. Returning them to the system each time would cost a
// third of the frame time in page faults, so freed memory is kept by the process.
void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
#endif
}

}  // namespace

LoadedLibrary open_library(std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return {handle, name};
  }
  return {};
}

void* find_symbol(const LoadedLibrary& library, const char* name) { return dlsym(library.handle, name); }

Text no_library(const std::string& what) {
  return {"the library " + what + " is not installed", "ライブラリ " + what + " がインストールされていません"};
}

Result<std::unique_ptr<Context>> make_headless_context(Backend backend) {
  keep_freed_memory();
  Text causes;
  for (const BackendRow& row : backend_rows) {
    if (backend != Backend::automatic && backend != row.backend) continue;
    Attempt attempt = row.make();
    if (attempt.context) return std::move(attempt.context);
    if (!causes.en.empty()) {
      causes.en += "; ";
      causes.ja += "、";
    }
    causes.en += std::string(row.name) + ": " + attempt.problem.en;
    causes.ja += std::string(row.name) + ": " + attempt.problem.ja;
  }
  return make_failure(ExitCode::no_backend, "no_render_backend",
                      {"No way to draw without a display was found (" + causes.en + ").",
                       "画面なしで描画する手段が見つかりません(" + causes.ja + ")。"});
}

std::vector<BackendReport> report_backends() {
  std::vector<BackendReport> reports;
  for (const BackendRow& row : backend_rows) {
    Attempt attempt = row.make();
    BackendReport report;
    report.name = row.name;
    report.library = attempt.library;
    report.problem = attempt.problem;
    if (attempt.context) {
      report.version = gl_string(GL_VERSION);
      report.renderer = gl_string(GL_RENDERER);
    }
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace ryosen
