#include "app/ui/plot_picture.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/ui/fonts.h"
#include "render/canvas.h"

namespace ryosen {

namespace {

constexpr float font_px = 15, margin_px = 18;

// A Dear ImGui of its own.
class PlainFrame {
 public:
  PlainFrame(Theme theme, bool japanese) : before_(ImGui::GetCurrentContext()), imgui_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(imgui_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    load_label_font(*io.Fonts, font_px, japanese);
    apply_style(theme, 1);
  }
  ~PlainFrame() {
    ImGui::DestroyContext(imgui_);
    ImGui::SetCurrentContext(before_);
  }
  PlainFrame(const PlainFrame&) = delete;
  PlainFrame& operator=(const PlainFrame&) = delete;

  ImFontAtlas& fonts() { return *ImGui::GetIO().Fonts; }
  ImDrawList& begin(Size size) {
    ImGui::GetIO().DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    ImGui::NewFrame();
    return *ImGui::GetBackgroundDrawList();
  }
  const ImDrawData& end() {
    ImGui::Render();
    return *ImGui::GetDrawData();
  }

 private:
  ImGuiContext *before_, *imgui_;
};

// Draws them, or finds how high they are together.
float lay_out(std::span<const LogPlot> plots, int columns, float width_px, Theme theme, ImDrawList* list) {
  const float each = (width_px - margin_px) / static_cast<float>(columns) - margin_px;
  float top = margin_px, height = 0;
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const auto column = static_cast<float>(i % static_cast<std::size_t>(columns));
    if (column == 0 && i > 0) top += std::exchange(height, 0) + margin_px;
    if (list) draw_log_plot(*list, {margin_px + column * (each + margin_px), top}, each, plots[i], theme);
    height = std::max(height, size_of_plot(plots[i], each).y);
  }
  return top + height + margin_px;
}

}  // namespace

Result<Image> picture_of_plots(std::span<const LogPlot> plots, int columns, int width_px, Theme theme,
                               Language language, Backend backend) {
  const Result<std::unique_ptr<Context>> context = make_headless_context(backend);
  if (!context) return context.failure();
  const Result<std::unique_ptr<Canvas>> made = Canvas::make();
  if (!made) return made.failure();
  Canvas& canvas = **made;
  PlainFrame frame(theme, language == Language::japanese);
  canvas.set_fonts(frame.fonts());
  // The height is known only while there is a frame.
  Size size{width_px, 1};
  frame.begin(size);
  size.height = static_cast<int>(std::ceil(lay_out(plots, columns, static_cast<float>(width_px), theme, nullptr)));
  frame.end();
  canvas.resize(size);
  ImDrawList& list = frame.begin(size);
  list.AddRectFilled({0, 0}, {static_cast<float>(size.width), static_cast<float>(size.height)},
                     ImGui::ColorConvertFloat4ToU32(ui_colours(theme).panel));
  lay_out(plots, columns, static_cast<float>(width_px), theme, &list);
  canvas.draw_over(frame.end());
  return canvas.read_pixels();
}

}  // namespace ryosen
