#include "render/gl/api.h"

namespace ryosen {

bool load_gl(GlLoader loader) {
  const int version = gladLoadGL(loader);
  return version != 0 &&
         (GLAD_VERSION_MAJOR(version) > 3 || (GLAD_VERSION_MAJOR(version) == 3 && GLAD_VERSION_MINOR(version) >= 3));
}

}  // namespace ryosen
