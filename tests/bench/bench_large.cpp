// How the editor reacts to a mesh of 10 million triangles beside the dragon, at 1280x720 through OSMesa. Frames that
// follow a moving camera have a bar of their own; hover, verdict and edit are to cost what they cost on the dragon,
// within twice.
//   bench_large [MILLIONS]   with RYOSEN_DRAGON=FILE.ply.gz
#include <cmath>
#include <cstdlib>
#include <random>
#include <thread>

#include "app/editor/session/session.h"
#include "app/ui/viewport.h"
#include "render/context/context.h"
#include "render/gl/api.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/cost.h"
#include "tests/bench/generated_meshes.h"

namespace ryosen::bench {
namespace {

constexpr double frame_bar_ms = 150, wait_bar_ms = 50;

struct Reactions {
  Costs first_picture, moving_frame, hover, verdict, edit, waiting_edit;
};

class LargeScene {
 public:
  LargeScene(IndexedMesh mesh, Viewport& viewport) : viewport_(viewport) {
    MeshFile file;
    file.mesh = std::move(mesh);
    session_ = std::make_unique<Session>(std::make_unique<Document>(std::move(file)));
  }

  Reactions run() {
    Reactions costs;
    session_->prepare();  // as a window does, which draws no highlights before they are found
    costs.first_picture.add(cost_of([&] { show(); }));
    edit_while_preparing(costs.waiting_edit);
    move_camera(costs.moving_frame);
    viewport_.hurry();
    show();
    point(costs.hover, "");
    point(costs.verdict, "collapse");
    edit(costs.edit);
    return costs;
  }

 private:
  void show() {
    viewport_.follow(*session_);
    viewport_.draw();
    glFinish();
  }

  // A line of a collapse that is legal.
  std::string collapse() {
    const Mesh& mesh = session_->mesh();
    for (;;) {
      const CollapseEdge op{Halfedge(static_cast<std::uint32_t>(random_() % mesh.halfedge_slots()))};
      if (mesh.is_alive(op.halfedge) && op.check(mesh).legal()) return command_of(mesh, op);
    }
  }

  // At moments all over the time that it takes.
  void edit_while_preparing(Costs& costs) {
    constexpr int moments = 12;
    const std::chrono::nanoseconds step(30 * session_->mesh().live().faces);
    for (int i = 0; i < moments; ++i) {
      const std::string line = collapse();
      session_->prepare();
      std::this_thread::sleep_for(i * step);
      costs.add(cost_of([&] { session_->run(line); }));
      session_->document().undo();
    }
  }

  void move_camera(Costs& costs) {
    constexpr int frames = 25, first_ones = 5;  // the pace is found in those
    for (int i = 0; i < frames; ++i) {
      session_->view.camera = orbited(session_->view.camera, {3, 1}, session_->view.size, session_->view.camera.target);
      const auto begin = FramePace::Clock::now();
      const Cost cost = cost_of([&] {
        viewport_.follow(*session_);
        viewport_.keep_pace(session_->view, begin);
        viewport_.draw();
        glFinish();
      });
      viewport_.took(FramePace::Clock::now() - begin);
      if (i >= first_ones) costs.add(cost);
    }
  }

  void point(Costs& costs, const char* tool) {
    session_->selecting.tool = tool;
    for (const glm::dvec2& pixel : pixels()) costs.add(cost_of([&] { session_->pointing.point_at(pixel); }));
    session_->pointing.point_away();
  }

  void edit(Costs& costs) {
    for (const glm::dvec2& pixel : pixels()) {
      const Cost cost = cost_of([&] {
        session_->pointing.click(pixel, "collapse");
        show();
      });
      costs.add(cost);
    }
  }

  // That lie on the mesh.
  const std::vector<glm::dvec2>& pixels() {
    constexpr std::size_t count = 200;
    session_->selecting.mode = PickMode::edge;
    while (pixels_.size() < count) {
      const glm::dvec2 pixel(0.5 + static_cast<double>(random_() % 1280), 0.5 + static_cast<double>(random_() % 720));
      if (session_->pointing.pick(pixel, PickMode::edge)) pixels_.push_back(pixel);
    }
    return pixels_;
  }

  Viewport& viewport_;
  std::unique_ptr<Session> session_;
  std::mt19937 random_{1};
  std::vector<glm::dvec2> pixels_;
};

void print_pair(const char* name, const Costs& dragon, const Costs& large, double bar_ms) {
  std::printf("%-26s %10.3f %10.3f %10.3f %7.2fx %10.3f %10.3f", name, dragon.median(), large.median(), large.most(),
              large.median() / dragon.median(), dragon.mean_cpu(), large.mean_cpu());
  const bool is_reached = bar_ms > 0 ? large.most() <= bar_ms : large.median() <= 2 * dragon.median();
  std::printf("   %s\n", bar_ms < 0 ? "" : is_reached ? "reached" : "short");
}

int run(double millions) {
  if (dragon().positions.empty()) {
    std::fputs("RYOSEN_DRAGON is not set\n", stderr);
    return 2;
  }
  auto context = make_headless_context(Backend::osmesa);
  if (!context) return 1;
  const auto columns = static_cast<std::uint32_t>(std::lround(std::sqrt(millions * 1e6 / 4)));
  const auto reactions_to = [](IndexedMesh mesh) {
    auto viewport = Viewport::make();
    return LargeScene(std::move(mesh), **viewport).run();
  };
  const Reactions small = reactions_to(dragon()), large = reactions_to(torus(2 * columns, columns));
  std::printf("%-26s %10s %10s %10s %8s %10s %10s\n", "ms", "dragon", "large", "its most", "ratio", "mean cpu",
              "mean cpu");
  print_pair("mesh to picture", small.first_picture, large.first_picture, -1);
  print_pair("frame of a moving camera", small.moving_frame, large.moving_frame, frame_bar_ms);
  print_pair("hover", small.hover, large.hover, 0);
  print_pair("verdict", small.verdict, large.verdict, 0);
  print_pair("edit and its picture", small.edit, large.edit, 0);
  print_pair("edit amid preparation", small.waiting_edit, large.waiting_edit, wait_bar_ms);
  return 0;
}

}  // namespace
}  // namespace ryosen::bench

int main(int argc, char** argv) { return ryosen::bench::run(argc > 1 ? std::atof(argv[1]) : 10); }
