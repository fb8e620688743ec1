// The editor's reactions at 1280x720 through OSMesa: hover, edit, frames, tiles. RYOSEN_DRAGON=FILE.ply.gz adds the
// dragon. All times are those of the processor, of all threads together, so that they say the same on a busy machine.
#include <benchmark/benchmark.h>

#include <time.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "app/editor/session/session.h"
#include "app/ui/gui.h"
#include "app/ui/viewport.h"
#include "render/context/context.h"
#include "render/gl/api.h"
#include "tests/bench/bench_meshes.h"

namespace ryosen::bench {
namespace {

using Source = const IndexedMesh& (*)();

// Of the processor, in seconds; since the process began.
double now() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
double seconds_since(double start) { return now() - start; }

std::unique_ptr<Session> open_session(Source source) {
  MeshFile file;
  file.mesh = source();
  auto session = std::make_unique<Session>(std::make_unique<Document>(std::move(file)));
  session->selecting.tool = "collapse";
  session->findings().picker();
  session->findings().highlights();
  return session;
}

// Pixels that lie on the mesh.
std::vector<glm::dvec2> pixels_on(Session& session, std::size_t count) {
  std::mt19937 random(1);
  std::vector<glm::dvec2> pixels;
  while (pixels.size() < count) {
    const glm::dvec2 pixel(0.5 + static_cast<double>(random() % 1280), 0.5 + static_cast<double>(random() % 720));
    session.pointing.point_at(pixel);
    if (session.selecting.hover() && session.selecting.hover()->op) pixels.push_back(pixel);
  }
  return pixels;
}

void hover_verdict(benchmark::State& state, Source source) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  const auto session = open_session(source);
  const std::vector<glm::dvec2> pixels = pixels_on(*session, 1000);
  std::size_t i = 0;
  for (auto _ : state) session->pointing.point_at(pixels[i++ % pixels.size()]);
}

// One collapse under the pointer with everything that follows it: tree, highlights, hover; undone outside the time.
void edit_and_follow(benchmark::State& state, Source source) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  const auto session = open_session(source);
  std::vector<glm::dvec2> pixels = pixels_on(*session, 500);
  session->pointing.point_away();
  std::size_t i = 0;
  for (auto _ : state) {
    const auto start = now();
    const Outcome outcome = session->pointing.click(pixels[i++ % pixels.size()], "collapse");
    state.SetIterationTime(seconds_since(start));
    if (outcome.done()) session->document().undo();
  }
}

// Names of edges whose collapse is legal, all over the mesh.
std::vector<std::string> legal_collapses(Session& session, std::size_t count) {
  const Mesh& mesh = session.mesh();
  std::mt19937 random(1);
  std::vector<std::string> lines;
  while (lines.size() < count) {
    const CollapseEdge op{Halfedge(random() % mesh.halfedge_slots())};
    if (mesh.is_alive(op.halfedge) && op.check(mesh).legal()) lines.push_back(command_of(mesh, op));
  }
  return lines;
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

// One collapse by the names of its edge's ends, with everything that keeps up with it: tree, highlights, totals,
// problems. With `panels` also a frame of the panels, laid out and not drawn. `undo` times the undo instead.
enum class Part { collapse, undo, panels, view };

void edit_by_name(benchmark::State& state, Source source, Part part) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  const auto session = open_session(source);
  session->findings().euler_terms();
  const std::vector<std::string> lines = legal_collapses(*session, 500);
  constexpr Size window{1280, 720};
  Gui gui(1);
  gui.place_view(*session, window);
  session->framing.frame_all();
  Screen screen;
  if (part == Part::view) screen = open_screen();
  if (part == Part::view && !screen.viewport) return state.SkipWithError("no OSMesa");
  const auto follow = [&] {
    if (part == Part::panels) {
      gui.prepare(*session);
      gui.frame(*session, window, 0.02);
    }
    if (part == Part::view) {
      screen.viewport->follow(*session);
      screen.viewport->draw();
      glFinish();
    }
  };
  for (int i = 0; i < 3; ++i) follow();
  std::size_t i = 0;
  for (auto _ : state) {
    const auto start = now();
    const Outcome outcome = gui.run(*session, lines[i++ % lines.size()]);
    follow();
    const double collapse = seconds_since(start);
    if (!outcome.done()) return state.SkipWithError("refused");
    const auto back = now();
    gui.run(*session, "undo");
    follow();
    state.SetIterationTime(part == Part::undo ? seconds_since(back) : collapse);
  }
}

