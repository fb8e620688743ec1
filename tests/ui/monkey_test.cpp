// Random events of mouse and keyboard through the panels of a whole editor: nothing breaks, all can be undone, and
// memory does not grow.
#include <gtest/gtest.h>
#include <malloc.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <random>

#include "app/editor/preferences/keys.h"
#include "app/editor/preferences/view_switches.h"
#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/app/program.h"
#include "tests/support/app/window_size.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

// Sends random events; what they may open or write lies in a folder of its own.
class Monkey {
 public:
  Monkey(Session& session, unsigned seed) : session_(session), random_(seed) {
    for (const KeyRow& row : key_table()) chords_.push_back(row.chord);
    for (const char* chord : {"Enter", "Tab", "Backspace", "Space", "Delete", "PageDown"}) chords_.emplace_back(chord);
  }

  void act() {
    switch (below(12)) {
      case 0:
      case 1:
      case 2:
        return send("move " + pixel());
      case 3:
      case 4:
        return click();
      case 5:
        return send("press " + button() + " " + pixel() + modifiers());
      case 6:
        return send("release " + button() + " " + pixel() + modifiers());
      case 7:
        return send("wheel " + std::to_string(static_cast<int>(below(7)) - 3) + " " + pixel());
      case 8:
      case 9:
        return send("key " + chord());
      case 10:
        return send("type " + std::string(texts[below(std::size(texts))]));
      default:
        send("press left " + pixel());
        send("move " + pixel());
        send("release left " + pixel());
    }
  }

 private:
  static constexpr const char* texts[] = {
      "1",     "0.25", "collapse", "poke f0", "split 0-1",  "あ",  "undo 3", "orient", "select none",
      "x y z", "-",    "weld 0 1", ";",       "fill_holes", "10%", "/",      "~",      "self_intersections"};

  std::size_t below(std::size_t n) { return random_() % n; }
  std::string button() { return std::array{"left", "right", "middle"}[below(3)]; }
  std::string modifiers() { return std::array{"", "", " Shift", " Ctrl", " Ctrl+Shift", " Alt"}[below(6)]; }
  // Often one that gets on with the mesh: out of a panel, back to the whole, another tool.
  std::string chord() {
    constexpr std::array useful{"Escape", "Escape", "Home", "C", "S", "D", "O", "G", "A", "F10", "Enter", "Down"};
    return below(3) > 0 ? useful[below(useful.size())] : chords_[below(chords_.size())];
  }
  // Rather in the view than on the panels, and sometimes outside of all.
  std::string pixel() {
    const int margin = below(20) == 0 ? 50 : 0;
    const bool in_view = below(3) > 0;
    const int x = in_view ? 380 + static_cast<int>(below(480)) : static_cast<int>(below(1280 + 2 * margin)) - margin;
    const int y = in_view ? 150 + static_cast<int>(below(420)) : static_cast<int>(below(720 + 2 * margin)) - margin;
    return std::to_string(x) + "," + std::to_string(y);
  }
  // On an edge, where the mesh has one that lies in the view.
  std::string on_edge() {
    const Mesh& m = session_.mesh();
    const Halfedge h(m.halfedge_slots() == 0 ? 0 : static_cast<std::uint32_t>(below(m.halfedge_slots())));
    if (m.halfedge_slots() == 0 || !m.is_alive(h)) return pixel();
    const double along = static_cast<double>(below(101)) / 100;
    const glm::dvec3 place = m.position(m.from(h)) * (1 - along) + m.position(m.to(h)) * along;
    const auto at = project(session_.view.camera, session_.view.size, place);
    if (!at || std::abs(at->pixel.x) > 2000 || std::abs(at->pixel.y) > 2000) return pixel();
    const glm::dvec2 in_window = at->pixel + session_.view.origin;
    return std::to_string(in_window.x) + "," + std::to_string(in_window.y);
  }
  void click() {
    const std::string at = below(4) > 0 ? on_edge() : pixel(), with = modifiers();
    send("press left " + at + with);
    send("release left " + at + with);
  }
  void send(const std::string& line) {
    const Outcome outcome = session_.run(line);
    ASSERT_NE(outcome.exit_code, ExitCode::usage) << line << ": " << outcome.sentence.en;
  }

