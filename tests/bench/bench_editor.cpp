// The editor's reactions at 1280x720 through OSMesa: hover, edit, frames. RYOSEN_DRAGON=FILE.ply.gz adds the dragon.
#include <benchmark/benchmark.h>

#include <chrono>
#include <random>

#include "app/editor/session.h"
#include "app/ui/viewport.h"
#include "render/context/context.h"
#include "tests/bench/bench_meshes.h"

namespace ryosen::bench {
namespace {

using Source = const IndexedMesh& (*)();
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::unique_ptr<Session> open_session(Source source) {
  MeshFile file;
  file.mesh = source();
  auto session = std::make_unique<Session>(std::make_unique<Document>(std::move(file)));
  session->tool = "collapse";
  session->picker();
  session->highlights();
  return session;
}

// Pixels that lie on the mesh.
std::vector<glm::dvec2> pixels_on(Session& session, std::size_t count) {
  std::mt19937 random(1);
  std::vector<glm::dvec2> pixels;
  while (pixels.size() < count) {
    const glm::dvec2 pixel(0.5 + static_cast<double>(random() % 1280), 0.5 + static_cast<double>(random() % 720));
    session.point_at(pixel);
    if (session.hover() && session.hover()->op) pixels.push_back(pixel);
  }
  return pixels;
}

void hover_verdict(benchmark::State& state, Source source) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  const auto session = open_session(source);
  const std::vector<glm::dvec2> pixels = pixels_on(*session, 1000);
  std::size_t i = 0;
  for (auto _ : state) session->point_at(pixels[i++ % pixels.size()]);
}

// One collapse under the pointer with everything that follows it: tree, highlights, hover; undone outside the time.
void edit_and_follow(benchmark::State& state, Source source) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  const auto session = open_session(source);
  std::vector<glm::dvec2> pixels = pixels_on(*session, 500);
  session->point_away();
  std::size_t i = 0;
  for (auto _ : state) {
    const auto start = Clock::now();
    const Outcome outcome = session->click(pixels[i++ % pixels.size()], "collapse");
    state.SetIterationTime(seconds_since(start));
    if (outcome.done()) session->document().undo();
  }
}

struct Screen {
  std::unique_ptr<Context> context;
  std::unique_ptr<Viewport> viewport;
};

Screen open_screen() {
  Screen screen;
  auto context = make_headless_context(Backend::osmesa);
  if (!context) return screen;
  screen.context = std::move(context).value();
  auto viewport = Viewport::make();
  if (viewport) screen.viewport = std::move(viewport).value();
  return screen;
}

enum class Reaction { camera, hover, edit };

void redraw(benchmark::State& state, Source source, Reaction reaction) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  Screen screen = open_screen();
  if (!screen.viewport) return state.SkipWithError("no OSMesa");
  const auto session = open_session(source);
  const std::vector<glm::dvec2> pixels = pixels_on(*session, 500);
  session->point_away();
  Viewport& viewport = *screen.viewport;
  const auto show = [&] {
    viewport.follow(*session);
    viewport.draw();
    benchmark::DoNotOptimize(viewport.view().picture());
  };
  show();
  std::size_t i = 0;
  for (auto _ : state) {
    const glm::dvec2 pixel = pixels[i++ % pixels.size()];
    const auto start = Clock::now();
    if (reaction == Reaction::camera) session->camera = orbited(session->camera, {3, 1}, session->view);
    if (reaction == Reaction::hover) session->point_at(pixel);
    if (reaction == Reaction::edit) session->click(pixel, "collapse");
    show();
    state.SetIterationTime(seconds_since(start));
  }
}

BENCHMARK_CAPTURE(hover_verdict, bunny, bunny)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(hover_verdict, dragon, dragon)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(edit_and_follow, bunny, bunny)->UseManualTime()->Unit(benchmark::kMicrosecond)->Iterations(500);
BENCHMARK_CAPTURE(edit_and_follow, dragon, dragon)->UseManualTime()->Unit(benchmark::kMicrosecond)->Iterations(500);
BENCHMARK_CAPTURE(redraw, bunny_camera, bunny, Reaction::camera)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(50);
BENCHMARK_CAPTURE(redraw, bunny_hover, bunny, Reaction::hover)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(300);
BENCHMARK_CAPTURE(redraw, bunny_edit, bunny, Reaction::edit)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(300);
BENCHMARK_CAPTURE(redraw, dragon_hover, dragon, Reaction::hover)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(100);
BENCHMARK_CAPTURE(redraw, dragon_edit, dragon, Reaction::edit)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(100);

}  // namespace
}  // namespace ryosen::bench

BENCHMARK_MAIN();
