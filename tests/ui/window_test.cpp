// The real window on a display of its own: the pointer hovers and clicks an edge, the mesh changes, Ctrl+Z restores it.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <thread>
#include <utility>

#include "app/editor/session/session.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/names.h"
#include "tests/support/app/laid.h"
#include "tests/support/app/real_window.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

using namespace std::chrono_literals;
using test::Process;
using test::wait_for;

class WindowTest : public test::RealWindow {
 protected:
  // The place of Recover in the question of the window, as panels beside it lay that out.
  glm::dvec2 button_of_recovery() const {
    const test::ScopedVariable home("XDG_STATE_HOME", state_.path().string());
    test::Laid laid("cube.obj", {1280, 800});
    laid.session.run("panel recover");
    laid.frames(3);
    return laid.place_of("Recover Discard");  // followed by Discard: the title has the word, too
  }
};

TEST_F(WindowTest, hover_click_and_undo) {
  open(test::asset("stanford_bunny.obj"));
  const long vertices = last().vertices;
  EXPECT_EQ(vertices, 34834);
  xdotool("mousemove 600 420");
  xdotool("mousemove 604 424");
  ASSERT_TRUE(wait_for([&] { return last().hover != "-" && !last().hover.empty(); })) << "nothing is hovered";
  const long before_tool = last().number;
  xdotool("key c");
  ASSERT_TRUE(wait_for([&] { return last().number > before_tool; }));
  EXPECT_EQ(last().history, 0);

  // Not every edge may collapse; a few pixels on there is one that may.
  for (int i = 0; i < 12 && last().history == 0; ++i) {
    xdotool("mousemove " + std::to_string(604 + 7 * i) + " " + std::to_string(424 + 5 * i) + " click 1");
    wait_for([&] { return last().history > 0; }, 2s);
  }
  ASSERT_EQ(last().history, 1) << "no click collapsed an edge";
  EXPECT_EQ(last().vertices, vertices - 1);

  xdotool("key ctrl+z");
  ASSERT_TRUE(wait_for([&] { return last().history == 0; }));
  EXPECT_EQ(last().vertices, vertices);
  xdotool("key ctrl+shift+z");
  ASSERT_TRUE(wait_for([&] { return last().history == 1; }));
}

// What takes a while to be read is not waited for behind a black window.
TEST_F(WindowTest, shows_itself_before_a_large_file_is_read) {
  open(test::asset("stanford_bunny.obj"));
  const std::string log = test::read_file(folder_.at("frames"));
  const std::size_t reading = log.find("reading ");
  ASSERT_NE(reading, log.npos) << log;
  EXPECT_LT(reading, log.find("frame 1 "));
  EXPECT_EQ(last().vertices, 34834);
  EXPECT_EQ(last().history, 0);
}

// Where the window shows the middle of an edge that is seen, as a session with the same panels says.
std::string on_an_edge(const std::string& asset) {
  test::Laid laid("cube.obj", {1280, 800});
  Session& session = laid.session;
  session.frontend.turns_to_solids = session.view.shows_axes = true;
  laid.open(asset);
  const Mesh& m = session.mesh();
  for (std::uint32_t i = 0; i < m.edge_slots(); ++i) {
    const auto [a, b] = ends(m, Edge(i));
    const auto at = project(session.view.camera, session.view.size, (m.position(a) + m.position(b)) / 2.0);
    const glm::dvec2 pixel = at->pixel + session.view.origin;
    const auto picked = session.pointing.pick(pixel, PickMode::edge);
    if (picked && picked->element == Element(Edge(i)))
      return std::to_string(std::lround(pixel.x)) + " " + std::to_string(std::lround(pixel.y));
  }
  return "0 0";
}

TEST_F(WindowTest, holds_the_verdict_of_a_refused_click_until_its_remedy_is_done) {
  open(test::asset("tetrahedron.off"));
  xdotool("mousemove 640 100 key c mousemove " + on_an_edge("tetrahedron.off"));
  ASSERT_TRUE(wait_for([&] { return last().hover != "-" && !last().hover.empty(); })) << "nothing is hovered";
  const std::string edge = last().hover;
  xdotool("click 1");
  ASSERT_TRUE(wait_for([&] { return last().is_held; })) << "the click was not refused";
  const long before = last().number;
  xdotool("mousemove 300 100 mousemove 1100 300 mousemove 640 90");
  wait_for([&] { return last().number > before; }, 1s);
  EXPECT_EQ(last().hover, edge);
  EXPECT_EQ(last().history, 0);
  xdotool("key Return");
  ASSERT_TRUE(wait_for([&] { return last().history == 1; })) << "Enter does the first remedy";
  xdotool("key Escape");
  ASSERT_TRUE(wait_for([&] { return !last().is_held; }));
}

