// The editor in a window on a display of its own, with mouse and keys as a person has them.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>

#include "tests/support/app/process.h"
#include "tests/support/app/program.h"

namespace ryosen::test {

// What the editor says about the picture it showed last (RYOSEN_FRAME_LOG).
struct Frame {
  long number = 0, pixels = 0;
  double took_ms = 0;
  long vertices = 0, edges = 0, faces = 0, history = -1;
  std::string hover;
  bool is_held = false;
  long selected = 0;
  glm::dvec3 eye{0};
  std::string first;  // of what is selected
  std::string panel;  // over the view
  glm::dvec3 target{0};
  bool is_gesture = false;
  std::string said;  // in English, of the last command
};

// "640 400", as xdotool takes a pixel.
std::string words_of(glm::dvec2 pixel);
// What xdotool does with all these keys held down meanwhile ("ctrl shift").
std::string while_held(const std::string& keys, const std::string& words);

bool is_installed(const char* program);

// Skips its tests where Xvfb or xdotool are missing. The window is 1280 x 800, at the corner of the display.
class RealWindow : public testing::Test {
 protected:
  void SetUp() override;
  // Of the display: its size and depth.
  virtual std::string screen() const { return "1400x900x24"; }

  // Starts the editor, in a folder of its own, and waits for its first picture.
  void open(const std::string& mesh);
  // Starts one and says its pictures in a file of this name in the folder.
  std::unique_ptr<Process> started(const std::string& mesh, const std::string& log) const;
  // Opens the command window and runs a line there.
  void type(const std::string& line) const;
  // The same, until that has closed: the line is carried out, and does not take long.
  void say(const std::string& line) const;
  void xdotool(const std::string& words) const;
  // The pointer goes there and the button down, and both somewhere else; with keys held down meanwhile.
  void drag(glm::dvec2 from, glm::dvec2 to, const std::string& keys = "", int button = 1) const;
  Frame last() const;
  // Whether the picture says so within some seconds.
  bool shows(const std::function<bool(const Frame&)>& condition, std::chrono::seconds limit = std::chrono::seconds(15));
  // Sends the signal and expects the answer: without going on, with code 8 and a sentence.
  void expect_end_by(int signal);

  TemporaryFolder folder_, state_, config_, current_;
  std::unique_ptr<Process> display_, editor_;
  std::string number_;
};

}  // namespace ryosen::test
