#include "render/canvas.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <functional>

#include "tests/support/render/scene.h"

namespace ryosen {
namespace {

constexpr Size window_size{400, 300};

// A context of Dear ImGui that lays out frames without any window.
class Interface {
 public:
  Interface() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(window_size.width, window_size.height);
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.DeltaTime = 1 / 60.0f;
  }
  ~Interface() { ImGui::DestroyContext(); }

  const ImDrawData& frame(const std::function<void()>& contents) {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos(ImVec2(10, 10));
    ImGui::SetNextWindowSize(ImVec2(150, 200));
    ImGui::Begin("Panel", nullptr, ImGuiWindowFlags_NoSavedSettings);
    contents();
    ImGui::End();
    ImGui::Render();
    return *ImGui::GetDrawData();
  }
};

class CanvasTest : public testing::Test {
 protected:
  CanvasTest() : view_(front_view(square_scene(4), {200, 200}, 3)), canvas_(make()) {
    canvas_->set_fonts(*ImGui::GetIO().Fonts);
  }

  // The first frames of Dear ImGui settle sizes.
  void settle(const std::function<void()>& contents) {
    for (int i = 0; i < 3; ++i) interface_.frame(contents);
  }
  std::unique_ptr<Canvas> make() {
    Result<std::unique_ptr<Canvas>> made = Canvas::make();
    EXPECT_TRUE(made.ok());
    (*made)->resize(window_size);
    return std::move(*made);
  }

  Interface interface_;
  std::unique_ptr<Renderer> view_;
  std::unique_ptr<Canvas> canvas_;
};

TEST_F(CanvasTest, shows_the_view_in_its_place_and_text_over_it) {
  const auto contents = [] { ImGui::TextUnformatted("MMMMMMMM"); };
  settle(contents);
  canvas_->compose(*view_, 180, 50, interface_.frame(contents));
  const Image picture = canvas_->read_pixels();
  EXPECT_EQ(picture.at(390, 290), (Rgba{0, 0, 0, 255}));
  const Image view = view_->read_pixels();
  EXPECT_EQ(picture.at(280, 150), view.at(100, 100));
  EXPECT_EQ(picture.at(181, 249), view.at(1, 199));
  int light = 0;
  for (int y = 30; y < 60; ++y) {
    for (int x = 15; x < 120; ++x) light += picture.at(x, y)[0] > 200;
  }
  EXPECT_GT(light, 100);
}

TEST_F(CanvasTest, draws_nothing_when_nothing_changed) {
  const auto contents = [] { ImGui::TextUnformatted("same"); };
  settle(contents);
  EXPECT_EQ(canvas_->compose(*view_, 0, 0, interface_.frame(contents)), 400 * 300);
  EXPECT_EQ(canvas_->compose(*view_, 0, 0, interface_.frame(contents)), 0);
}

TEST_F(CanvasTest, partial_picture_equals_a_new_one) {
  const char* words[] = {"one", "one two", "three", "", "one"};
  settle([] {});
  for (int step = 0; step < 15; ++step) {
    const auto contents = [&] {
      ImGui::TextUnformatted("head");
      ImGui::TextUnformatted(words[step % 5]);
      if (step % 4 == 1) ImGui::Button("press");
      ImGui::TextUnformatted("foot");
    };
    Overlay overlay;
    if (step % 2 == 0) overlay.points.push_back({{0.1 * step - 0.5, 0.2, 0}, rgb(0xE69F00)});
    view_->set_overlay(Layer::hover, overlay);
    const ImDrawData& data = interface_.frame(contents);
    const std::int64_t pixels = canvas_->compose(*view_, 180, 50, data);
    if (step > 1) {
      EXPECT_LT(pixels, 400 * 300 / 2);
    }
    const std::unique_ptr<Canvas> fresh = make();
    fresh->compose(*view_, 180, 50, data);
    ASSERT_EQ(canvas_->read_pixels(), fresh->read_pixels()) << "step " << step;
  }
}

}  // namespace
}  // namespace ryosen