TEST_F(WindowTest, wheel_and_walks_move_the_eye) {
  open(test::asset("torus.off"));
  const std::string edge = on_an_edge("torus.off");
  const glm::dvec3 eye = last().eye;
  xdotool("mousemove " + edge + " click 4");
  ASSERT_TRUE(wait_for([&] { return last().eye != eye; })) << "the wheel does not zoom";
  xdotool("key Home");
  ASSERT_TRUE(wait_for([&] { return last().eye == eye; }));
  xdotool("key 4 mousemove " + edge + " click 1");
  ASSERT_TRUE(wait_for([&] { return last().selected == 1; })) << "a halfedge is selected by a click";
  for (int i = 0; i < 40 && last().eye == eye; ++i) {
    const long before = last().number;
    xdotool("key Right key Right key Up");  // across the faces, round the torus
    wait_for([&] { return last().number > before; }, 2s);
  }
  EXPECT_NE(last().eye, eye) << "the camera follows to where the next halfedge is hidden";
  EXPECT_EQ(last().selected, 1);
}

TEST_F(WindowTest, a_drag_of_a_handle_moves_the_selection) {
  open(test::asset("torus.off"));
  type("select v0");
  ASSERT_TRUE(wait_for([&] { return last().selected == 1; }));
  test::Laid laid("torus.off", {1280, 800});
  laid.session.view.gizmo_kind = GizmoKind::move;
  ASSERT_TRUE(laid.session.run("select v0").done());
  const auto gizmo = laid.session.pointing.gizmo();
  ASSERT_TRUE(gizmo);
  const auto up = std::find_if(gizmo->handles.begin(), gizmo->handles.end(),
                               [](const GizmoHandle& handle) { return handle.row->way == HandleWay::y; });
  ASSERT_NE(up, gizmo->handles.end());
  const glm::dvec2 on_it =
      project(laid.session.view.camera, laid.session.view.size, 0.5 * (up->strokes[0].a + up->strokes[0].b))->pixel +
      laid.session.view.origin;
  const auto mousemove = [&](double x, double y) {
    xdotool("mousemove " + std::to_string(std::lround(on_it.x + x)) + " " + std::to_string(std::lround(on_it.y + y)));
  };
  const glm::dvec3 eye = last().eye;
  // The command window may lie over the view for a picture more, so the pointer moves until it is gone.
  for (int i = 0; i < 20 && last().hover != "handle"; ++i) {
    mousemove(0, i % 2);
    wait_for([&] { return last().hover == "handle"; }, 1s);
  }
  ASSERT_EQ(last().hover, "handle") << "the pointer is on no handle";
  xdotool("mousedown 1");
  mousemove(0, -20);
  mousemove(4, -60);
  xdotool("key Escape");
  mousemove(30, -10);
  xdotool("mouseup 1");
  mousemove(0, 0);
  ASSERT_TRUE(wait_for([&] { return last().hover == "handle"; })) << "Escape has put it back";
  EXPECT_EQ(last().history, 0);
  xdotool("mousedown 1");
  mousemove(0, -20);
  mousemove(4, -60);
  xdotool("mouseup 1");
  ASSERT_TRUE(wait_for([&] { return last().history == 1; })) << "it was not moved";
  EXPECT_EQ(last().selected, 1);
  EXPECT_EQ(last().eye, eye) << "no drag of the camera";
}

