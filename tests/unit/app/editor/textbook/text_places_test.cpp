// What the table of the texts' places says shows each of them does so in a new window.
#include "app/editor/textbook/text_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "app/editor/commands/text/script.h"
#include "app/editor/labels/labels.h"
#include "app/editor/session/session.h"
#include "app/editor/textbook/playing.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {
namespace {

TEST(text_places, are_each_shown_by_their_lines) {
  std::set<std::string_view> names;
  std::map<std::string_view, int> rows;
  for (const TextPlace& place : text_places()) {
    ++rows[place.text];
    EXPECT_TRUE(names.insert(place.place_en).second) << place.place_en;
    EXPECT_NE(place.where_en, place.where_ja);
    EXPECT_TRUE(place.where_en.ends_with('.')) << place.where_en;
    Session session(std::make_unique<Document>());
    bool plays = false;
    for (const ScriptLine& line : split_script(place.lines)) {
      const Outcome outcome = session.run(line.text);
      EXPECT_TRUE(outcome.done()) << line.text << ": " << outcome.sentence.en;
      plays |= line.text.starts_with("steps ");
    }
    ASSERT_EQ(session.shown.player() != nullptr, plays) << place.lines;
    if (plays) {
      EXPECT_GT(session.shown.player()->size(), 0u);
    }
    EXPECT_TRUE(place.lines.empty() || plays || session.mesh().live().faces > 0) << place.lines;
  }
  EXPECT_EQ(rows.size(), 4u);
  EXPECT_TRUE(std::is_sorted(text_places().begin(), text_places().end(),
                             [](const TextPlace& a, const TextPlace& b) { return a.text < b.text; }));
}

// What an entry's lines show in a new window.
std::unique_ptr<Session> shown(const TextPlace& place) {
  auto session = std::make_unique<Session>(std::make_unique<Document>());
  session->place_view({1280, 720}, {0, 0});
  for (const ScriptLine& line : split_script(place.lines)) EXPECT_TRUE(session->run(line.text).done()) << line.text;
  return session;
}

// Twice the area that a face has in the picture, whose y runs down: above 0 where it runs counter-clockwise there.
double area_seen(const Session& session, Face f) {
  const Mesh& mesh = session.mesh();
  double area = 0;
  for (const Halfedge h : loop(mesh, mesh.halfedge(f))) {
    const glm::dvec2 a = project(session.view.camera, session.view.size, mesh.position(mesh.from(h)))->pixel,
                     b = project(session.view.camera, session.view.size, mesh.position(mesh.to(h)))->pixel;
    area += a.y * b.x - a.x * b.y;
  }
  return area;
}

std::vector<Face> faces_of(const Mesh& mesh, Element element) {
  if (element.kind == Element::Kind::face) return {element.face()};
  if (element.kind == Element::Kind::halfedge) return {mesh.face(element.halfedge())};
  return {mesh.face(halfedge(element.edge(), 0)), mesh.face(halfedge(element.edge(), 1))};
}

// An element on the far side has its labels hidden, and what is said of it is nowhere to be seen.
TEST(text_places, select_what_faces_the_viewer_with_all_its_labels) {
  std::size_t selections = 0, labels = 0;
  for (const TextPlace& place : text_places()) {
    if (place.lines.find("; select ") == std::string_view::npos) continue;
    const std::unique_ptr<Session> session = shown(place);
    ASSERT_FALSE(session->selecting.selection.empty()) << place.lines;
    ++selections;
    // Text 003 runs its faces clockwise, so that they are seen from behind.
    const double turn = place.text == "003" ? -1 : 1;
    for (const Face f : faces_of(session->mesh(), session->selecting.selection.back())) {
      ASSERT_TRUE(f) << place.lines;
      EXPECT_GT(turn * area_seen(*session, f), 0.02 * session->view.size.width * session->view.size.height)
          << place.lines;
    }
    const Element element = session->selecting.selection.back();
    if (element.kind == Element::Kind::halfedge && session->mesh().live().faces > 1) {
      EXPECT_TRUE(session->mesh().face(twin(element.halfedge()))) << place.lines << ": its pair is shown, too";
    }
    if (!session->view.links.is_on(session->findings(), session->selecting, session->gesturing)) continue;
    const auto size_of = [](const std::string& text) { return Size{static_cast<int>(8 * text.size()), 16}; };
    std::multiset<std::string> wanted, placed;
    for (const LinkArrow& arrow : session->view.links.of(*session))
      if (!arrow.label.en.empty()) wanted.insert(arrow.label.en);
    for (const PlacedLabel& label : placed_labels(*session, size_of, 1)) placed.insert(label.text);
    for (const std::string& text : wanted) EXPECT_TRUE(placed.contains(text)) << place.lines << ": " << text;
    labels += wanted.size();
  }
  EXPECT_GE(selections, 9u);
  EXPECT_GE(labels, 30u);
}

TEST(text_places, show_the_faces_of_text_003_clockwise_as_there_and_the_others_not) {
  std::size_t faces = 0;
  for (const TextPlace& place : text_places()) {
    const bool is_clockwise = place.text == "003" && place.lines.starts_with("figure ");
    const bool is_flat = place.lines.starts_with("figure 000-1") && !place.lines.starts_with("figure 000-11");
    if (!is_clockwise && !is_flat) continue;
    const std::unique_ptr<Session> session = shown(place);
    for (std::uint32_t i = 0; i < session->mesh().face_slots(); ++i) {
      if (!session->mesh().is_alive(Face(i))) continue;
      EXPECT_LT((is_clockwise ? 1 : -1) * area_seen(*session, Face(i)), 0) << place.lines << " f" << i;
      ++faces;
    }
  }
  EXPECT_GT(faces, 70u);
}

// "Five edges, but six halfedges": three in each face, none outside of them.
TEST(text_places, draw_the_six_halfedges_that_text_003_counts) {
  const auto place = std::find_if(text_places().begin(), text_places().end(), [](const TextPlace& one) {
    return one.place_en.find("image23") != std::string_view::npos;
  });
  ASSERT_NE(place, text_places().end());
  const std::unique_ptr<Session> session = shown(*place);
  EXPECT_EQ(session->mesh().live().edges, 5u);
  std::map<std::uint32_t, int> by_face;
  int with_opposite = 0;
  for (const LinkArrow& arrow : session->view.links.of(*session)) {
    ASSERT_TRUE(session->mesh().face(arrow.halfedge));
    ++by_face[session->mesh().face(arrow.halfedge).index];
    with_opposite += !arrow.is_boundary;
  }
  EXPECT_EQ(by_face, (std::map<std::uint32_t, int>{{0, 3}, {1, 3}}));
  EXPECT_EQ(with_opposite, 2) << "the blue and the red one";
}

// Memory is spoken of in text 002, section 2.3; text 000 has no such section.
TEST(text_places, cite_sections_by_the_text_that_has_them) {
  for (const TextPlace& place : text_places()) {
    const auto names = [&](const char* section) { return place.place_en.find(section) != std::string_view::npos; };
    EXPECT_TRUE(place.text == "002" || !(names("2.1") || names("2.2") || names("2.3"))) << place.place_en;
    EXPECT_TRUE(place.text == "004" || !names("15.")) << place.place_en;
  }
}

}  // namespace
}  // namespace ryosen
