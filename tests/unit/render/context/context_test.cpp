#include "render/context/context.h"

#include <gtest/gtest.h>

#include "render/gl/api.h"
#include "render/gl/framebuffer.h"
#include "render/image.h"
#include "tests/support/render/context.h"

namespace ryosen {
namespace {

// Clears a small framebuffer to a colour and reads a pixel of it back.
Rgba cleared_pixel() {
  constexpr PixelFormat formats[] = {PixelFormat::rgba8};
  Framebuffer target("test", formats, true);
  target.resize({8, 4});
  target.bind({0, 0, 8, 4});
  glClearColor(1, 0, 0.2f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  Rgba pixel{};
  target.read(0, {3, 2, 4, 3}, pixel.data());
  return pixel;
}

TEST(context, osmesa_draws) {
  test_context().make_current();
  EXPECT_EQ(test_context().name(), "osmesa");
  EXPECT_EQ(cleared_pixel(), (Rgba{255, 0, 51, 255}));
}

TEST(context, egl_draws_where_it_is_installed_and_gives_way_to_osmesa) {
  {
    Result<std::unique_ptr<Context>> egl = make_headless_context(Backend::egl);
    if (egl) {
      EXPECT_EQ((*egl)->name(), "egl");
      EXPECT_EQ(cleared_pixel(), (Rgba{255, 0, 51, 255}));
    } else {
      EXPECT_EQ(egl.failure().exit_code, ExitCode::no_backend);
      EXPECT_FALSE(egl.failure().message.text.ja.empty());
    }
  }
  ASSERT_TRUE(test_context().make_current());
  EXPECT_EQ(cleared_pixel(), (Rgba{255, 0, 51, 255}));
}

TEST(context, report_names_every_backend) {
  const std::vector<BackendReport> reports = report_backends();
  test_context().make_current();
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[0].name, "osmesa");
  EXPECT_EQ(reports[1].name, "egl");
  EXPECT_TRUE(reports[0].works());
  EXPECT_FALSE(reports[0].library.empty());
  for (const BackendReport& report : reports) EXPECT_EQ(report.works(), report.problem.en.empty());
}

TEST(framebuffer, counts_rows_from_the_top) {
  test_context().make_current();
  constexpr PixelFormat formats[] = {PixelFormat::rgba8};
  Framebuffer target("test", formats, false);
  target.resize({2, 3});
  target.bind({0, 0, 2, 3});
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  target.bind({0, 0, 2, 1});
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  Image image(Size{2, 3});
  target.read(0, {0, 0, 2, 3}, image.pixels.data());
  EXPECT_EQ(image.at(0, 0), (Rgba{255, 255, 255, 255}));
  EXPECT_EQ(image.at(1, 1), (Rgba{0, 0, 0, 255}));
  EXPECT_EQ(image.at(1, 2), (Rgba{0, 0, 0, 255}));
}

}  // namespace
}  // namespace ryosen
