// A session in panels, with frames laid out, clicked, and nothing drawn.
#pragma once

#include <gtest/gtest.h>

#include "app/ui/gui.h"
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
    session.frame_all();
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

  Session session{std::make_unique<Document>()};
  Gui gui;

 protected:
  Size size_;
};

}  // namespace ryosen::test
