// Loading of the OpenGL 3.3 core functions.
#pragma once

#include <glad/gl.h>

namespace ryosen {

using GlLoader = GLADapiproc (*)(const char* name);

// Loads the functions of gl.h through `loader`; their context must be current. The function pointers are global: call
// it again after switching to a context from another loader. False if OpenGL 3.3 is not supported.
bool load_gl(GlLoader loader);

}  // namespace ryosen
