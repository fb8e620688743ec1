#include "app/ui/log_plot.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "app/ui/fonts.h"
#include "app/ui/widgets.h"
#include "render/canvas.h"

namespace ryosen {

namespace {

// From which width on the list stands beside the axes.
constexpr float wide_ems = 34, least_axes_ems = 18, axes_high_ems = 15;

float em() { return ImGui::GetFontSize(); }
float line_px() { return 1.3f * em(); }
bool is_wide(float width_px) { return width_px >= wide_ems * em(); }

// What the list needs beside the axes, as far as there is room.
float list_width(const LogPlot& plot, float width_px) {
  float names = 0;
  for (const LogCurve& curve : plot.curves)
    names = std::max(names, ImGui::CalcTextSize((curve.name + curve.slope).c_str()).x);
  return std::min(names + 4 * em(), width_px - least_axes_ems * em());
}

// Powers of ten around all numbers, at least one decade.
struct Decades {
  int first = 0, last = 1;

  double share(double value) const { return (std::log10(value) - first) / (last - first); }
};

Decades decades_of(const LogPlot& plot, int axis) {
  double least = INFINITY, most = 0;
  for (const LogCurve& curve : plot.curves)
    for (const glm::dvec2& point : curve.points)
      if (point.x > 0 && point.y > 0) {
        least = std::min(least, point[axis]);
        most = std::max(most, point[axis]);
      }
  if (!(most > 0)) return {};
  Decades decades{static_cast<int>(std::floor(std::log10(least) + 1e-9)),
                  static_cast<int>(std::ceil(std::log10(most) - 1e-9))};
  if (decades.first == decades.last) ++decades.last;
  return decades;
}

std::string power_text(int exponent) {
  if (exponent >= 0 && exponent <= 6) return grouped(static_cast<std::int64_t>(std::llround(std::pow(10, exponent))));
  return "1e" + std::to_string(exponent);
}

// Far apart for neighbours in the list.
ImU32 colour_of(std::size_t i, Theme theme) {
  const float hue = std::fmod(0.56f + 0.381966f * static_cast<float>(i), 1.0f);
  float r = 0, g = 0, b = 0;
  ImGui::ColorConvertHSVtoRGB(hue, theme == Theme::dark ? 0.55f : 0.85f, theme == Theme::dark ? 0.95f : 0.62f, r, g, b);
  return ImGui::ColorConvertFloat4ToU32({r, g, b, 1});
}

// A shape around its middle, of a radius of 1: a closed outline, filled or not, or else strokes from corner to corner.
struct PlotMark {
  enum class Kind : std::uint8_t { filled, outline, strokes } kind;
  std::vector<ImVec2> corners;
};

std::vector<ImVec2> regular_corners(int corners, float size, float turn) {
  std::vector<ImVec2> all;
  for (int k = 0; k < corners; ++k) {
    const float angle = 6.2831853f * (static_cast<float>(k) + turn) / static_cast<float>(corners);
    all.emplace_back(size * std::sin(angle), -size * std::cos(angle));
  }
  return all;
}

// So many that no two curves of a plot share one; neighbours in the list look least alike.
const std::vector<PlotMark>& plot_marks() {
  using Kind = PlotMark::Kind;
  static const std::vector<PlotMark> all = [] {
    std::vector<PlotMark> some;
    for (const Kind kind : {Kind::filled, Kind::outline}) {
      some.push_back({kind, regular_corners(12, 1, 0)});       // a disc
      some.push_back({kind, regular_corners(4, 1.3f, 0.5f)});  // a square
      some.push_back({kind, regular_corners(3, 1.4f, 0)});     // a triangle that points up
      some.push_back({kind, regular_corners(4, 1.4f, 0)});     // a diamond
      some.push_back({kind, regular_corners(3, 1.4f, 0.5f)});  // one that points down
    }
    const ImVec2 up(0, -1.4f), down(0, 1.4f), left(-1.4f, 0), right(1.4f, 0);
    some.push_back({Kind::strokes, {up, down, left, right}});
    some.push_back({Kind::strokes, {{-1, -1}, {1, 1}, {-1, 1}, {1, -1}}});
    some.push_back({Kind::strokes, {up, down, {-1.2f, -0.7f}, {1.2f, 0.7f}, {-1.2f, 0.7f}, {1.2f, -0.7f}}});
    some.push_back({Kind::strokes, {{-1.2f, -0.6f}, {1.2f, -0.6f}, {-1.2f, 0.6f}, {1.2f, 0.6f}}});
    return some;
  }();
  return all;
}

void draw_plot_mark(ImDrawList& list, ImVec2 at, std::size_t i, ImU32 colour) {
  const PlotMark& mark = plot_marks()[i % plot_marks().size()];
  const float r = 0.24f * em(), thick = 0.13f * em();
  std::vector<ImVec2> corners;
  for (const ImVec2& corner : mark.corners) corners.emplace_back(at.x + r * corner.x, at.y + r * corner.y);
  const int n = static_cast<int>(corners.size());
  if (mark.kind == PlotMark::Kind::filled) return list.AddConvexPolyFilled(corners.data(), n, colour);
  if (mark.kind == PlotMark::Kind::outline)
    return list.AddPolyline(corners.data(), n, colour, ImDrawFlags_Closed, thick);
  for (std::size_t k = 0; k + 1 < corners.size(); k += 2) list.AddLine(corners[k], corners[k + 1], colour, thick);
}

// From point to point, whole or in dashes.
void draw_plot_way(ImDrawList& list, std::span<const ImVec2> points, std::size_t i, ImU32 colour) {
  const float thick = 0.12f * em(), dash = 0.5f * em(), gap = 0.35f * em();
  if (i % 2 == 0) return list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, thick);
  float along = 0;  // from the beginning of a dash
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const ImVec2 a = points[k], way(points[k + 1].x - a.x, points[k + 1].y - a.y);
    const float length = std::hypot(way.x, way.y);
    for (float done = 0; done < length;) {
      const float step = std::min((along < dash ? dash : dash + gap) - along, length - done), share = 1 / length;
      if (along < dash)
        list.AddLine({a.x + way.x * done * share, a.y + way.y * done * share},
                     {a.x + way.x * (done + step) * share, a.y + way.y * (done + step) * share}, colour, thick);
      done += step;
      along = along + step >= dash + gap - 1e-3f ? 0 : along + step;
    }
  }
}

