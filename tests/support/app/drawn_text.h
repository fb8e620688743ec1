// The text of the last frame, read back from its glyphs. Blanks leave none: they are left out of all texts here.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/gui.h"

namespace ryosen::test {

class DrawnText {
 public:
  explicit DrawnText(const Gui& gui);

  // How often a text in UTF-8 was drawn; in it ? is any letter that is not of ASCII.
  std::size_t count(std::string_view text) const;
  // The middles of its first characters, in the order of drawing.
  std::vector<glm::dvec2> places(std::string_view text) const;
  // The middle of its first character, where it was drawn first; outside of every window if nowhere.
  glm::dvec2 place(std::string_view text) const;
  // The same where it was drawn last: on top.
  glm::dvec2 last_place(std::string_view text) const;
  // The text whose letters are cut off at the sides, or above or below, of what they are drawn in.
  std::string cut_sideways() const;
  std::string cut_in_height() const;
  // The last letters of texts that end with an ellipsis, and where: what had no room.
  std::vector<std::string> shortened() const;
  // The text whose letters lie over others of the same window.
  std::string overlapping() const;

 private:
  struct Glyph {
    glm::dvec2 first{0}, last{0}, clip_first{0}, clip_last{0};
    int window = 0;
  };
  template <class Is>
  std::string letters_that(Is is) const;

  std::vector<Glyph> glyphs_;
  std::u32string letters_;
  std::vector<std::size_t> ellipses_;  // where in it one stands
  std::vector<glm::dvec2> places_;
};

}  // namespace ryosen::test
