// Labels in the picture of a session: where they are, what they leave out, and that they go as they came.
#include <gtest/gtest.h>

#include <set>

#include "app/editor/labels/labels.h"
#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class LabelsTest : public testing::Test {
 protected:
  void open(const char* name, Headless::Options options = {.backend = Backend::osmesa, .size = {480, 360}}) {
    session_.set_document(Document::open(test::asset(name)).value());
    headless_.reset();  // one context at a time
    headless_ = Headless::make(options).value();
    headless_->place_view(session_);
  }
  Image picture(const std::string& line) {
    EXPECT_TRUE(session_.run(line).done()) << line;
    return headless_->picture(session_);
  }
  std::vector<PlacedLabel> placed(double scale = 1) {
    const auto size_of = [&](const std::string& text) {
      return Size{static_cast<int>(8 * scale * double(text.size())), static_cast<int>(14 * scale)};
    };
    return placed_labels(session_, size_of, scale);
  }
  std::set<std::string> texts() {
    std::set<std::string> all;
    for (const PlacedLabel& label : placed()) all.insert(label.text);
    return all;
  }

  Session session_{std::make_unique<Document>()};
  std::unique_ptr<Headless> headless_;
};

PixelRect rect_of(const PlacedLabel& label) {
  return {label.corner.x, label.corner.y, label.corner.x + label.size.width, label.corner.y + label.size.height};
}

// A cube shows three faces, 7 corners and 9 edges; X-ray shows all.
TEST_F(LabelsTest, number_what_is_seen) {
  open("cube.obj");
  for (const char* line : {"view iso", "numbers faces"}) ASSERT_TRUE(session_.run(line).done());
  EXPECT_EQ(texts().size(), 3u);
  ASSERT_TRUE(session_.run("numbers vertices").done());
  EXPECT_EQ(texts().size(), 7u);
  ASSERT_TRUE(session_.run("numbers edges").done());
  EXPECT_EQ(texts().size(), 9u);
  ASSERT_TRUE(session_.run("numbers halfedges").done());
  EXPECT_EQ(texts().size(), 12u) << "those of the three faces";
  ASSERT_TRUE(session_.run("xray on").done());
  ASSERT_TRUE(session_.run("view front").done());
  ASSERT_TRUE(session_.run("numbers faces").done());
  EXPECT_GT(texts().size(), 3u);
  ASSERT_TRUE(session_.run("numbers off").done());
  EXPECT_TRUE(texts().empty());
}

TEST_F(LabelsTest, number_no_hidden_element) {
  open("cube.obj");
  for (const char* line : {"view iso", "numbers faces"}) ASSERT_TRUE(session_.run(line).done());
  const std::set<std::string> before = texts();
  ASSERT_TRUE(session_.run("hide " + *before.begin()).done());
  EXPECT_FALSE(texts().contains(*before.begin()));
}

// Of a dense mesh those that have room, the selected one among them, in the order of the same session each time.
TEST_F(LabelsTest, do_not_overlap_and_give_way_to_what_is_selected) {
  open("stanford_bunny.obj");
  ASSERT_TRUE(session_.run("numbers faces").done());
  for (const double scale : {1.0, 2.0}) {
    const std::vector<PlacedLabel> all = placed(scale);
    EXPECT_EQ(placed(scale), all);
    EXPECT_GT(all.size(), 10u);
    EXPECT_LE(all.size(), most_labels);
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(intersection(rect_of(all[i]), PixelRect::all(session_.view.size)), rect_of(all[i]));
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(rect_of(all[i]), rect_of(all[k])));
    }
  }
  const std::set<std::string> shown = texts();
  const auto seen = session_.pointing.pick({240, 180}, PickMode::face);
  ASSERT_TRUE(seen);
  const std::string name = "f" + std::to_string(seen->element.index);
  ASSERT_TRUE(session_.run("select " + name).done());
  EXPECT_TRUE(texts().contains(name));
}

// In a menu of their own within the View menu, which has to have room in a window of 720 pixels.
TEST_F(LabelsTest, are_in_a_menu_of_the_view_menu) {
  test::Laid laid("cube.obj");
  laid.open_menu("View");
  const glm::dvec2 entry = test::DrawnText(laid.gui).place("Numbers");
  laid.click(entry);
  laid.frames(3);
  const glm::dvec2 faces = test::DrawnText(laid.gui).place("Numbers of faces");
  EXPECT_GT(faces.x, entry.x);
  laid.click(faces);
  EXPECT_EQ(laid.session.view.settings.numbers, Numbers::faces);
}

