#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ryosen/scene/view/packed_normal.h"
#include "tests/support/core/long_run.h"
#include "tests/support/render/scene.h"

namespace ryosen {
namespace {

constexpr Size view_size{320, 240};

// The picture after drawing all of it anew.
Image full_picture(Renderer& view) {
  view.draw(PixelRect::all(view.size()));
  return view.read_pixels();
}

Rgba pixel_at(const Image& image, int x, int y) { return image.at(x, y); }

int surface_pixels(Renderer& view) {
  const IdImage ids = view.read_ids();
  int count = 0;
  for (const std::uint32_t t : ids.triangle) count += t != no_index;
  return count;
}

TEST(view, draws_the_mesh_where_it_is) {
  const Scene scene = square_scene(1);
  const auto view = front_view(scene, view_size, 4);  // the square covers 120 x 120 pixels in the middle
  EXPECT_EQ(surface_pixels(*view), 120 * 120);
  const IdImage ids = view->read_ids();
  EXPECT_EQ(ids.triangle[static_cast<std::size_t>(100 * 320 + 130)], 1u);  // above the diagonal from lower left
  EXPECT_EQ(ids.triangle[static_cast<std::size_t>(150 * 320 + 190)], 0u);
  EXPECT_NEAR(ids.depth[static_cast<std::size_t>(120 * 320 + 160)], 5.0, 1e-4);
}

TEST(view, nothing_to_draw_when_nothing_changed) {
  const auto view = front_view(square_scene(1), view_size, 4);
  EXPECT_EQ(view->draw(), PixelRect::all(view_size));
  EXPECT_TRUE(view->draw().empty());
  view->set_camera(view->camera());
  view->set_overlay(Layer::hover, {});
  EXPECT_TRUE(view->draw().empty());
}

TEST(view, back_faces_look_different) {
  Scene scene = square_scene(1);
  const auto view = front_view(scene, view_size, 4);
  view->draw();
  const Rgba front = pixel_at(view->read_pixels(), 140, 110);
  for (auto& t : scene.triangles) std::swap(t[1], t[2]);
  view->set_mesh(scene.source());
  view->draw();
  const Rgba back = pixel_at(view->read_pixels(), 140, 110);
  EXPECT_GT(int(back[0]) - int(back[2]), 40);
  EXPECT_LT(std::abs(int(front[0]) - int(front[2])), 30);
}

TEST(view, wireframe_leaves_out_diagonals_of_polygons) {
  Scene scene = square_scene(1);
  const auto lit_pixels = [&](std::uint8_t first, std::uint8_t second) {
    scene.edge_bits = {first, second};
    const auto view = front_view(scene, view_size, 4);
    view->draw();
    const Image image = view->read_pixels();
    // Pixels on the diagonal that look like the plain surface.
    const Rgba plain = pixel_at(image, 130, 100);
    int alike = 0;
    for (int i = 20; i < 100; ++i) alike += std::abs(int(pixel_at(image, 100 + i, 179 - i)[0]) - int(plain[0])) < 4;
    return alike;
  };
  EXPECT_EQ(lit_pixels(7, 7), 0);
  EXPECT_EQ(lit_pixels(3, 6), 80);  // without side 2 of the first and side 0 of the second triangle
}

TEST(view, solid_line_covers_its_length_times_its_width) {
  const auto view = front_view(square_scene(1), view_size, 4);
  Overlay overlay;
  const Rgba blue = rgb(0x56B4E9);
  overlay.lines.push_back({{-0.5, 0.1, 0}, {0.5, 0.1, 0}, blue, LineStyle::solid, 6});
  view->set_overlay(Layer::highlights, overlay);
  view->draw();
  const int pixels = count_pixels(view->read_pixels(), blue, 2);
  EXPECT_GE(pixels, 60 * 5);
  EXPECT_LE(pixels, 66 * 6);
}

TEST(view, styles_differ_in_what_they_cover) {
  const auto view = front_view(square_scene(1), view_size, 4);
  const Rgba colour = rgb(0xFF00FF);
  const auto pixels_of = [&](LineStyle style) {
    Overlay overlay;
    overlay.lines.push_back({{-0.9, 0.1, 0}, {0.9, 0.1, 0}, colour, style, 4});
    view->set_overlay(Layer::highlights, overlay);
    view->draw();
    return count_pixels(view->read_pixels(), colour, 30);
  };
  const int solid = pixels_of(LineStyle::solid), dashed = pixels_of(LineStyle::dashed);
  const int dash_dot = pixels_of(LineStyle::dash_dot), dotted = pixels_of(LineStyle::dotted);
  EXPECT_NEAR(dashed / double(solid), 2 / 3.4, 0.12);
  EXPECT_NEAR(dash_dot / double(solid), 3.8 / 6, 0.14);
  EXPECT_LT(dotted, dashed);
  EXPECT_GT(dotted, solid / 8);
}

TEST(view, lines_behind_the_surface_are_faint_or_absent) {
  const auto view = front_view(square_scene(1), view_size, 4);
  const Rgba colour = rgb(0xFF00FF);
  const auto picture_with = [&](double z, float hidden) {
    Overlay overlay;
    overlay.lines.push_back({{-0.5, 0.1, z}, {0.5, 0.1, z}, colour, LineStyle::solid, 6, hidden});
    view->set_overlay(Layer::highlights, overlay);
    view->draw();
    return view->read_pixels();
  };
  view->draw();
  const Image without = view->read_pixels();
  EXPECT_GT(count_pixels(picture_with(0, 0), colour), 250);
  EXPECT_EQ(picture_with(-0.5, 0), without);
  const Image faint = picture_with(-0.5, faintly);
  EXPECT_EQ(count_pixels(faint, colour), 0);
  EXPECT_NE(faint, without);
}

TEST(view, points_have_their_shapes) {
  const auto view = front_view(square_scene(1), view_size, 4);
  const Rgba colour = rgb(0xFF00FF);
  const auto pixels_of = [&](PointShape shape) {
    Overlay overlay;
    overlay.points.push_back({{0.2, 0.2, 0}, colour, shape, 10});
    view->set_overlay(Layer::highlights, overlay);
    view->draw();
    return count_pixels(view->read_pixels(), colour, 4);
  };
  EXPECT_NEAR(pixels_of(PointShape::disc), 314, 40);
  EXPECT_NEAR(pixels_of(PointShape::square), 256, 40);
  const int ring = pixels_of(PointShape::ring);
  EXPECT_GT(ring, 100);
  EXPECT_LT(ring, 250);
  EXPECT_GT(pixels_of(PointShape::cross), 60);
  EXPECT_GT(pixels_of(PointShape::diamond), 150);
}

constexpr DrawnTint tints[] = {{rgb(0xE69F00), {FacePattern::diagonal, 0.75f}},
                               {rgb(0xF0E442), {FacePattern::plain, 0.55f}},
                               {rgb(0xBBBBBB), {FacePattern::chessboard, 0.8f}},
                               {rgb(0xCC79A7), {FacePattern::horizontal, 0.8f}},
                               {rgb(0x4A90D9), {FacePattern::bars, 0.7f}}};

TEST(view, faces_with_a_tint_have_it_and_hidden_ones_are_absent) {
  Scene scene = square_scene(2);
  const auto view = front_view(scene, view_size, 4);
  view->set_tints(tints);
  view->draw();
  const Image plain = view->read_pixels();
  const std::uint32_t face[] = {0};
  scene.tints[0] = 2;
  view->update_mesh(scene.source(), {}, face, face);
  const PixelRect rect = view->draw();
  EXPECT_LT(rect.width() * rect.height(), 80 * 80);
  const Rgba before = plain.at(145, 170), after = view->read_pixels().at(145, 170);
  EXPECT_GT(int(after[0]) - int(after[2]), int(before[0]) - int(before[2]) + 40);  // towards yellow
  scene.tints[0] = hidden_face;
  view->update_mesh(scene.source(), {}, {}, face);  // the face's triangles are found where they are not named
  view->draw();
  EXPECT_NEAR(surface_pixels(*view), 120 * 120 - 60 * 60 / 2, 70);
  EXPECT_EQ(view->read_pixels(), full_picture(*view));
}

TEST(view, patterns_of_tints_differ_in_what_they_cover) {
  Scene scene = square_scene(1);
  scene.tints = {1, 1};
  const auto view = front_view(scene, view_size, 4);
  std::vector<Image> pictures;
  for (std::size_t pattern = 0; pattern < enum_count<FacePattern>; ++pattern) {
    const DrawnTint tint[] = {{rgb(0xFF00FF), {static_cast<FacePattern>(pattern), 0.9f}}};
    view->set_tints(tint);
    view->draw();
    for (const Image& other : pictures) EXPECT_NE(view->read_pixels(), other) << pattern;
    pictures.push_back(view->read_pixels());
  }
}

// Changes of every kind, in a random order: each partial picture must be the full one.
TEST(view, partial_redraw_equals_full_redraw) {
  Scene scene = sphere_scene(24);
  const auto view = front_view(scene, view_size, 2.4);
  Camera camera;
  camera.eye = {0.7, 0.9, 3.4};
  view->set_camera(camera);
  view->set_tints(tints);
  view->draw();
  std::mt19937 random(3);
  const auto below = [&](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
  const auto shift = [&] { return 0.1 * (double(below(1000)) / 1000 - 0.5); };
  int partial = 0;
  const int steps = test::is_long_run() ? 60 : 30;
  for (int step = 0; step < steps; ++step) {
    std::vector<std::uint32_t> vertices, triangles, faces;
    if (step % 3 == 0) {
      const std::uint32_t vertex = below(scene.positions.size());
      scene.positions[vertex] += glm::dvec3(shift(), shift(), shift());
      vertices = {vertex};
      for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
        for (const std::uint32_t corner : scene.triangles[t]) {
          if (corner == vertex) triangles.push_back(t);
        }
      }
    } else if (step % 3 == 1) {
      const std::uint32_t t = below(scene.triangles.size());
      triangles = faces = {t};
      scene.tints[t] = std::array<std::uint8_t, 7>{0, 1, 2, 3, 4, 5, hidden_face}[below(7)];
      if (step % 2 == 0) scene.triangles[below(scene.triangles.size())] = scene.triangles[t];
      if (step % 2 == 0) triangles.clear();
      if (step % 2 == 0) {
        for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) triangles.push_back(i);
      }
      if (step % 5 == 0) scene.add(below(400), below(400), below(400));
    } else {
      Overlay overlay;
      for (std::uint32_t i = 0; i < 1 + below(4); ++i) {
        const auto& t = scene.triangles[below(scene.triangles.size())];
        const auto at = [&](std::size_t k) { return scene.positions[t[k]]; };
        overlay.lines.push_back(
            {at(0), at(1), rgb(0xE69F00), static_cast<LineStyle>(below(4)), 3.5f, faintly, below(3) == 0});
        overlay.points.push_back({at(2), rgb(0x56B4E9), static_cast<PointShape>(below(5)), 6});
        overlay.ghosts.push_back({{at(0), 1.05 * at(1), at(2)}, rgb(0x009E73, 100)});
      }
      view->set_overlay(static_cast<Layer>(below(layer_count)), overlay);
    }
    view->update_mesh(scene.source(), vertices, triangles, faces);
    const PixelRect rect = view->draw();
    partial += !rect.empty() && rect != PixelRect::all(view_size);
    const Image picture = view->read_pixels();
    ASSERT_EQ(picture, full_picture(*view)) << "step " << step;
  }
  EXPECT_GT(partial, steps / 2);
}

// The picture of so many triangles that those behind nearer ones are looked for, and of the same in small rectangles,
// where they are not.
TEST(view, what_nearer_triangles_hide_is_left_out_unseen) {
  for (const bool is_perspective : {false, true}) {
    const auto view = front_view(sphere_scene(260), view_size, 2.4);
    if (is_perspective) {
      Camera camera;
      camera.eye = {0.7, 0.9, 1.8};
      view->set_camera(camera);
    }
    view->draw();
    EXPECT_GT(view->triangles_hidden(), view->triangles_drawn() / 6);
    const Image whole = view->read_pixels();
    const int side = test::is_long_run() ? 20 : 50;
    for (int y = 0; y < view_size.height; y += side)
      for (int x = 0; x < view_size.width; x += side) view->draw({x, y, x + side, y + side});
    EXPECT_EQ(view->read_pixels(), whole);
  }
}

TEST(view, a_rectangle_drawn_again_changes_nothing) {
  const auto view = front_view(sphere_scene(16), view_size, 2.4);
  view->draw();
  const Image before = view->read_pixels();
  std::mt19937 random(5);
  for (int i = 0; i < 20; ++i) {
    const int x = int(random() % 300), y = int(random() % 220);
    view->draw({x, y, x + 1 + int(random() % 60), y + 1 + int(random() % 60)});
  }
  EXPECT_EQ(view->read_pixels(), before);
}

TEST(view, appended_and_cut_off_triangles) {
  Scene scene = square_scene(8);
  const auto view = front_view(scene, view_size, 6);  // 40 pixels per unit
  view->draw();
  const int before = surface_pixels(*view);
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  scene.positions.insert(scene.positions.end(), {{1.5, -1, 0}, {2.5, -1, 0}, {2.5, 1, 0}});
  scene.add(first, first + 1, first + 2);
  view->update_mesh(scene.source(), {}, {}, {});
  view->draw();
  EXPECT_NEAR(surface_pixels(*view), before + 40 * 80 / 2, 60);
  EXPECT_EQ(view->read_pixels(), full_picture(*view));
  scene.positions.resize(first);
  scene.triangles.resize(scene.triangles.size() - 1);
  scene.faces.pop_back();
  scene.edge_bits.pop_back();
  scene.tints.pop_back();
  view->update_mesh(scene.source(), {}, {}, {});
  view->draw();
  EXPECT_EQ(surface_pixels(*view), before);
  EXPECT_EQ(view->read_pixels(), full_picture(*view));
}

TEST(view, unfit_triangles_are_left_out) {
  Scene scene = square_scene(1);
  const double nan = std::nan("");
  scene.positions.insert(scene.positions.end(), {{nan, 0, 0}, {1e300, 1e300, 0}});
  scene.add(0, 1, 4);
  scene.add(0, 1, 77);
  scene.add(2, 2, 2);
  scene.faces.back() = no_index;
  const auto view = front_view(scene, view_size, 4);
  EXPECT_EQ(view->draw(), PixelRect::all(view_size));
  EXPECT_EQ(view->read_ids().size, view_size);
}

// The greatest step from a pixel to its right or lower neighbour, in a square amid the picture.
int greatest_step(const Image& image, int reach) {
  int greatest = 0;
  const int x0 = image.size.width / 2, y0 = image.size.height / 2;
  for (int y = y0 - reach; y < y0 + reach; ++y)
    for (int x = x0 - reach; x < x0 + reach; ++x)
      for (const Rgba& other : {pixel_at(image, x + 1, y), pixel_at(image, x, y + 1)})
        for (std::size_t c = 0; c < 3; ++c)
          greatest = std::max(greatest, std::abs(int(other[c]) - int(pixel_at(image, x, y)[c])));
  return greatest;
}

// A sphere without wireframe whose corners have the normals of the sphere.
Scene smooth_sphere(int rings) {
  Scene scene = sphere_scene(rings);
  std::fill(scene.edge_bits.begin(), scene.edge_bits.end(), std::uint8_t{0});
  for (const auto& t : scene.triangles)
    scene.normals.push_back({packed_normal(scene.positions[t[0]]), packed_normal(scene.positions[t[1]]),
                             packed_normal(scene.positions[t[2]])});
  return scene;
}

TEST(view, smooth_shading_has_no_step_at_edges) {
  const auto view = front_view(smooth_sphere(16), view_size, 2.2);
  view->draw();
  const Image flat = view->read_pixels();
  view->set_settings({.shading = Shading::smooth});
  EXPECT_EQ(view->draw(), PixelRect::all(view_size)) << "all of it looks different";
  const Image smooth = view->read_pixels();
  EXPECT_GT(greatest_step(flat, 60), 12);
  EXPECT_LE(greatest_step(smooth, 60), 4);
  for (const int x : {110, 160, 210})
    EXPECT_NEAR(int(pixel_at(smooth, x, 120)[1]), int(pixel_at(flat, x, 120)[1]), 25) << "lit from where it was";
  view->set_settings({.shading = Shading::flat});
  view->draw();
  EXPECT_TRUE(view->read_pixels() == flat);
}

TEST(view, smooth_shading_follows_the_normals_of_the_triangles_that_changed) {
  Scene scene = smooth_sphere(10);
  const auto view = front_view(scene, view_size, 2.2);
  view->set_settings({.shading = Shading::smooth});
  view->draw();
  const Image before = view->read_pixels();
  std::vector<std::uint32_t> changed;
  for (std::uint32_t t = 204; t < 214; ++t) {
    for (std::uint32_t& normal : scene.normals[t]) normal = packed_normal({1, 0, 0});
    changed.push_back(t);
  }
  view->update_mesh(scene.source(), {}, changed, {});
  view->draw();
  const Image followed = view->read_pixels();
  EXPECT_FALSE(followed == before);
  EXPECT_TRUE(followed == full_picture(*view));
  view->set_mesh(scene.source());
  EXPECT_TRUE(followed == full_picture(*view));
}

TEST(view, a_layer_that_is_not_shown_costs_no_redraw_until_it_is) {
  Scene ball = sphere_scene(16);
  const auto view = front_view(ball, view_size, 2.4);
  Overlay some;
  some.points.push_back({ball.positions[7], rgb(0xE69F00), PointShape::disc, 6});
  view->set_overlay(Layer::highlights, some);
  view->draw();
  const Image with = view->read_pixels();
  view->show_layer(Layer::highlights, false);
  view->draw();
  const Image without = view->read_pixels();
  EXPECT_FALSE(with == without);
  Overlay other;
  other.points.push_back({ball.positions[3], rgb(0x56B4E9), PointShape::disc, 6});
  view->set_overlay_part(Layer::highlights, 100, other);
  EXPECT_TRUE(view->is_drawn());
  view->set_overlay_part(Layer::highlights, 100, {});
  view->show_layer(Layer::highlights, true);
  EXPECT_FALSE(view->is_drawn());
  view->draw();
  EXPECT_TRUE(view->read_pixels() == with);
}

TEST(view, empty_mesh_shows_the_background) {
  const auto view = front_view({}, view_size, 4);
  view->draw();
  const Image image = view->read_pixels();
  const Rgba top = palette(Theme::dark).background_top;
  EXPECT_EQ(count_pixels(image, image.at(0, 0), 60), 320 * 240);
  EXPECT_NEAR(image.at(0, 0)[0], top[0], 2);
}

TEST(view, huge_tiny_and_far_meshes_look_the_same) {
  const Scene scene = sphere_scene(12);
  const auto picture = [&](double scale, glm::dvec3 origin) {
    Scene moved = scene;
    for (glm::dvec3& p : moved.positions) p = origin + scale * p;
    const auto view = front_view(moved, view_size, 1);
    Camera camera;
    camera.eye = origin + scale * glm::dvec3(0.7, 0.9, 3.4);
    camera.target = origin;
    view->set_camera(camera);
    view->draw();
    return view->read_pixels();
  };
  const Image plain = picture(1, {0, 0, 0});
  EXPECT_LT(compare(plain, picture(1e-12, {0, 0, 0}))->share, 0.002);
  EXPECT_LT(compare(plain, picture(1e12, {0, 0, 0}))->share, 0.002);
  EXPECT_LT(compare(plain, picture(1, {1e6, -2e6, 5e5}))->share, 0.002);
}

TEST(view, supersampling_smooths_the_silhouette) {
  const Scene scene = square_scene(1);
  const auto view = front_view(scene, view_size, 4);
  Camera camera = view->camera();
  camera.up = {0.2, 1, 0};
  view->set_camera(camera);
  view->draw();
  const Image plain = view->read_pixels();
  view->resize(view_size, 4);
  view->draw();
  const Image smooth = view->read_pixels();
  EXPECT_EQ(smooth.size, view_size);
  const Result<ImageDifference> difference = compare(plain, smooth);
  EXPECT_GT(difference->pixels, 100u);
  EXPECT_LT(difference->share, 0.05);
}

TEST(view, transparent_picture_has_alpha_around_the_mesh) {
  const auto view = front_view(square_scene(1), view_size, 4);
  view->set_transparent(true);
  view->draw();
  const Image image = view->read_pixels();
  EXPECT_EQ(image.at(5, 5), (Rgba{0, 0, 0, 0}));
  EXPECT_EQ(image.at(160, 100)[3], 255);
}

TEST(view, perspective_line_through_the_near_plane_is_cut) {
  const auto view = front_view(square_scene(1), view_size, 4);
  Camera camera;
  camera.eye = {0, 0.3, 2};
  view->set_camera(camera);
  const Rgba colour = rgb(0xFF00FF);
  Overlay overlay;
  overlay.lines.push_back({{0, 0, 0}, {0, 0, 10}, colour, LineStyle::solid, 4});
  view->set_overlay(Layer::highlights, overlay);
  view->draw();
  const Image image = view->read_pixels();
  EXPECT_GT(count_pixels(image, colour), 100);
  EXPECT_EQ(image, full_picture(*view));
}

}  // namespace
}  // namespace ryosen
