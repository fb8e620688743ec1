#include "tests/support/app/real_window.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace ryosen::test {

using namespace std::chrono_literals;

bool is_installed(const char* program) {
  return std::system(("command -v " + std::string(program) + " >/dev/null 2>&1").c_str()) == 0;
}

std::string words_of(glm::dvec2 pixel) {
  return std::to_string(std::lround(pixel.x)) + " " + std::to_string(std::lround(pixel.y));
}

std::string while_held(const std::string& keys, const std::string& words) {
  std::istringstream held(keys);
  std::string down, up, key;
  while (held >> key) {
    down += "keydown " + key + " ";
    up += " keyup " + key;
  }
  return down + words + up;
}

namespace {

// Outside of quotes: each click, key and text with the shortest rest behind it. By itself xdotool rests for 100 ms
// after a click and for 12 ms after a key. What has a rest of its own keeps that, which comes later.
std::string with_short_rests(const std::string& words) {
  std::string made, word;
  bool is_quoted = false;
  const auto end_word = [&] {
    made += word;
    if (word == "click" || word == "key" || word == "type") made += " --delay 1";
    word.clear();
  };
  for (const char c : words) {
    if (c == '\'') is_quoted = !is_quoted;
    if (c != ' ' || is_quoted) {
      word += c;
    } else {
      end_word();
      made += c;
    }
  }
  end_word();
  return made;
}

}  // namespace

void RealWindow::SetUp() {
  for (const char* program : {"Xvfb", "xdotool"})
    if (!is_installed(program)) GTEST_SKIP() << program << " is not installed; tests/run.sh installs it";
  // Without -noreset it begins anew when its last client has gone, and whoever comes meanwhile is not answered.
  display_ = std::make_unique<Process>(
      std::vector<std::string>{"Xvfb", "-displayfd", "1", "-screen", "0", screen(), "-nolisten", "tcp", "-noreset"},
      std::vector<std::string>{}, folder_.at("display"));
  ASSERT_TRUE(wait_for([&] { return !read_file(folder_.at("display")).empty(); })) << "Xvfb did not start";
  number_ = std::to_string(std::stoi(read_file(folder_.at("display"))));
}

std::unique_ptr<Process> RealWindow::started(const std::string& mesh, const std::string& log) const {
  return std::make_unique<Process>(
      std::vector<std::string>{RYOSEN_PROGRAM, mesh},
      std::vector<std::string>{"DISPLAY=:" + number_, "RYOSEN_FRAME_LOG=" + folder_.at(log), "LC_ALL=C",
                               "XDG_STATE_HOME=" + state_.path().string(),
                               "XDG_CONFIG_HOME=" + config_.path().string()},
      "/dev/null", folder_.at("err"), current_.path().string());
}

void RealWindow::open(const std::string& mesh) {
  editor_ = started(mesh, "frames");
  ASSERT_TRUE(wait_for([&] { return last().number > 0; })) << "no picture appeared";
}

void RealWindow::type(const std::string& line) const {
  xdotool("mousemove 640 400 key F3");
  ASSERT_TRUE(wait_for([&] { return last().panel == "command"; })) << "the command window did not open";
  xdotool("type '" + line + "'");
  xdotool("key Return");
}

void RealWindow::say(const std::string& line) const {
  type(line);
  ASSERT_TRUE(wait_for([&] { return last().panel == "-"; })) << "refused: " << line;
}

void RealWindow::xdotool(const std::string& words) const {
  ASSERT_EQ(std::system(("DISPLAY=:" + number_ + " xdotool " + with_short_rests(words)).c_str()), 0) << words;
}

void RealWindow::drag(glm::dvec2 from, glm::dvec2 to, const std::string& keys, int button) const {
  const std::string which = std::to_string(button);
  xdotool("mousemove " + words_of(from) + " " +
          while_held(keys, "mousedown " + which + " mousemove " + words_of(from * 0.5 + to * 0.5) + " mousemove " +
                               words_of(to) + " mouseup " + which));
}

Frame RealWindow::last() const {
  if (!folder_.has("frames")) return {};
  const std::string log = read_file(folder_.at("frames"));
  const std::size_t end = log.rfind('\n');
  if (end == std::string::npos) return {};
  const std::size_t begin = end == 0 ? std::string::npos : log.rfind('\n', end - 1);
  std::istringstream line(log.substr(begin == std::string::npos ? 0 : begin + 1));
  Frame frame;
  std::string word;
  line >> word >> frame.number >> word >> frame.pixels >> word >> frame.took_ms >> word >> frame.vertices >> word >>
      frame.edges >> word >> frame.faces >> word >> frame.history >> word >> frame.hover >> word >> frame.is_held >>
      word >> frame.selected >> word >> frame.eye.x >> frame.eye.y >> frame.eye.z >> word >> frame.first >> word >>
      frame.panel >> word >> frame.target.x >> frame.target.y >> frame.target.z >> word >> frame.is_gesture;
  line >> word >> std::ws;
  std::getline(line, frame.said);
  return frame;
}

bool RealWindow::shows(const std::function<bool(const Frame&)>& condition, std::chrono::seconds limit) {
  return wait_for([&] { return condition(last()); }, limit);
}

void RealWindow::expect_end_by(int signal) {
  const auto before = editor_->processor_time();
  editor_->end_by(signal);
  EXPECT_LT(editor_->processor_time() - before, 200ms) << "it goes on";
  EXPECT_EQ(editor_->exit_code(), 8);
  const std::string err = read_file(folder_.at("err"));
  EXPECT_NE(err.find("The editor was ended; edits that are not saved are offered again at its next start."),
            std::string::npos)
      << err;
  std::filesystem::remove(folder_.at("frames"));
}

}  // namespace ryosen::test