// What was asked for is told, at the nearest place where there is room.
TEST_F(LabelsTest, of_measures_move_aside_and_are_all_there) {
  open("torus.off");
  for (const char* line : {"view iso", "measure v0 v1", "measure v0", "measure f0", "measure f1", "measure v0 v2"})
    session_.run(line);
  const auto size_of = [](const std::string&) { return Size{300, 14}; };
  for (const Size view : {Size{480, 360}, Size{640, 480}}) {
    session_.view.size = view;
    session_.framing.frame_all();
    ASSERT_GE(session_.selecting.measures.size(), 4u);
    const std::vector<PlacedLabel> all = placed_labels(session_, size_of, 1);
    EXPECT_EQ(all.size(), session_.selecting.measures.size()) << view.width;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(rect_of(all[i]), rect_of(all[k])));
  }
}

TEST_F(LabelsTest, of_measures_lie_beside_the_handles_of_the_gizmo) {
  open("torus.off");
  for (const GizmoKind kind : {GizmoKind::move, GizmoKind::turn, GizmoKind::scale})
    for (const char* measured : {"v0 v1", "v0 v1 v2", "0-1"}) {
      for (const char* line : {"measure clear", "select v0 v1"}) ASSERT_TRUE(session_.run(line).done());
      ASSERT_TRUE(session_.run(std::string("measure ") + measured).done());
      session_.view.gizmo_kind = kind;
      const std::vector<PlacedLabel> all = placed();
      ASSERT_EQ(all.size(), 1u);
      const PixelRect rect = rect_of(all[0]);
      ASSERT_TRUE(session_.pointing.gizmo());
      for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1; ++x)
          ASSERT_EQ(session_.pointing.handle_at(session_.view.origin + glm::dvec2(x, y), {}), nullptr) << measured;
    }
}

TEST_F(LabelsTest, grow_with_the_letters_that_are_preferred) {
  open("cube.obj", {.backend = Backend::osmesa, .size = {800, 600}});
  const Image without = picture(R"(camera {"eye":[9,9,9],"target":[99,9,9]})");  // no mesh is in view
  const auto pixels_of_legend = [&] {
    const Image with = picture("colours sides");
    int changed = 0;
    for (int y = 300; y < 600; ++y)
      for (int x = 0; x < 200; ++x) changed += with.at(x, y) != without.at(x, y);
    return changed;
  };
  const int usual = pixels_of_legend();
  session_.preferences.font_size_px = 30;
  EXPECT_GT(pixels_of_legend(), 3 * usual) << "twice as high and as wide";
}

// The pixels of the labels differ from those without them, and only those.
TEST_F(LabelsTest, are_drawn_with_and_without_panels_and_leave_nothing_behind) {
  for (const bool panels : {false, true}) {
    open("cube.obj", {.backend = Backend::osmesa, .size = {800, 600}, .panels = panels});
    ASSERT_TRUE(session_.run("view iso").done());
    const Image without = headless_->picture(session_);
    const Image with = picture("numbers vertices");
    const auto size_with_room = [](const std::string&) { return Size{40, 24}; };
    std::vector<PlacedLabel> labels = placed_labels(session_, size_with_room, 1);
    EXPECT_EQ(labels.size(), 7u);
    for (const PlacedLabel& label : labels) {
      int changed = 0;
      const PixelRect rect = rect_of(label);
      const glm::ivec2 origin(session_.view.origin);
      for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1; ++x)
          changed += with.at(x + origin.x, y + origin.y) != without.at(x + origin.x, y + origin.y);
      EXPECT_GT(changed, 60) << label.text;
    }
    // The panels beside the view may say what was run.
    const Image after = picture("numbers off");
    const glm::ivec2 first(session_.view.origin);
    for (int y = first.y; y < first.y + session_.view.size.height; ++y)
      for (int x = first.x; x < first.x + session_.view.size.width; ++x) ASSERT_EQ(after.at(x, y), without.at(x, y));
  }
}

TEST_F(LabelsTest, are_redrawn_as_they_are_drawn_anew) {
  open("torus.off");
  for (const char* line : {"numbers faces", "select f3", "poke f3", "numbers vertices", "split e5", "theme light",
                           "move_vertex v7 0.1,0.2,0.3", "undo", "mode face", "hide f9", "numbers edges", "xray on",
                           "unhide", "xray off", "view top", "numbers off"}) {
    const Image now = picture(line);
    headless_->forget();
    EXPECT_TRUE(headless_->picture(session_) == now) << line;
  }
}

