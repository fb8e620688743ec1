// Where a program keeps what is the user's, by the rules of the desktop (XDG).
#pragma once

#include <filesystem>

namespace ryosen {

enum class UserFolder {
  state,   // $XDG_STATE_HOME/ryosen, or ~/.local/state/ryosen
  config,  // $XDG_CONFIG_HOME/ryosen, or ~/.config/ryosen
};

// Empty if neither the variable nor HOME is an absolute path. It need not be there.
std::filesystem::path user_folder(UserFolder which);

}  // namespace ryosen
