#include <array>

#include "render/context/backends.h"
#include "render/gl/api.h"
// clang-format off
#include <GL/osmesa.h>
// clang-format on

namespace ryosen {
namespace {

struct OsmesaLibrary {
  LoadedLibrary file = open_library({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
  decltype(&OSMesaGetProcAddress) get_proc_address = file.find("OSMesaGetProcAddress");
  decltype(&OSMesaCreateContextAttribs) create_context_attribs = file.find("OSMesaCreateContextAttribs");
  decltype(&OSMesaMakeCurrent) make_current = file.find("OSMesaMakeCurrent");
  decltype(&OSMesaDestroyContext) destroy_context = file.find("OSMesaDestroyContext");
};

const OsmesaLibrary& osmesa_library() {
  static const OsmesaLibrary loaded;
  return loaded;
}

class OsmesaContext : public Context {
 public:
  explicit OsmesaContext(OSMesaContext context) : context_(context) {}
  ~OsmesaContext() override { osmesa_library().destroy_context(context_); }

  bool make_current() override {
    constexpr int side = 4;  // of the window-system buffer that OSMesa requires; unused
    if (!osmesa_library().make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, side, side)) return false;
    return load_gl([](const char* name) { return osmesa_library().get_proc_address(name); });
  }
  std::string_view name() const override { return "osmesa"; }

 private:
  OSMesaContext context_;
  std::array<unsigned char, 4 * 4 * 4> buffer_{};
};

}  // namespace

Attempt make_osmesa_context() {
  Attempt attempt;
  if (!osmesa_library().file.handle) {
    explain(attempt, osmesa_library().file, "libOSMesa");
    return attempt;
  }
  attempt.library = osmesa_library().file.file;
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  OSMesaContext handle =
      osmesa_library().file.lacks ? nullptr : osmesa_library().create_context_attribs(attributes, nullptr);
  std::unique_ptr<Context> context;
  if (handle) context = std::make_unique<OsmesaContext>(handle);
  if (context && context->make_current()) {
    attempt.context = std::move(context);
  } else {
    attempt.problem = {"libOSMesa offers no OpenGL 3.3 core context",
                       "libOSMesa で OpenGL 3.3 コアのコンテキストを作れません"};
  }
  return attempt;
}

}  // namespace ryosen