enum class Reaction { camera, hover, edit };

void redraw(benchmark::State& state, Source source, Reaction reaction) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  Screen screen = open_screen();
  if (!screen.viewport) return state.SkipWithError("no OSMesa");
  const auto session = open_session(source);
  const std::vector<glm::dvec2> pixels = pixels_on(*session, 500);
  session->pointing.point_away();
  Viewport& viewport = *screen.viewport;
  const auto show = [&] {
    viewport.follow(*session);
    viewport.draw();
    glFinish();
  };
  show();
  std::size_t i = 0;
  for (auto _ : state) {
    const glm::dvec2 pixel = pixels[i++ % pixels.size()];
    const auto start = now();
    if (reaction == Reaction::camera)
      session->view.camera = orbited(session->view.camera, {3, 1}, session->view.size, session->view.camera.target);
    if (reaction == Reaction::hover) session->pointing.point_at(pixel);
    if (reaction == Reaction::edit) session->pointing.click(pixel, "collapse");
    show();
    state.SetIterationTime(seconds_since(start));
  }
}

// A step of moving about a hundred neighbouring vertices by hand, with its picture.
void gesture_step(benchmark::State& state, Source source) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  Screen screen = open_screen();
  if (!screen.viewport) return state.SkipWithError("no OSMesa");
  const auto session = open_session(source);
  const glm::dvec2 pixel = pixels_on(*session, 1)[0];
  session->run("tool none");
  session->run("mode vertex");
  session->pointing.click(pixel, "");
  for (int i = 0; i < 20 && session->selecting.selection.size() < 90; ++i) session->run("select grow");
  session->view.pointer = pixel;
  session->gesturing.begin(PointTransform::Kind::move);
  Viewport& viewport = *screen.viewport;
  int step = 0;
  const auto show = [&] {
    session->gesturing.follow(pixel + glm::dvec2(step % 7, step % 5), {});
    ++step;
    viewport.follow(*session);
    viewport.draw();
    glFinish();
  };
  show();
  for (auto _ : state) {
    const auto start = now();
    show();
    state.SetIterationTime(seconds_since(start));
  }
  state.counters["vertices"] = static_cast<double>(session->selecting.selection.size());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

// Camera frames of the same views, flat and smooth in turns; the ratio of their medians is the counter.
void smooth_frame(benchmark::State& state, Source source) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  const Screen screen = open_screen();
  auto second = screen.viewport ? Viewport::make() : Result<std::unique_ptr<Viewport>>(nullptr);
  if (!screen.viewport || !second) return state.SkipWithError("no OSMesa");
  Viewport* const viewports[] = {screen.viewport.get(), second->get()};
  const std::unique_ptr<Session> sessions[] = {open_session(source), open_session(source)};
  sessions[1]->run("shading smooth");
  std::vector<double> times[2];
  const auto frame = [&](std::size_t which) {
    Session& session = *sessions[which];
    session.view.camera = orbited(session.view.camera, {3, 1}, session.view.size, session.view.camera.target);
    const auto start = now();
    viewports[which]->follow(session);
    viewports[which]->draw();
    glFinish();
    return seconds_since(start);
  };
  for (const std::size_t which : {0u, 1u, 0u, 1u}) frame(which);
  for (auto _ : state) {
    for (const std::size_t which : {0u, 1u}) times[which].push_back(frame(which));
    state.SetIterationTime(times[1].back());
  }
  state.counters["smooth/flat"] = median(times[1]) / median(times[0]);
}

