// Links as arrows: they lie inside their faces, twins side by side; each is labelled, selected by a click, and walked
// along.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "app/editor/labels/labels.h"
#include "app/editor/session/session.h"
#include "app/ui/overlays.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class LinksTest : public testing::Test {
 protected:
  void open(const std::string& name, std::initializer_list<const char*> lines) {
    session_.set_document(Document::open(test::asset(name)).value());
    session_.view.size = {900, 700};
    session_.framing.frame_all();
    for (const char* const line : lines) ASSERT_TRUE(session_.run(line).done()) << line;
  }
  const std::vector<LinkArrow>& arrows() { return session_.view.links.of(session_); }
  glm::dvec2 pixel_of(const LinkArrow& arrow) {
    return session_.view.origin +
           project(session_.view.camera, session_.view.size, 0.5 * (arrow.from + arrow.to))->pixel;
  }
  const LinkArrow* find(LinkRole role, Halfedge h = {}) {
    for (const LinkArrow& arrow : arrows())
      if (arrow.role == role && (!h || arrow.halfedge == h)) return &arrow;
    return nullptr;
  }
  std::vector<PlacedLabel> placed() {
    const auto size_of = [](const std::string& text) { return Size{static_cast<int>(8 * text.size()), 16}; };
    return placed_labels(session_, size_of, 1);
  }
  void expect_no_overlap() {
    const std::vector<PlacedLabel> labels = placed();
    for (std::size_t i = 0; i < labels.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto rect = [&](std::size_t k) {
          const PlacedLabel& l = labels[k];
          return PixelRect{l.corner.x, l.corner.y, l.corner.x + l.size.width, l.corner.y + l.size.height};
        };
        EXPECT_TRUE(intersection(rect(i), rect(j)).empty()) << labels[i].text << ' ' << labels[j].text;
      }
  }

  Session session_{std::make_unique<Document>()};
};