// Finer sampling of the mesh leaves the letters as they are.
TEST_F(LabelsTest, are_as_sharp_with_supersampling) {
  open("cube.obj", {.backend = Backend::osmesa, .size = {480, 360}, .transparent = true});
  for (const char* line : {"view iso", "numbers vertices"}) ASSERT_TRUE(session_.run(line).done());
  const Image plain = headless_->picture(session_);
  headless_.reset();
  headless_ =
      Headless::make({.backend = Backend::osmesa, .size = {480, 360}, .transparent = true, .supersample = 2}).value();
  const Image fine = headless_->picture(session_);
  int letters = 0;
  for (int y = 0; y < 360; ++y)
    for (int x = 0; x < 480; ++x) {
      if (plain.at(x, y) != Rgba{0xF2, 0xF4, 0xF7, 255}) continue;
      ++letters;
      EXPECT_EQ(fine.at(x, y), plain.at(x, y));
    }
  EXPECT_GT(letters, 8);
}

// In every picture, with or without panels.
TEST_F(LabelsTest, tell_what_the_colours_mean) {
  open("torus.off");
  const Image bare = picture("colours off");
  const Image coloured = picture("colours smallest_angle");
  EXPECT_TRUE(texts().contains("Smallest angle"));
  int swatches = 0;
  for (const PlacedLabel& label : placed()) {
    if (!label.ground) continue;
    ++swatches;
    const glm::ivec2 in = label.corner + glm::ivec2(label.size.width - 3, label.size.height / 2);
    EXPECT_EQ(coloured.at(in.x, in.y), rgb(*label.ground)) << label.text;
  }
  EXPECT_EQ(swatches, 7);
  ASSERT_TRUE(session_.run("language ja").done());
  EXPECT_TRUE(texts().contains("最小の角"));
  const Image japanese = headless_->picture(session_);
  EXPECT_FALSE(japanese == coloured);
  EXPECT_TRUE(japanese == headless_->view_drawn_again());
  ASSERT_TRUE(session_.run("language en").done());
  EXPECT_TRUE(picture("colours off") == bare);
}

TEST_F(LabelsTest, tell_what_was_measured) {
  open("cube.obj");
  picture("measure v0 v1");
  EXPECT_TRUE(texts().contains("distance 1"));
  picture("measure f0");
  EXPECT_TRUE(texts().contains("area 1, perimeter 4"));
  picture("move_vertex v0 -1,0,0");
  EXPECT_FALSE(texts().contains("distance 1"));
  picture("measure clear");
  EXPECT_TRUE(texts().empty());
}

// A file without faces is not shown as nothing without a word.
TEST_F(LabelsTest, say_what_a_file_without_faces_has) {
  const test::TemporaryFolder folder;
  struct Case {
    const char *name, *text, *en, *more;
  };
  for (const Case& c :
       {Case{"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "The mesh has 3 vertices and no faces.", ""},
        {"curves.obj", "v 0 0 0\nv 1 0 0\ncurv 0 1 1 2\n", "The mesh has 2 vertices and no faces.", "curves.obj:3: "},
        {"one.xyz", "1 2 3 4\n", "The mesh has one vertex and no faces.", "one.xyz:1:"},
        {"none.off", "OFF\n0 0 0\n", "The mesh is empty.", ""},
        {"edges.ply",
         "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
         "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n0 0 0\n1 0 0\n0 1\n",
         "The mesh has 2 vertices and no faces.", ""}}) {
    session_.set_document(Document::open(folder.write(c.name, c.text)).value());
    session_.place_view({900, 360}, {0, 0});
    std::string all;
    for (const PlacedLabel& label : placed()) all += label.text;
    EXPECT_TRUE(all.starts_with(c.en)) << c.name << all;
    EXPECT_EQ(all.size() > std::string_view(c.en).size(), *c.more != '\0') << all;
    EXPECT_NE(all.find(c.more), std::string::npos) << c.name << all;
  }
  session_.set_document(Document::open(test::asset("cube.obj")).value());
  EXPECT_TRUE(placed().empty());
  session_.set_document(std::make_unique<Document>());
  EXPECT_TRUE(placed().empty()) << "nothing was opened";
}

TEST_F(LabelsTest, say_it_in_the_picture) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("points.ply",
                                        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                                        "property float y\nproperty float z\nend_header\n0 0 0\n");
  for (const bool panels : {false, true}) {
    headless_.reset();
    headless_ = Headless::make({.backend = Backend::osmesa, .size = {900, 500}, .panels = panels}).value();
    session_.set_document(Document::open(file).value());
    headless_->place_view(session_);
    const Image with = headless_->picture(session_);
    session_.frontend.awaits_file = true;  // then nothing is said
    EXPECT_FALSE(headless_->picture(session_) == with) << panels;
    session_.frontend.awaits_file = false;
  }
}

}  // namespace
}  // namespace ryosen
