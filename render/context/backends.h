// The two headless backends, one function each.
#pragma once

#include <memory>
#include <string>

#include "render/context/context.h"
#include "ryosen/base/message.h"

namespace ryosen {

// The result of an attempt: a current context, or why there is none.
struct Attempt {
  std::unique_ptr<Context> context;
  std::string library;  // the file that was loaded, empty if none was found
  Text problem;
  bool lacks_memory = false;  // that is the problem
};

Attempt make_osmesa_context();
Attempt make_egl_context();

// Opens the first existing one of the shared libraries and keeps it open until the process ends, because drivers have
// threads and exit handlers in it. Null if none could be loaded.
struct LoadedLibrary {
  void* handle = nullptr;
  std::string file;   // which was loaded
  std::string error;  // of the loader, about the first that is there and could not be loaded; empty where none is there
};
LoadedLibrary open_library(std::initializer_list<const char*> names);
// Says of an attempt why `what` is not loaded.
void explain(Attempt& attempt, const LoadedLibrary& library, const std::string& what);

// The address of a function in a library; null if missing.
void* find_symbol(const LoadedLibrary& library, const char* name);
template <class Function>
Function find_function(const LoadedLibrary& library, const char* name) {
  return reinterpret_cast<Function>(find_symbol(library, name));
}

}  // namespace ryosen
