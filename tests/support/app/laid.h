// A session in panels, with frames laid out, clicked, and nothing drawn.
#pragma once

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "app/editor/session/session.h"
#include "app/ui/gui.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/program.h"
#include "tests/support/app/window_size.h"

namespace ryosen::test {

class Laid {
 public:
  explicit Laid(const std::string& asset_name, Size size = window, float scale = 1) : gui(scale), size_(size) {
    open(asset_name);
  }

  void open(const std::string& asset_name) {
    auto document = Document::open(asset(asset_name));
    ASSERT_TRUE(document) << asset_name;
    session.set_document(std::move(document).value());
    gui.place_view(session, size_);
    session.framing.frame_all();
    frames(3);
  }
  void frames(int n) {
    for (int i = 0; i < n; ++i) {
      gui.prepare(session);
      gui.frame(session, size_, 0.02);
    }
  }
  void click(glm::dvec2 pixel, int button = 0) {
    gui.pointer(pixel);
    frames(2);
    gui.button(button, true);
    frames(1);
    gui.button(button, false);
    frames(2);
  }

  // The middle of the first letter of a label, of that on top where several are drawn. Fails where none is.
  glm::dvec2 place_of(std::string_view label) const {
    const std::vector<glm::dvec2> places = DrawnText(gui).places(label);
    EXPECT_FALSE(places.empty()) << label << " is not drawn";
    return places.empty() ? glm::dvec2(-1e9) : places.back();
  }
  void click_on(std::string_view label, int button = 0) { click(place_of(label), button); }
  // Opens a menu of the bar by its title.
  void open_menu(std::string_view title) {
    for (const glm::dvec2 at : DrawnText(gui).places(title))
      if (at.y < session.view.origin.y) return click(at);
    ADD_FAILURE() << "no menu " << title;
  }

  Session session{std::make_unique<Document>()};
  Gui gui;

 protected:
  Size size_;
};

}  // namespace ryosen::test