class PlotDrawing {
 public:
  PlotDrawing(ImDrawList& list, ImVec2 corner, float width_px, const LogPlot& plot, Theme theme)
      : list_(list),
        plot_(plot),
        theme_(theme),
        across_(decades_of(plot, 0)),
        up_(decades_of(plot, 1)),
        corner_(corner) {
    const float labels = 4.6f * em(),
                right = corner.x + (is_wide(width_px) ? width_px - list_width(plot, width_px) - em() : width_px);
    first_ = {corner.x + labels, corner.y + 2.4f * line_px()};
    last_ = {right - 0.6f * em(), corner.y + axes_high_ems * em() - 2 * line_px()};
    list_corner_ = is_wide(width_px) ? ImVec2(right + em(), corner.y + line_px())
                                     : ImVec2(corner.x, corner.y + axes_high_ems * em());
    list_right_ = corner.x + width_px;
  }

  void draw() {
    list_.AddText(corner_, text(), plot_.title.c_str());
    draw_axes();
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) draw_curve(i);
    draw_list();
  }

 private:
  ImU32 text() const { return ImGui::GetColorU32(ImGuiCol_Text); }
  ImU32 dim() const { return ImGui::ColorConvertFloat4ToU32(ui_colours(theme_).dim); }
  ImU32 line() const { return ImGui::ColorConvertFloat4ToU32(ui_colours(theme_).line); }

  float x_of(double value) const { return first_.x + static_cast<float>(across_.share(value)) * (last_.x - first_.x); }
  float y_of(double value) const { return last_.y - static_cast<float>(up_.share(value)) * (last_.y - first_.y); }

  void text_ending_at(ImVec2 right, const std::string& words) {
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    list_.AddText({right.x - size.x, right.y - 0.5f * size.y}, dim(), words.c_str());
  }

  // Lines at the powers of ten; numbers at as many of them as have room.
  void draw_axes() {
    float free_from = first_.x - 3 * em();
    for (int power = across_.first; power <= across_.last; ++power) {
      const float x = x_of(std::pow(10, power));
      list_.AddLine({x, first_.y}, {x, last_.y}, line());
      const std::string number = power_text(power);
      const float width = ImGui::CalcTextSize(number.c_str()).x;
      const float left = std::min(x - 0.5f * width, last_.x + 0.6f * em() - width);
      if (left < free_from) continue;
      list_.AddText({left, last_.y + 0.2f * em()}, dim(), number.c_str());
      free_from = left + width + 0.5f * em();
    }
    const int step = std::max(1, (up_.last - up_.first + 5) / 6);
    for (int power = up_.first; power <= up_.last; ++power) {
      const float y = y_of(std::pow(10, power));
      list_.AddLine({first_.x, y}, {last_.x, y}, line());
      if ((power - up_.first) % step == 0) text_ending_at({first_.x - 0.4f * em(), y}, power_text(power));
    }
    list_.AddText({corner_.x, corner_.y + line_px() - 0.1f * em()}, dim(), plot_.up.c_str());
    const float width = ImGui::CalcTextSize(plot_.along.c_str()).x;
    list_.AddText({last_.x - width, last_.y + line_px()}, dim(), plot_.along.c_str());
  }

  void draw_curve(std::size_t i) {
    const ImU32 colour = colour_of(i, theme_);
    std::vector<ImVec2> drawn;
    for (const glm::dvec2& point : plot_.curves[i].points)
      if (point.x > 0 && point.y > 0) drawn.emplace_back(x_of(point.x), y_of(point.y));
    draw_plot_way(list_, drawn, i, colour);
    for (const ImVec2& at : drawn) draw_plot_mark(list_, at, i, colour);
  }

  void draw_list() {
    ImVec2 at = list_corner_;
    text_ending_at({list_right_, at.y + 0.5f * em()}, plot_.of_slopes);
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
      at.y += line_px();
      const LogCurve& curve = plot_.curves[i];
      const ImVec2 sample[] = {{at.x, at.y + 0.5f * em()}, {at.x + 1.9f * em(), at.y + 0.5f * em()}};
      draw_plot_way(list_, sample, i, colour_of(i, theme_));
      draw_plot_mark(list_, {at.x + 0.95f * em(), at.y + 0.5f * em()}, i, colour_of(i, theme_));
      const float slope_px = ImGui::CalcTextSize(curve.slope.c_str()).x;
      const std::string name = fitted(curve.name, list_right_ - at.x - 2.8f * em() - slope_px);
      list_.AddText({at.x + 2.3f * em(), at.y}, text(), name.c_str());
      list_.AddText({list_right_ - slope_px, at.y}, text(), curve.slope.c_str());
    }
  }

  ImDrawList& list_;
  const LogPlot& plot_;
  Theme theme_;
  Decades across_, up_;
  ImVec2 corner_, first_, last_, list_corner_;  // of all, of the axes from upper left to lower right, of the list
  float list_right_ = 0;
};

}  // namespace

ImVec2 size_of_plot(const LogPlot& plot, float width_px) {
  const float axes = axes_high_ems * em(), list = (static_cast<float>(plot.curves.size()) + 1.5f) * line_px();
  return {width_px, is_wide(width_px) ? std::max(axes, list + line_px()) : axes + list};
}

void draw_log_plot(ImDrawList& list, ImVec2 corner, float width_px, const LogPlot& plot, Theme theme) {
  PlotDrawing(list, corner, width_px, plot, theme).draw();
}

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
