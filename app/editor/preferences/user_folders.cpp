#include "app/editor/preferences/user_folders.h"

#include <cstdlib>

namespace ryosen {

namespace {

// The value of a variable if it is an absolute path, else empty.
std::filesystem::path whole_path(const char* variable) {
  const char* const value = std::getenv(variable);
  const std::filesystem::path path(value ? value : "");
  return path.is_absolute() ? path : std::filesystem::path();
}

}  // namespace

std::filesystem::path user_folder(UserFolder which) {
  const bool is_state = which == UserFolder::state;
  const std::filesystem::path named = whole_path(is_state ? "XDG_STATE_HOME" : "XDG_CONFIG_HOME");
  if (!named.empty()) return named / "ryosen";
  const std::filesystem::path home = whole_path("HOME");
  if (home.empty()) return home;
  return (is_state ? home / ".local" / "state" : home / ".config") / "ryosen";
}

}  // namespace ryosen
