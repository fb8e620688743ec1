// The two ways to a context without a display, behind one function each.
#pragma once

#include <memory>
#include <string>

#include "core/base/message.h"
#include "render/context/context.h"

namespace ryosen {

// What came of an attempt: a current context, or the reason for there being none.
struct Attempt {
  std::unique_ptr<Context> context;
  std::string library;  // the file that was loaded, empty when none was found
  Text problem;
};

Attempt make_osmesa_context();
Attempt make_egl_context();

// Opens the first of the shared libraries that exists and leaves it open until the process ends, because drivers keep
// threads and exit handlers in it. Null when there is none.
struct LoadedLibrary {
  void* handle = nullptr;
  std::string file;
};
LoadedLibrary open_library(std::initializer_list<const char*> names);

// The address of a function in a library, as its type; null when it is not there.
void* find_symbol(const LoadedLibrary& library, const char* name);
template <class Function>
Function find_function(const LoadedLibrary& library, const char* name) {
  return reinterpret_cast<Function>(find_symbol(library, name));
}

Text no_library(const std::string& what);

}  // namespace ryosen