// Signed areas in the plane of the picture; the meshes here are flat and seen from the front.
double side(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

TEST_F(LinksTest, lie_inside_their_faces_and_beside_their_twins) {
  for (const char* const name :
       {"two_quads.obj", "figures/003-image41.obj", "figures/000-14.obj", "figures/002-1.obj"}) {
    open(name, {"view front", "links all"});
    const Mesh& m = session_.mesh();
    ASSERT_EQ(arrows().size(), 2 * m.live().edges) << name;
    const double turn = std::string_view(name).starts_with("figures/003") ? -1 : 1;  // these run clockwise
    for (const LinkArrow& arrow : arrows()) {
      const Halfedge h = arrow.halfedge;
      const glm::dvec3 &p = m.position(m.from(h)), &q = m.position(m.to(h));
      EXPECT_GT(glm::dot(q - p, arrow.to - arrow.from), 0.1 * glm::dot(q - p, q - p)) << "along its edge";
      EXPECT_NEAR(glm::length(glm::cross(q - p, arrow.to - arrow.from)), 0, 1e-12) << "and parallel to it";
      for (const glm::dvec3& end : {arrow.from, arrow.to}) {
        EXPECT_GT(turn * side(p, q, end), 0) << name << " h" << h.index << ": on its own side";
        if (!m.face(h)) continue;
        for (const Halfedge k : loop(m, h))
          EXPECT_GT(turn * side(m.position(m.from(k)), m.position(m.to(k)), end), 0) << name << " h" << h.index;
      }
    }
  }
}

// A halfedge outside of the faces is this program's; the texts' structures have one side alone at a boundary.
TEST_F(LinksTest, of_faces_alone_leave_out_what_runs_outside) {
  for (const char* const name : {"figures/003-image22.obj", "two_quads.obj", "fan.obj", "figures/000-3.obj"}) {
    open(name, {"view front", "links faces"});
    const Mesh& m = session_.mesh();
    std::size_t sides = 0;
    for (std::uint32_t h = 0; h < m.halfedge_slots(); ++h) sides += !m.is_outside(Halfedge(h));
    EXPECT_EQ(arrows().size(), sides) << name;
    for (const LinkArrow& arrow : arrows()) EXPECT_FALSE(m.is_outside(arrow.halfedge)) << name;
  }
}

TEST_F(LinksTest, are_each_selected_by_a_click) {
  for (const char* const name : {"fan.obj", "figures/003-image41.obj", "two_quads.obj"}) {
    open(name, {"view front", "links all"});
    const std::vector<LinkArrow> all = arrows();
    ASSERT_EQ(all.size(), 2 * session_.mesh().live().edges);
    for (const LinkArrow& arrow : all) {
      ASSERT_TRUE(session_.pointing.click(pixel_of(arrow), "").done());
      EXPECT_EQ(session_.selecting.selection, (std::vector<Element>{arrow.halfedge}))
          << name << " h" << arrow.halfedge.index;
    }
  }
  // Those of a solid that face away are hidden, and so not clicked; all others are.
  open("figures/000-4b.obj", {"view iso", "links all"});
  std::size_t seen = 0;
  const std::vector<LinkArrow> all = arrows();
  for (const LinkArrow& arrow : all) {
    const glm::dvec3 middle = 0.5 * (arrow.from + arrow.to);
    const ScreenPoint at = *project(session_.view.camera, session_.view.size, middle);
    const bool is_seen = session_.findings().picker().is_seen(session_.mesh(), session_.view.camera, session_.view.size,
                                                              at, middle, arrow.on);
    session_.selecting.selection.clear();
    session_.pointing.click(pixel_of(arrow), "");
    EXPECT_EQ(session_.selecting.selection == std::vector<Element>{arrow.halfedge}, is_seen)
        << "h" << arrow.halfedge.index;
    seen += is_seen ? 1 : 0;
  }
  EXPECT_GE(seen, 12u + 4u);
  EXPECT_LT(seen, all.size());
}

// What the pointer shows is what the click selects, whatever the mode; and only what is drawn.
TEST_F(LinksTest, are_pointed_at_as_they_are_clicked) {
  for (const char* const mode : {"mode vertex", "mode edge", "mode face", "mode halfedge"}) {
    open("fan.obj", {"view front", "links all", "tool none", mode});
    for (const LinkArrow& arrow : std::vector<LinkArrow>(arrows())) {
      session_.pointing.point_at(pixel_of(arrow));
      ASSERT_TRUE(session_.selecting.hover());
      EXPECT_EQ(session_.selecting.hover()->picked.element, Element(arrow.halfedge)) << mode;
    }
    ASSERT_TRUE(session_.run("tool split").done());
    session_.pointing.point_at(pixel_of(arrows()[0]));
    EXPECT_TRUE(!session_.selecting.hover() || session_.selecting.hover()->picked.element.kind == Element::Kind::edge)
        << "a tool takes its own";
  }
}

TEST_F(LinksTest, are_not_clicked_where_they_are_cut_off) {
  open("cube.obj", {"view iso", "links all", "xray on", "clip x"});
  const ClipPlane plane = *session_.view.clip_plane();
  std::size_t cut = 0, seen = 0;
  for (const LinkArrow& arrow : std::vector<LinkArrow>(arrows())) {
    const LinkArrow* const at = session_.view.links.at(session_, pixel_of(arrow) - session_.view.origin);
    const bool is_cut = plane.cuts(arrow.from) && plane.cuts(arrow.to);
    EXPECT_FALSE(is_cut && at && at->halfedge == arrow.halfedge) << "h" << arrow.halfedge.index;
    EXPECT_FALSE(at && plane.cuts(at->from) && plane.cuts(at->to));
    (is_cut ? cut : seen) += 1;
  }
  EXPECT_GT(cut, 4u);
  EXPECT_GT(seen, 4u);
}

TEST_F(LinksTest, are_reached_from_twice_as_far_where_all_is_twice_as_large) {
  open("fan.obj", {"view front", "links all"});
  const auto outside = std::find_if(arrows().begin(), arrows().end(), [](const LinkArrow& a) { return !a.on; });
  ASSERT_NE(outside, arrows().end());
  const glm::dvec2 inside = pixel_of(*outside) - session_.view.origin, middle(450, 350),
                   way = (inside - middle) / glm::length(inside - middle);
  const auto reach = [&] {
    double away = 0;
    while (away < 40 && session_.view.links.at(session_, inside + away * way)) away += 0.25;
    return away;
  };
  const double once = reach();
  session_.preferences.display_scale = 2;
  EXPECT_GT(reach(), 1.5 * once);
}

TEST_F(LinksTest, of_a_halfedge_are_its_links) {
  open("fan.obj", {"view front", "mode halfedge", "select 0-1"});
  const Halfedge h = find_edge(session_.mesh(), "0-1").element;
  session_.selecting.selection = {h};
  const Mesh& m = session_.mesh();
  for (const auto& [role, to] : {std::pair{LinkRole::itself, h},
                                 {LinkRole::next, m.next(h)},
                                 {LinkRole::prev, m.prev(h)},
                                 {LinkRole::twin, twin(h)}}) {
    ASSERT_NE(find(role), nullptr);
    EXPECT_EQ(find(role)->halfedge, to);
    EXPECT_TRUE(find(role)->label.en.ends_with(" " + name_of(m, to))) << find(role)->label.en;
    EXPECT_NE(find(role)->label.ja, find(role)->label.en);
  }
  EXPECT_EQ(find(LinkRole::vertex)->from, m.position(m.from(h)));
  EXPECT_EQ(find(LinkRole::face)->on, m.face(h));
  std::set<std::string> texts;
  for (const PlacedLabel& label : placed()) texts.insert(label.text);
  EXPECT_GE(texts.size(), 5u);
  expect_no_overlap();
  // In another mode they are not drawn, unless they are asked for.
  ASSERT_TRUE(session_.run("mode edge").done());
  EXPECT_TRUE(arrows().empty());
  ASSERT_TRUE(session_.run("links selection").done());
  EXPECT_FALSE(arrows().empty());
  ASSERT_TRUE(session_.run("links off").done());
  EXPECT_TRUE(arrows().empty());
}

TEST_F(LinksTest, of_edges_vertices_and_faces_are_what_they_store) {
  open("figures/000-4b.obj", {"view iso", "links selection"});
  const Mesh& m = session_.mesh();
  const auto count = [&](LinkRole role) {
    return std::count_if(arrows().begin(), arrows().end(), [&](const LinkArrow& a) { return a.role == role; });
  };
  session_.selecting.selection = {edge(m.halfedge(Face(1)))};
  EXPECT_EQ(count(LinkRole::vertex), 2);
  EXPECT_EQ(count(LinkRole::face), 2);
  EXPECT_EQ(count(LinkRole::wing), 4);
  session_.selecting.selection = {Vertex(5)};
  EXPECT_EQ(count(LinkRole::itself), 1);
  EXPECT_EQ(find(LinkRole::itself)->halfedge, m.halfedge(Vertex(5)));
  EXPECT_EQ(count(LinkRole::around), 2) << "the cycle, of three";
  session_.selecting.selection = {Face(8)};
  EXPECT_EQ(find(LinkRole::itself)->halfedge, m.halfedge(Face(8)));
  EXPECT_EQ(count(LinkRole::around), 3);
  EXPECT_EQ(count(LinkRole::ring), 4);
  const LinkArrow* const normal = find(LinkRole::normal);
  ASSERT_NE(normal, nullptr);
  EXPECT_LT((normal->to - normal->from).z, 0) << "the bottom looks down";
}

// As the inspector and commands do; behind what the link is nothing else can be meant.
TEST_F(LinksTest, name_halfedges_and_edges_by_their_points) {
  open("cube.obj", {"mode halfedge"});
  const Mesh& m = session_.mesh();
  const Halfedge h = m.halfedge(Face(0));
  session_.selecting.selection = {h};
  const auto label = [&](LinkRole role) { return find(role)->label; };
  EXPECT_EQ(label(LinkRole::itself).en, "halfedge " + name_of(m, h));
  EXPECT_EQ(label(LinkRole::next).en, "next " + name_of(m, m.next(h)));
  EXPECT_EQ(label(LinkRole::twin).ja, "対 " + name_of(m, twin(h)));
  EXPECT_EQ(label(LinkRole::face).en, "face f0");
  session_.selecting.selection = {edge(h)};
  const LinkArrow* const wing = find(LinkRole::wing);
  ASSERT_NE(wing, nullptr);
  EXPECT_EQ(wing->label.en, "left next " + name_of(m, edge(wing->halfedge)));
}

TEST_F(LinksTest, are_walked_and_the_trail_stays) {
  open("fan.obj", {"view front", "mode halfedge"});
  session_.selecting.selection = {find_edge(session_.mesh(), "0-1").element};
  std::vector<Halfedge> expected{session_.selecting.selection[0].halfedge()};
  for (const char* const step : {"next", "next", "twin", "around"}) {
    ASSERT_TRUE(session_.run(std::string("walk ") + step).done());
    expected.push_back(session_.selecting.selection[0].halfedge());
  }
  EXPECT_EQ(session_.view.links.trail(), expected);
  EXPECT_NE(find(LinkRole::trail), nullptr);
  session_.selecting.selection = {twin(expected[0])};
  EXPECT_EQ(find(LinkRole::trail), nullptr) << "elsewhere it is not shown";
  ASSERT_TRUE(session_.run("walk next").done());
  EXPECT_EQ(session_.view.links.trail().size(), 2u) << "and begins anew";
}

TEST_F(LinksTest, the_trail_ends_with_its_mesh) {
  open("cube.obj", {"mode halfedge", "select h18", "walk next", "walk twin"});
  const Element end = session_.selecting.selection[0];
  open("two_quads.obj", {"mode halfedge"});
  EXPECT_TRUE(session_.view.links.trail().empty());
  if (end.index < session_.mesh().halfedge_slots()) {
    session_.selecting.selection = {end};
    EXPECT_EQ(find(LinkRole::trail), nullptr);
  }
  // What a step shows may have fewer halfedges than the trail.
  open("cube.obj", {"mode halfedge", "select h22", "walk next", "walk twin", "steps script triangle", "steps at 3"});
  session_.selecting.selection = {session_.view.links.trail().back()};
  arrows();
  SUCCEED();
}

// Only what changes makes them anew: also while something is hidden.
TEST_F(LinksTest, are_kept_while_something_is_hidden) {
  open("torus.off", {"links all", "hide f3"});
  const LinkArrow* const first = arrows().data();
  const std::size_t count = arrows().size();
  const_cast<LinkArrow*>(first)->label = {"kept", "kept"};
  EXPECT_EQ(arrows()[0].label.en, "kept");
  ASSERT_TRUE(session_.run("hide f4").done());
  EXPECT_NE(arrows()[0].label.en, "kept");
  EXPECT_NE(arrows().size(), count);
  ASSERT_TRUE(session_.run("unhide").done());
  EXPECT_GT(arrows().size(), count);
}

TEST_F(LinksTest, are_at_most_two_thousand_and_follow_edits) {
  open("stanford_bunny.obj", {"links all"});
  const std::size_t whole = arrows().size();
  EXPECT_LT(whole, 200u) << "from afar its edges are too short to tell";
  ASSERT_TRUE(session_.run("select f1000").done());
  ASSERT_TRUE(session_.run("frame selected").done());
  session_.selecting.selection.clear();
  EXPECT_LE(arrows().size(), DrawnLinks::most);
  open("torus.off", {"links all"});
  const std::size_t before = arrows().size();
  EXPECT_GT(before, 100u);
  ASSERT_TRUE(session_.run("split 0-1").done());
  EXPECT_NE(arrows().size(), before);
  ASSERT_TRUE(session_.run("hide f3").done());
  for (const LinkArrow& arrow : arrows()) EXPECT_NE(arrow.on, Face(3));
}

TEST_F(LinksTest, and_all_numbers_overlap_nowhere) {
  for (const char* const name : {"fan.obj", "figures/003-image43.obj", "figures/000-4b.obj"})
    for (const char* const numbers : {"numbers all", "numbers corners"}) {
      open(name, {"view iso", "links all", numbers, "select f1"});
      expect_no_overlap();
      EXPECT_GT(placed().size(), 10u) << name << numbers;
    }
}

// Also around a hole, where the middle of the face lies on the other side of the edge.
TEST_F(LinksTest, are_nearest_to_their_own_numbers) {
  open("figures/000-4b.obj", {"view front", "links all", "numbers halfedges"});
  int of_rings = 0;
  for (const PlacedLabel& label : placed()) {
    const glm::dvec2 middle =
        session_.view.origin + glm::dvec2(label.corner) + 0.5 * glm::dvec2(label.size.width, label.size.height);
    const Halfedge h(static_cast<std::uint32_t>(std::stoul(label.text.substr(1))));
    const Face f = session_.mesh().face(h);
    if (!f || !session_.mesh().has_rings(f)) continue;
    const auto& all = arrows();
    const auto nearest = std::min_element(all.begin(), all.end(), [&](const LinkArrow& a, const LinkArrow& b) {
      return glm::distance(pixel_of(a), middle) < glm::distance(pixel_of(b), middle);
    });
    EXPECT_EQ(nearest->halfedge, h) << label.text;
    const auto sides = loop(session_.mesh(), session_.mesh().halfedge(f));
    of_rings += std::find(sides.begin(), sides.end(), h) == sides.end();
  }
  EXPECT_EQ(of_rings, 4) << "all of the ring in front";
}

TEST_F(LinksTest, tell_the_face_of_every_halfedge_that_is_selected) {
  for (const char* const name : {"fan.obj", "figures/003-image41.obj", "two_quads.obj", "figures/000-3.obj"}) {
    open(name, {"view front", "links all", "numbers all"});
    const Mesh& m = session_.mesh();
    std::size_t told = 0, all = 0;
    for (std::uint32_t i = 0; i < m.halfedge_slots(); ++i) {
      const Halfedge h(i);
      const bool is_seen =
          std::any_of(arrows().begin(), arrows().end(), [&](const LinkArrow& a) { return a.halfedge == h; });
      if (!m.face(h) || !is_seen) continue;
      session_.selecting.selection = {h};
      const std::vector<PlacedLabel> labels = placed();
      const std::string wanted = "face f" + std::to_string(m.face(h).index);
      told += std::any_of(labels.begin(), labels.end(), [&](const PlacedLabel& label) { return label.text == wanted; });
      ++all;
      expect_no_overlap();
    }
    EXPECT_GT(all, 2u) << name;
    if (std::string_view(name) != "figures/000-3.obj") {
      EXPECT_EQ(told, all) << name;  // of the tetrahedron some faces are behind
    }
  }
}

TEST_F(LinksTest, numbers_of_corners_are_3i_plus_j_in_two_colours) {
  open("figures/003-image43.obj", {"view front", "numbers corners", "links off"});
  std::map<std::string, std::uint32_t> ground;
  for (const PlacedLabel& label : placed()) ground[label.text] = label.ground.value_or(0);
  ASSERT_EQ(ground.size(), 30u);
  EXPECT_NE(ground.at("24"), ground.at("1")) << "24 has become a boundary, 1 is inside";
  EXPECT_EQ(ground.at("1"), ground.at("3"));
}

}  // namespace
}  // namespace ryosen