  Session& session_;
  std::mt19937 random_;
  std::vector<std::string> chords_;
};

class MonkeyTest : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    before_ = std::filesystem::current_path();
    std::filesystem::current_path(folder_.path());
    auto made = Headless::make({.backend = Backend::osmesa, .size = test::window, .panels = true});
    ASSERT_TRUE(made);
    headless_ = std::move(made).value();
    session_ = std::make_unique<Session>(std::make_unique<Document>());
    begin_as_window(*session_);
    // The letters of both languages are there for good.
    for (const char* line : {"language ja", "language en"}) {
      session_->run(line);
      headless_->picture(*session_);
    }
    begin();
  }
  // With the file as it was, and nothing of what came before.
  void begin() {
    // A copy: what random keys save replaces the file that is open.
    const std::filesystem::path copy = folder_.at(GetParam());
    std::filesystem::copy_file(test::asset(GetParam()), copy, std::filesystem::copy_options::overwrite_existing);
    auto document = Document::open(copy);
    ASSERT_TRUE(document);
    session_->set_document(std::move(document).value());
    for (const char* line : {"panel none", "prefer all initial", "tool none"}) session_->run(line);
    headless_->place_view(*session_);
    headless_->picture(*session_);
  }
  void TearDown() override { std::filesystem::current_path(before_); }

  void check() {
    const auto broken = check_invariants(session_->mesh());
    ASSERT_FALSE(broken) << broken->sentence;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path before_;
  std::unique_ptr<Headless> headless_;
  std::unique_ptr<Session> session_;
};

// Those of the program; 0 where its memory is not that of the C library, as under sanitizers.
std::size_t bytes_in_use() { return mallinfo2().uordblks; }

TEST_P(MonkeyTest, breaks_nothing_and_all_is_undone) {
  const unsigned seed = 20261123;
  const int rounds = test::is_long_run() ? 10 : 1, events = test::is_long_run() ? 1000 : 500;
  RecordProperty("seed", static_cast<int>(seed));
  Monkey monkey(*session_, seed);
  std::size_t edits = 0, bytes = 0;
  for (int round = 0; round < rounds && !HasFatalFailure(); ++round) {
    if (round > 0) begin();
    std::uint64_t serial = session_->document().serial(), first = session_->mesh().hash();
    for (int i = 1; i <= events && !HasFatalFailure(); ++i) {
      monkey.act();
      if (session_->document().serial() != serial) {  // another document was opened
        serial = session_->document().serial();
        const std::size_t position = session_->document().position();
        session_->document().go_to(0);
        first = session_->mesh().hash();
        session_->document().go_to(position);
      }
      edits = std::max(edits, session_->document().history().size());
      if (i % 100 == 0) check();
    }
    EXPECT_EQ(headless_->picture(*session_).size.width, test::window.width);
    session_->shown.end();  // of a level, a step, or values that are being written
    session_->document().go_to(0);
    check();
    EXPECT_EQ(session_->mesh().hash(), first);
    begin();
    // The first round fills what is kept for good, such as letters and tables.
    if (round == 0) bytes = bytes_in_use();
    EXPECT_LE(bytes_in_use(), bytes + (std::size_t{8} << 20)) << "round " << round;
  }
  EXPECT_GT(edits, 0u) << "it got somewhere";
}

INSTANTIATE_TEST_SUITE_P(Meshes, MonkeyTest,
                         testing::Values("cube.obj", "torus.off", "tetrahedron.off", "fin.obj", "bow_tie.obj",
                                         "duplicate_face.obj", "moebius.off", "collinear.obj", "fan.obj", "ball.off"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace ryosen