// Where the window shows a place at a share of an edge that is seen and long enough to be divided, and the edge.
struct OnEdge {
  std::string pixel, edge;
  glm::dvec3 place{0};
};
OnEdge on_long_edge(const std::string& file, double share) {
  test::Laid laid("cube.obj", {1280, 800});
  laid.session.frontend.turns_to_solids = laid.session.view.shows_axes = true;
  EXPECT_TRUE(laid.session.run("open " + file).done());
  laid.session.framing.frame_all();
  const Mesh& m = laid.session.mesh();
  for (std::uint32_t i = 0; i < m.edge_slots(); ++i) {
    const auto [a, b] = ends(m, Edge(i));
    const glm::dvec3 place = m.position(a) + share * (m.position(b) - m.position(a));
    const auto from = project(laid.session.view.camera, laid.session.view.size, m.position(a));
    const auto to = project(laid.session.view.camera, laid.session.view.size, m.position(b));
    const glm::dvec2 pixel =
        glm::round(project(laid.session.view.camera, laid.session.view.size, place)->pixel + laid.session.view.origin);
    const auto picked = laid.session.pointing.pick(pixel, PickMode::edge);
    if (glm::distance(from->pixel, to->pixel) < 60 || !picked || picked->element != Element(Edge(i))) continue;
    return {std::to_string(std::lround(pixel.x)) + " " + std::to_string(std::lround(pixel.y)), name_of(m, Edge(i)),
            place};
  }
  return {};
}

TEST_F(WindowTest, selects_and_converts_by_mouse_and_keys) {
  const std::string mesh = folder_.copy(test::asset("cube.obj"), "cube.obj");
  open(mesh);
  const OnEdge at = on_long_edge(mesh, 0.3);
  ASSERT_FALSE(at.pixel.empty());
  const auto has_selected = [&](long n) { return wait_for([&] { return last().selected == n; }); };
  xdotool("mousemove " + at.pixel + " click 1");
  ASSERT_TRUE(has_selected(1)) << "a click selects the edge";
  xdotool("key ctrl+1");
  ASSERT_TRUE(has_selected(2)) << "its two ends";
  xdotool("key a");
  ASSERT_TRUE(has_selected(8)) << "all vertices";
  xdotool("key i");
  ASSERT_TRUE(has_selected(0)) << "none are left";
  xdotool("key 3 key a");
  ASSERT_TRUE(has_selected(6)) << "all faces";
}

// Until the camera has been moved the mesh is whole in the view of any size.
TEST_F(WindowTest, frames_the_mesh_anew_when_it_is_resized_before_anything_else) {
  open(test::asset("torus.off"));
  const glm::dvec3 eye = last().eye;
  const auto resize = [&](const char* size) {
    xdotool("search --sync --onlyvisible --name torus windowsize " + std::string(size));
  };
  resize("700 800");
  ASSERT_TRUE(wait_for([&] { return glm::length(last().eye) > 1.05 * glm::length(eye); })) << "it is cut at both sides";
  const glm::dvec3 narrow = last().eye;
  xdotool("mousemove 350 400 click 4");
  ASSERT_TRUE(wait_for([&] { return last().eye != narrow; }));
  const glm::dvec3 mine = last().eye;
  resize("1280 800");
  xdotool("key a");
  ASSERT_TRUE(wait_for([&] { return last().selected > 0; })) << "what came after the new size";
  EXPECT_EQ(last().eye, mine) << "a view that was chosen stays";
}

TEST_F(WindowTest, draws_nothing_when_nothing_changes) {
  open(test::asset("torus.off"));
  xdotool("mousemove 640 400");
  // It settles and is refined, part after part, for seconds of processor time, which a busy machine may give it in
  // minutes; then it rests.
  long before = -1;
  auto shown_last = std::chrono::steady_clock::now();
  ASSERT_TRUE(wait_for(
      [&] {
        const auto now = std::chrono::steady_clock::now();
        if (const long number = last().number; number != before) {
          before = number;
          shown_last = now;
        }
        return now - shown_last >= 1s || editor_->processor_time() > 60s;
      },
      300s));
  EXPECT_EQ(last().number, before) << "it never rests";
  // Showing a part takes as long as showing them all: where each was shown, or that counted as what refining it costs,
  // there were hundreds or thousands of frames for this window.
  EXPECT_LT(before, 200) << "it is refined in parts that are shown one by one";
  // A drag turns the view: several pictures of all of it.
  xdotool("mousemove 640 400 mousedown 1 mousemove 660 410 mousemove 690 420 mouseup 1");
  EXPECT_TRUE(wait_for([&] { return last().number > before; }));
  EXPECT_EQ(last().history, 0) << "a drag is no click";
}

