// A library to be loaded before others (LD_PRELOAD) that lets system calls fail. It concerns itself with one folder:
// calls that name something in it, or a descriptor that was opened there. In the environment:
//   RYOSEN_FAIL_FOLDER  the folder, an absolute path
//   RYOSEN_FAIL_AT      which of the calls fails, counted from 1; 0 for none
//   RYOSEN_FAIL_WITH    an error number, or `short`: a write that takes half of the bytes
//   RYOSEN_FAIL_LOG     a file, outside of the folder, that gets the name and the path of each call
// A close that fails has closed nevertheless, as the system's does.
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

template <class Function>
Function* next_of(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

const char* setting(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

bool is_in_folder(const char* path) {
  const char* const folder = setting("RYOSEN_FAIL_FOLDER");
  const std::size_t size = std::strlen(folder);
  return path && size > 0 && std::strncmp(path, folder, size) == 0 && (path[size] == '\0' || path[size] == '/');
}

std::array<std::string, 256>& paths_of_descriptors() {
  static std::array<std::string, 256> paths;
  return paths;
}

const char* path_of(int descriptor) {
  auto& paths = paths_of_descriptors();
  return descriptor >= 0 && descriptor < static_cast<int>(paths.size()) ? paths[descriptor].c_str() : "";
}

void note_descriptor(int descriptor, const char* path) {
  auto& paths = paths_of_descriptors();
  if (descriptor >= 0 && descriptor < static_cast<int>(paths.size())) paths[descriptor] = path;
}

bool is_short() { return std::strcmp(setting("RYOSEN_FAIL_WITH"), "short") == 0; }

// Counts a call and says whether it is the one to fail, with errno set.
bool must_fail(const char* call, const char* path) {
  static long count = 0;
  if (!is_in_folder(path)) return false;
  ++count;
  if (std::FILE* const log = std::fopen(setting("RYOSEN_FAIL_LOG"), "a")) {
    std::fprintf(log, "%s %s\n", call, path);
    std::fclose(log);
  }
  if (count != std::atol(setting("RYOSEN_FAIL_AT"))) return false;
  if (is_short() && std::strcmp(call, "write") != 0) return false;
  errno = std::atoi(setting("RYOSEN_FAIL_WITH"));
  return true;
}

bool takes_mode(int flags) { return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE; }

int opened(int descriptor, const char* path) {
  if (is_in_folder(path)) note_descriptor(descriptor, path);
  return descriptor;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  mode_t mode = 0;
  if (takes_mode(flags)) {
    va_list rest;
    va_start(rest, flags);
    mode = va_arg(rest, mode_t);
    va_end(rest);
  }
  if (must_fail("open", path)) return -1;
  return opened(next_of<int(const char*, int, ...)>("open")(path, flags, mode), path);
}

int openat(int folder, const char* path, int flags, ...) {
  mode_t mode = 0;
  if (takes_mode(flags)) {
    va_list rest;
    va_start(rest, flags);
    mode = va_arg(rest, mode_t);
    va_end(rest);
  }
  if (must_fail("openat", path)) return -1;
  return opened(next_of<int(int, const char*, int, ...)>("openat")(folder, path, flags, mode), path);
}

ssize_t write(int descriptor, const void* bytes, size_t size) {
  if (must_fail("write", path_of(descriptor))) {
    if (!is_short()) return -1;
    size = (size + 1) / 2;
  }
  return next_of<ssize_t(int, const void*, size_t)>("write")(descriptor, bytes, size);
}

int fsync(int descriptor) {
  if (must_fail("fsync", path_of(descriptor))) return -1;
  return next_of<int(int)>("fsync")(descriptor);
}

int fchmod(int descriptor, mode_t mode) noexcept {
  if (must_fail("fchmod", path_of(descriptor))) return -1;
  return next_of<int(int, mode_t)>("fchmod")(descriptor, mode);
}

int fchown(int descriptor, uid_t user, gid_t group) noexcept {
  if (must_fail("fchown", path_of(descriptor))) return -1;
  return next_of<int(int, uid_t, gid_t)>("fchown")(descriptor, user, group);
}

int rename(const char* from, const char* to) noexcept {
  if (must_fail("rename", to)) return -1;
  return next_of<int(const char*, const char*)>("rename")(from, to);
}

int close(int descriptor) {
  const bool fails = must_fail("close", path_of(descriptor));
  const int error = errno;
  note_descriptor(descriptor, "");
  const int result = next_of<int(int)>("close")(descriptor);
  if (!fails) return result;
  errno = error;
  return -1;
}

}  // extern "C"
