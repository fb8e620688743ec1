// Libraries that are loaded at run time, so that the program is built without them and runs where they are missing.
#pragma once

#include <dlfcn.h>

#include <initializer_list>
#include <string>
#include <string_view>

namespace ryosen {

// A function of a library as the type of pointer that is asked for; null where it is missing.
struct LoadedFunction {
  void* address = nullptr;

  template <class Function>
  operator Function*() const {
    return reinterpret_cast<Function*>(address);
  }
};

struct LoadedLibrary {
  void* handle = nullptr;  // null if none could be loaded
  std::string file;        // which was loaded
  std::string error;  // of the loader, about the first that is there and could not be loaded; empty where none is there
  bool lacks = false;  // itself, or one of the functions that were looked for so far

  LoadedFunction find(const char* name) {
    const LoadedFunction found{handle ? dlsym(handle, name) : nullptr};
    lacks = lacks || !found.address;
    return found;
  }
};

// Opens the first existing one of the shared libraries and keeps it open until the process ends, because drivers have
// threads and exit handlers in it.
inline LoadedLibrary open_library(std::initializer_list<const char*> names) {
  // Whether the loader says that the file itself is not there, and not one that it needs.
  const auto says_absent = [](std::string_view error, std::string_view name) {
    return error.starts_with(name) && error.find("No such file") != std::string_view::npos;
  };
  LoadedLibrary library;
  for (const char* name : names) {
    if (void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return {handle, name, {}};
    const char* const error = dlerror();
    if (library.error.empty() && error && !says_absent(error, name)) library.error = error;
  }
  return library;
}

}  // namespace ryosen