TEST_F(WindowTest, after_a_crash_the_next_start_brings_the_edits_back) {
  const std::string mesh = folder_.copy(test::asset("torus.off"), "torus.off");
  open(mesh);
  const long vertices = last().vertices;
  type("split 0-1");
  ASSERT_TRUE(wait_for([&] { return last().history == 1; })) << "nothing was split";
  EXPECT_EQ(state_.names().size(), 2u);
  editor_->end_by(SIGKILL);
  EXPECT_EQ(state_.names().size(), 2u);
  EXPECT_EQ(test::read_file(mesh), test::read_file(test::asset("torus.off")));

  // Another mesh is opened this time; the dialog lies over it.
  std::filesystem::remove(folder_.at("frames"));
  open(test::asset("cube.obj"));
  EXPECT_EQ(last().vertices, 8);
  const glm::dvec2 button = button_of_recovery();
  xdotool("mousemove " + test::words_of(button - glm::dvec2(2)));
  xdotool("mousemove " + test::words_of(button) + " click 1");
  ASSERT_TRUE(wait_for([&] { return last().history == 1; })) << "nothing was recovered";
  EXPECT_EQ(last().vertices, vertices + 1);
  EXPECT_EQ(state_.names().size(), 2u) << "still unsaved";
  xdotool("mousemove 640 400 key ctrl+s");
  ASSERT_TRUE(wait_for([&] { return test::read_file(mesh) != test::read_file(test::asset("torus.off")); }));
  xdotool("key ctrl+q");
  ASSERT_TRUE(wait_for([&] { return editor_->is_over(); }));
  EXPECT_EQ(editor_->exit_code(), 0);
  EXPECT_TRUE(state_.names().empty()) << "nothing is left to recover";
}

// One question at a time: that of the recovery comes once the file is read.
TEST_F(WindowTest, offers_recovery_once_a_large_file_is_read) {
  open(folder_.copy(test::asset("torus.off"), "torus.off"));
  type("split 0-1");
  ASSERT_TRUE(wait_for([&] { return last().history == 1; })) << "nothing was split";
  editor_->end_by(SIGKILL);
  std::filesystem::remove(folder_.at("frames"));
  open(test::asset("stanford_bunny.obj"));
  const std::string log = test::read_file(folder_.at("frames"));
  EXPECT_NE(log.find("stanford_bunny.obj panel -\n"), log.npos) << log;
  EXPECT_EQ(last().vertices, 34834);
  EXPECT_EQ(last().panel, "recover");
}

TEST_F(WindowTest, goes_on_while_a_large_file_is_opened_in_it) {
  open(test::asset("torus.off"));
  EXPECT_EQ(test::read_file(folder_.at("frames")).find("reading "), std::string::npos);
  type("open " + folder_.copy(test::asset("stanford_bunny.obj"), "bunny.obj"));  // which keys can type
  ASSERT_TRUE(wait_for([&] { return last().vertices == 34834; })) << "it was not opened";
  EXPECT_NE(test::read_file(folder_.at("frames")).find("reading "), std::string::npos) << "nor beside the frames";
}

TEST_F(WindowTest, shows_long_work_and_lets_it_be_cancelled) {
  open(folder_.write("band.obj", test::bands_around_holes()));
  const long vertices = last().vertices;
  type("repair fill_holes");
  const auto is_shown = [&] { return test::read_file(folder_.at("frames")).find("progress ") != std::string::npos; };
  ASSERT_TRUE(wait_for(is_shown)) << "no progress is shown";
  xdotool("key Escape");
  const auto is_over = [&] {
    const std::string log = test::read_file(folder_.at("frames"));
    return log.rfind("frame ") > log.rfind("progress ");
  };
  ASSERT_TRUE(wait_for(is_over)) << "the work goes on";
  EXPECT_EQ(last().history, 0);
  EXPECT_EQ(last().vertices, vertices);
  xdotool("key ctrl+q");
  ASSERT_TRUE(wait_for([&] { return editor_->is_over(); })) << "it asks to save what is not there";
  EXPECT_EQ(editor_->exit_code(), 0);
}

TEST_F(WindowTest, keeps_what_the_user_prefers_for_the_next_time) {
  const std::string mesh = folder_.copy(test::asset("torus.off"), "torus.off");
  const auto kept = [&](const std::string& name, const std::string& line) {
    const std::string file = (config_.path() / "ryosen" / name).string();
    return std::filesystem::exists(file) && test::read_file(file).find(line) != std::string::npos;
  };
  open(mesh);
  say("bind Ctrl+K split 0-1");
  ASSERT_TRUE(wait_for([&] { return kept("preferences", "bind Ctrl+K split 0-1\n"); }));
  say("panel totals off");
  ASSERT_TRUE(wait_for([&] { return kept("layout", "panel totals off\n"); }));
  EXPECT_TRUE(kept("recent", mesh));
  say("axes off");
  ASSERT_TRUE(wait_for([&] { return kept("preferences", "axes off\n"); }));
  xdotool("mousemove 640 400 key ctrl+q");
  ASSERT_TRUE(wait_for([&] { return editor_->is_over(); }));
  std::filesystem::remove(folder_.at("frames"));
  open(mesh);
  xdotool("mousemove 640 400 key ctrl+k");
  EXPECT_TRUE(wait_for([&] { return last().history == 1; })) << "the key is not known any more";
  EXPECT_TRUE(kept("layout", "panel totals off\n"));
}

