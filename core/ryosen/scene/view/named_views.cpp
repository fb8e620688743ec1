#include "ryosen/scene/view/named_views.h"

#include <array>

#include "ryosen/base/open_table.h"
#include "ryosen/base/rows.h"
#include "ryosen/geometry/unit_vector.h"

namespace ryosen {

namespace {

constexpr std::array all_views{
    NamedView{"front", "Front", "正面", {0, 0, -1}, {0, 1, 0}, "Numpad1", "front view", "正面図"},
    NamedView{"back", "Back", "背面", {0, 0, 1}, {0, 1, 0}},
    NamedView{"left", "Left", "左", {1, 0, 0}, {0, 1, 0}},
    NamedView{"right", "Right", "右", {-1, 0, 0}, {0, 1, 0}, "Numpad3", "right view", "右側面図"},
    NamedView{"top", "Top", "上", {0, -1, 0}, {0, 0, -1}, "Numpad7", "top view", "上面図"},
    NamedView{"bottom", "Bottom", "下", {0, 1, 0}, {0, 0, 1}},
    NamedView{"iso", "Diagonal", "斜め", {-1, -1, -1}, {0, 1, 0}},
};

}  // namespace

std::span<const NamedView> named_views() { return all_views; }

const NamedView* find_named_view(std::string_view id) { return find_row(all_views, id); }

std::string named_view_ids() { return joined_ids(all_views); }

Camera camera_along(const NamedView& view) {
  Camera camera;
  camera.eye = -view.direction;
  camera.target = glm::dvec3(0);
  camera.up = view.up;
  return camera;
}

Camera turned_to(const NamedView& view, const Camera& camera) {
  Camera turned = camera;
  turned.eye = camera.target - unit_vector(view.direction) * length_of(camera.target - camera.eye);
  turned.up = view.up;
  return turned;
}

}  // namespace ryosen