// The tiles in which a picture is refined, one to a frame and as large as the window has them; with these lines run
// before.
void refined_tile(benchmark::State& state, Source source, std::vector<std::string> lines) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  const Screen screen = open_screen();
  if (!screen.viewport) return state.SkipWithError("no OSMesa");
  const auto session = open_session(source);
  for (const std::string& line : lines) session->run(line);
  Viewport& viewport = *screen.viewport;
  viewport.prepare_refining(*session);
  FramePace::Clock::time_point moment{};
  const auto frame = [&] {
    moment += std::chrono::seconds(1);  // nothing moves for longer than that takes to be seen
    viewport.follow(*session);
    viewport.keep_pace(session->view, moment);
    const double start = now();
    viewport.draw();
    glFinish();
    const double time = seconds_since(start);
    viewport.took(std::chrono::duration_cast<FramePace::Clock::duration>(std::chrono::duration<double>(time)));
    return time;
  };
  std::vector<double> times, pictures;
  double picture = 0;
  for (auto _ : state) {
    if (viewport.renderer().is_refined()) {
      pictures.push_back(picture);
      picture = 0;
    }
    if (viewport.renderer().is_refined())
      session->view.camera = orbited(session->view.camera, {3, 1}, session->view.size, session->view.camera.target);
    double time = 0;
    do time = frame();
    while (viewport.renderer().refining_effort() == 0);  // what was not drawn at all comes first
    times.push_back(time);
    picture += times.back();
    state.SetIterationTime(times.back());
  }
  state.counters["median_ms"] = 1e3 * median(times);
  std::sort(times.begin(), times.end());
  state.counters["of_20_19_below_ms"] = 1e3 * times[times.size() * 19 / 20];
  state.counters["most_ms"] = 1e3 * times.back();
  state.counters["picture_ms"] = 1e3 * (pictures.size() < 2 ? picture : pictures.back());  // or what there is of one
}

BENCHMARK_CAPTURE(smooth_frame, bunny, bunny)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(40);
BENCHMARK_CAPTURE(smooth_frame, dragon, dragon)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(20);
BENCHMARK_CAPTURE(gesture_step, bunny, bunny)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(300);
BENCHMARK_CAPTURE(gesture_step, dragon, dragon)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(300);
BENCHMARK_CAPTURE(hover_verdict, bunny, bunny)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(hover_verdict, dragon, dragon)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(edit_and_follow, bunny, bunny)->UseManualTime()->Unit(benchmark::kMicrosecond)->Iterations(500);
BENCHMARK_CAPTURE(edit_and_follow, dragon, dragon)->UseManualTime()->Unit(benchmark::kMicrosecond)->Iterations(500);
void register_tiles() {
  const std::pair<const char*, Source> meshes[]{{"bunny", bunny}, {"dragon", dragon}};
  const std::pair<const char*, std::vector<std::string>> states[]{
      {"plain", {}},
      {"all_verdicts", {"tool swap", "verdicts on"}},
      {"all_edges_selected", {"tool none", "mode edge", "select all"}},
      {"all_vertices_selected", {"tool none", "mode vertex", "select all"}}};
  for (const auto& [mesh, source] : meshes)
    for (const auto& [name, lines] : states)
      benchmark::RegisterBenchmark((std::string("refined_tile/") + mesh + "/" + name).c_str(), refined_tile, source,
                                   lines)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond)
          ->Iterations(300);
}

void register_edits_by_name() {
  const std::pair<const char*, Source> meshes[]{
      {"bunny", bunny}, {"dragon", dragon}, {"littered_70k", littered_70k}, {"littered_830k", littered_830k}};
  const std::pair<const char*, Part> parts[]{
      {"collapse", Part::collapse}, {"undo", Part::undo}, {"with_panels", Part::panels}, {"with_view", Part::view}};
  for (const auto& [mesh, source] : meshes)
    for (const auto& [name, part] : parts)
      benchmark::RegisterBenchmark((std::string("edit_by_name/") + mesh + "/" + name).c_str(), edit_by_name, source,
                                   part)
          ->UseManualTime()
          ->Unit(benchmark::kMicrosecond)
          ->Iterations(500);
}

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

void register_all() {
  register_tiles();
  register_edits_by_name();
}

}  // namespace ryosen::bench

int main(int argc, char** argv) {
  ryosen::bench::register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