class SmallDisplay : public test::RealWindow {
 protected:
  std::string screen() const override { return "640x480x24"; }
};

TEST_F(SmallDisplay, has_a_window_that_is_no_larger) {
  open(test::asset("torus.off"));
  ASSERT_EQ(std::system(("DISPLAY=:" + number_ + " xdotool search --name torus getwindowgeometry --shell >" +
                         folder_.at("geometry"))
                            .c_str()),
            0);
  const std::string geometry = test::read_file(folder_.at("geometry"));
  EXPECT_NE(geometry.find("WIDTH=640\nHEIGHT=480"), std::string::npos) << geometry;
}

TEST_F(WindowTest, ends_when_asked_to) {
  open(test::asset("torus.off"));
  xdotool("mousemove 640 400 key ctrl+q");
  ASSERT_TRUE(wait_for([&] { return editor_->is_over(); }));
  EXPECT_EQ(editor_->exit_code(), 0);
}

TEST_F(WindowTest, a_signal_ends_it_and_leaves_its_edits_to_be_recovered) {
  const std::string mesh = folder_.copy(test::asset("torus.off"), "torus.off"), content = test::read_file(mesh);
  const std::vector<std::string> state{"XDG_STATE_HOME=" + state_.path().string()};
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    if (signal == SIGTERM && !test::is_long_run()) continue;  // which the next test sends
    SCOPED_TRACE(signal);
    open(mesh);
    type("split 0-1");
    ASSERT_TRUE(wait_for([&] { return last().history == 1; })) << "nothing was split";
    const long vertices = last().vertices;
    expect_end_by(signal);
    EXPECT_EQ(test::read_file(mesh), content);
    EXPECT_EQ(state_.names().size(), 2u);
    const auto again =
        test::run_program({"edit", "--new", "--do", "recover 1; expect V " + std::to_string(vertices)}, {}, state);
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(test::run_program({"edit", "--new", "--do", "recover discard 1"}, {}, state).exit_code, 0);
    EXPECT_TRUE(state_.names().empty());
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"display", "err", "torus.off"})) << "something is left over";
  }
}

// Nothing was edited, so that there is nothing to recover; and what is at work is not waited for.
TEST_F(WindowTest, a_signal_ends_it_while_it_works) {
  open(folder_.write("band.obj", test::bands_around_holes()));
  type("repair fill_holes");
  const auto is_shown = [&] { return test::read_file(folder_.at("frames")).find("progress ") != std::string::npos; };
  ASSERT_TRUE(wait_for(is_shown)) << "no progress is shown";
  expect_end_by(SIGTERM);
  EXPECT_TRUE(state_.names().empty());
}

TEST_F(WindowTest, a_signal_ends_its_start_at_any_moment) {
  const std::string mesh = folder_.copy(test::asset("torus.off"), "torus.off");
  for (int after_ms = 0; after_ms < 400; after_ms += test::is_long_run() ? 40 : 80) {
    editor_ = std::make_unique<Process>(
        std::vector<std::string>{RYOSEN_PROGRAM, mesh},
        std::vector<std::string>{"DISPLAY=:" + number_, "LC_ALL=C", "XDG_STATE_HOME=" + state_.path().string(),
                                 "XDG_CONFIG_HOME=" + config_.path().string()},
        "/dev/null", folder_.at("err"));
    ASSERT_TRUE(wait_for([&] { return editor_->handles(SIGTERM); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(after_ms));
    editor_->end_by(SIGTERM);
    EXPECT_EQ(editor_->exit_code(), 8) << after_ms;
    EXPECT_NE(test::read_file(folder_.at("err")), "") << after_ms;
    EXPECT_TRUE(state_.names().empty());
  }
}

}  // namespace
}  // namespace ryosen
