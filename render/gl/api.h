// The OpenGL 3.3 core functions and how they are loaded.
#pragma once

#include <glad/gl.h>

namespace ryosen {

using GlLoader = GLADapiproc (*)(const char* name);

// Makes the functions of gl.h those that `loader` finds; the context they belong to must be current. The functions are
// global to the process: call it again after switching to a context that came from another loader. False when they lack
// OpenGL 3.3.
bool load_gl(GlLoader loader);

}  // namespace ryosen
