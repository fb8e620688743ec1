// Loading of the OpenGL 3.3 core functions, which the passes call, too. Beyond WebGL 2 they need buffer textures
// (TexelArray) and mapped buffers.
#pragma once

#include <glad/gl.h>

namespace ryosen {

using GlLoader = GLADapiproc (*)(const char* name);

// Loads the functions of gl.h through `loader`; their context must be current. The function pointers are global: call
// it again after switching to a context from another loader. False if OpenGL 3.3 is not supported.
inline bool load_gl(GlLoader loader) {
  const int version = gladLoadGL(loader);
  const int major = GLAD_VERSION_MAJOR(version), minor = GLAD_VERSION_MINOR(version);
  return version != 0 && (major > 3 || (major == 3 && minor >= 3));
}

}  // namespace ryosen
