#include "render/context/context.h"

#include <malloc.h>

#include <cstdlib>
#include <thread>

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

// Threads that llvmpipe and Mesa start at most, besides one per processor.
constexpr unsigned further_threads = 4;

// Software renderers allocate and free tens of megabytes per frame. Returning them to the system each time would cost a
// third of the frame time in page faults, so freed memory is kept by the process.
void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
#endif
}

bool says_out_of_memory(std::string_view error) {
  for (const char* const words : {"annot allocate memory", "failed to map segment", "cannot map zero-fill pages",
                                  "cannot create shared object descriptor", "out of memory"})
    if (error.find(words) != std::string_view::npos) return true;
  return false;
}

}  // namespace

void spare_resources() {
  const bool is_limited = is_reserving_limited();
  if (!is_limited) keep_freed_memory();
  if (!is_limited && can_start_threads(std::thread::hardware_concurrency() + further_threads)) return;
  ::setenv("LP_NUM_THREADS", "0", 1);
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // it has a thread of its own
}

std::optional<Failure> lack_of_memory_for_context() { return lack_of_memory({"Drawing", "描画"}, context_need); }

void explain(Attempt& attempt, const LoadedLibrary& library, const std::string& what) {
  attempt.lacks_memory = says_out_of_memory(library.error);
  if (library.error.empty())
    attempt.problem = {"the library " + what + " is not installed",
                       "ライブラリ " + what + " がインストールされていません"};
  else if (attempt.lacks_memory)
    attempt.problem = {"there is not enough memory to load the library " + what,
                       "ライブラリ " + what + " を読み込むメモリが足りません"};
  else
    attempt.problem = {"the library " + what + " cannot be loaded (" + library.error + ")",
                       "ライブラリ " + what + " を読み込めません（" + library.error + "）"};
}

Result<std::unique_ptr<Context>> make_headless_context(Backend backend) {
  spare_resources();
  if (auto lack = lack_of_memory_for_context()) return std::move(*lack);
  Text causes;
  bool lacks_memory = false;
  for (const BackendRow& row : backend_rows) {
    if (backend != Backend::automatic && backend != row.backend) continue;
    Attempt attempt = row.make();
    if (attempt.context) return std::move(attempt.context);
    lacks_memory = lacks_memory || attempt.lacks_memory;
    if (!causes.en.empty()) causes += Text{"; ", "、"};
    const std::string name = std::string(row.name) + ": ";
    causes += Text{name, name} + attempt.problem;
  }
  if (lacks_memory)
    return make_failure(ExitCode::out_of_memory, "out_of_memory",
                        {"There is not enough memory to draw (" + causes.en + "); allow more (ulimit -v).",
                         "描画するためのメモリが足りません(" + causes.ja + ")。上限（ulimit -v）を上げてください。"});
  return make_failure(ExitCode::no_backend, "no_render_backend",
                      {"No way to draw without a display was found (" + causes.en + ").",
                       "画面なしで描画する手段が見つかりません(" + causes.ja + ")。"});
}

std::vector<BackendReport> report_backends() {
  spare_resources();
  std::vector<BackendReport> reports;
  for (const BackendRow& row : backend_rows) {
    BackendReport& report = reports.emplace_back();
    report.name = row.name;
    if (auto lack = lack_of_memory_for_context()) {
      report.problem = std::move(lack->message.text);
      continue;
    }
    Attempt attempt = row.make();
    report.library = attempt.library;
    report.problem = attempt.problem;
    if (attempt.context) {
      report.version = gl_string(GL_VERSION);
      report.renderer = gl_string(GL_RENDERER);
    }
  }
  return reports;
}

}  // namespace ryosen
