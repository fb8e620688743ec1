#include "tests/support/app/window_hand.h"

#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen::test {

namespace {

constexpr Size hand_window{1280, 800};  // that of RealWindow

}  // namespace

void WindowHand::open_copy(const std::string& name) {
  file_ = folder_.copy(asset(name), name);
  open_file();
}

void WindowHand::open_made(std::vector<std::string> words) {
  file_ = folder_.at("made.obj");
  words.insert(words.end(), {"-o", file_});
  ASSERT_EQ(run_program(words).exit_code, 0);
  open_file();
}

void WindowHand::open_file() {
  open(file_);
  laid_ = std::make_unique<Laid>("cube.obj", hand_window);
  session().frontend.turns_to_solids = session().view.shows_axes = true;
  ASSERT_TRUE(session().run("open " + file_argument(file_)).done());
  laid_->gui.place_view(session(), hand_window);
  session().framing.frame_all();
}

Camera WindowHand::camera() const {
  Camera seen = laid_->session.view.camera;
  const Frame frame = last();
  seen.eye = frame.eye;
  seen.target = frame.target;
  return seen;
}

void WindowHand::click(glm::dvec2 pixel, const std::string& keys, int button) const {
  xdotool("mousemove " + words_of(pixel) + " " + while_held(keys, "click " + std::to_string(button)));
}

glm::dvec2 WindowHand::pixel_of(const glm::dvec3& place, const Camera& camera) const {
  const auto at = project(camera, laid_->session.view.size, place);
  return at ? glm::round(at->pixel + laid_->session.view.origin) : glm::dvec2(-1e9);
}

WindowHand::OnEdge WindowHand::on_edge(double share, int which) {
  const Mesh& m = session().mesh();
  for (std::uint32_t i = 0; i < m.edge_slots(); ++i) {
    const auto [a, b] = ends(m, Edge(i));
    const glm::dvec3 from = m.position(a), to = m.position(b);
    if (glm::distance(pixel_of(from), pixel_of(to)) < 60) continue;
    const glm::dvec2 pixel = pixel_of(from + share * (to - from));
    const auto picked = session().pointing.pick(pixel, PickMode::edge);
    if (picked && picked->element == Element(Edge(i)) && which-- == 0) return {pixel, Edge(i), from, to};
  }
  ADD_FAILURE() << "no such edge is seen";
  return {};
}

WindowHand::OnFace WindowHand::on_a_face(int which) {
  const Mesh& m = session().mesh();
  for (std::uint32_t i = 0; i < m.face_slots(); ++i) {
    glm::dvec3 middle(0);
    for (const Vertex v : vertices_around(m, Face(i))) middle += m.position(v) / double(corner_count(m, Face(i)));
    const glm::dvec2 pixel = pixel_of(middle);
    const auto picked = session().pointing.pick(pixel, PickMode::face);
    if (picked && picked->element == Element(Face(i)) && which-- == 0) return {pixel, Face(i)};
  }
  ADD_FAILURE() << "no such face is seen";
  return {};
}

WindowHand::OnVertex WindowHand::on_a_vertex(int which) {
  const Mesh& m = session().mesh();
  for (std::uint32_t i = 0; i < m.vertex_slots(); ++i) {
    const glm::dvec2 pixel = pixel_of(m.position(Vertex(i)));
    const auto picked = session().pointing.pick(pixel, PickMode::vertex);
    if (picked && picked->element == Element(Vertex(i)) && which-- == 0) return {pixel, Vertex(i)};
  }
  ADD_FAILURE() << "no such vertex is seen";
  return {};
}

std::pair<glm::dvec2, glm::dvec2> WindowHand::around_all() const {
  glm::dvec2 low(1e9), high(-1e9);
  for (const glm::dvec3& place : laid_->session.mesh().positions()) {
    low = glm::min(low, pixel_of(place));
    high = glm::max(high, pixel_of(place));
  }
  return {low - 6.0, high + 6.0};
}

Mesh WindowHand::saved() {
  std::filesystem::remove(file_);
  xdotool("key ctrl+s");
  EXPECT_TRUE(wait_for([&] { return std::filesystem::exists(file_); })) << "it was not saved";
  auto document = Document::open(file_);
  EXPECT_TRUE(document);
  return document ? document.value()->mesh() : Mesh();
}

bool WindowHand::has_point(const Mesh& m, const glm::dvec3& place, double within) {
  for (const glm::dvec3& p : m.positions())
    if (glm::distance(p, place) < within) return true;
  return false;
}

}  // namespace ryosen::test
