// The views that have a name. The command `view`, the flag of `shot`, the View menu and the keys read the table.
#pragma once

#include <string>

#include "ryosen/scene/view/camera.h"

namespace ryosen {

struct NamedView {
  std::string_view id;
  std::string_view name_en, name_ja;
  glm::dvec3 direction, up;  // along which it looks, and what is up then
  // The key that shows it and what the list of keys says of that; empty where it has none.
  std::string_view chord = "", key_en = "", key_ja = "";
};

// In the order of the menu.
std::span<const NamedView> named_views();
// By id; null when there is none.
const NamedView* find_named_view(std::string_view id);
// "front|back|...": what the command may name.
std::string named_view_ids();

// A camera that looks so, to be fitted.
Camera camera_along(const NamedView& view);
// A camera that looks so at its own target, from as far away.
Camera turned_to(const NamedView& view, const Camera& camera);

}  // namespace ryosen
