// How a view draws what it shows, beside the camera: what the switches of the view set (app/editor/view_switches.h) and
// what its shaders read.
#pragma once

namespace ryosen {

enum class Theme { dark, light };
// Each face in a light of its own, or light that goes over evenly from face to face, except at creases.
enum class Shading { flat, smooth };

// One field per switch; each begins with the first value of its row.
struct ViewSettings {
  Theme theme = Theme::dark;
  Shading shading = Shading::flat;

  // Calls visit(name, number) for each: a shader gets the number as its `uniform int name`.
  template <class Visit>
  void for_each(Visit visit) const {
    visit("theme", static_cast<int>(theme));
    visit("shading", static_cast<int>(shading));
  }

  friend bool operator==(const ViewSettings&, const ViewSettings&) = default;
};

}  // namespace ryosen
