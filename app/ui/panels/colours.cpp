// What the surface is coloured by: its legend, the histogram as a tool to select with, and what was measured.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/findings.h"
#include "app/editor/session/selecting.h"
#include "app/editor/texts/measure_text.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

constexpr std::size_t most_bars = 48;

ImU32 colour_of(const ColourMap& map, MapRange range, double value) {
  return to_imgui32(rgb(colour_at(map.scale, place_on_scale(map, range, value))));
}

class ColoursPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    draw_choice(context);
    if (context.view.colouring) {
      count_again(context.document(), context.findings(), context.view);
      draw_histogram(context);
      draw_legend(context);
      draw_figures(context);
      draw_range(context);
    }
    ImGui::BeginDisabled(context.selecting.selection.empty());
    if (ImGui::Button(context.text("Measure the selection", "選択を計測"))) context.run("measure selected");
    ImGui::EndDisabled();
    draw_measures(context);
  }

 private:
  void draw_choice(PanelContext& context) {
    const ColourMap* const map = context.view.colouring ? context.view.colouring->map : nullptr;
    const char* const off = context.text("No colour map", "色分けなし");
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##map", map ? context.text(map->name_en, map->name_ja) : off)) return;
    if (ImGui::Selectable(off, !map)) context.run("colours off");
    for (const ColourMap* const row : colour_maps_of(context.mesh())) {
      if (ImGui::Selectable(context.text(row->name_en, row->name_ja), row == map))
        context.run("colours " + std::string(row->id));
      tip(context.text(row->legend_en, row->legend_ja));
    }
    ImGui::EndCombo();
  }

  // The colours from the low end to the high one, with a value below each end and the middle.
  void draw_legend(PanelContext& context) {
    const auto [map, range] = *context.view.colouring;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = 12 * context.scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const int steps = std::max(1, static_cast<int>(width));
    for (int i = 0; i < steps; ++i) {
      const float x = at.x + static_cast<float>(i);
      const double value = std::lerp(span_.low, span_.high, (i + 0.5) / steps);
      list->AddRectFilled({x, at.y}, {x + 1, at.y + height}, colour_of(*map, range, value));
    }
    ImGui::Dummy({width, height});
    draw_ticks(context, {at.x, at.y + height}, width);
    ImGui::Dummy({width, ImGui::GetTextLineHeight()});
  }

  void draw_ticks(PanelContext& context, ImVec2 at, float width) {
    const auto [map, range] = *context.view.colouring;
    const std::vector<double> values = legend_values(*map, range, 3);
    const std::vector<std::string> numbers = numbers_of(*map, values);
    struct Tick {
      std::string text;
      float begin, end;
    };
    std::vector<Tick> ticks;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool is_low = i == 0 && figures_.lowest < range.low;
      const bool is_high = i > 0 && i + 1 == values.size() && figures_.highest > range.high;
      const std::string text = (is_low ? "< " : is_high ? "> " : "") + numbers[i] + std::string(sign_of(map->unit));
      const double extent = span_.high - span_.low;
      const float place = width * static_cast<float>(extent > 0 ? (values[i] - span_.low) / extent : 0.5);
      const float room = ImGui::CalcTextSize(text.c_str()).x;
      const float begin = std::max(std::min(place - room / 2, width - room), 0.f);
      ticks.push_back({text, begin, begin + room});
    }
    // The middle one where there is room between the ends.
    const float gap = 6 * context.scale;
    if (ticks.size() == 3 && (ticks[0].end + gap > ticks[1].begin || ticks[1].end + gap > ticks[2].begin))
      ticks.erase(ticks.begin() + 1);
    for (const Tick& tick : ticks)
      ImGui::GetWindowDrawList()->AddText({at.x + tick.begin, at.y}, ImGui::GetColorU32(ImGuiCol_Text),
                                          tick.text.c_str());
  }

  void draw_histogram(PanelContext& context) {
    const auto [map, range] = *context.view.colouring;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = 64 * context.scale;
    ImGui::InvisibleButton("histogram", {width, height});
    const std::uint32_t most = std::max(1u, *std::max_element(bars_.begin(), bars_.end()));
    const auto bars = static_cast<float>(bars_.size());
    const float step = width / bars, pointer = ImGui::GetIO().MousePos.x;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const auto under = static_cast<std::size_t>(std::clamp((pointer - at.x) / step, 0.f, bars - 1));
    for (std::size_t i = 0; i < bars_.size(); ++i) {
      const float x = at.x + static_cast<float>(i) * step;
      const bool is_marked = grabbed_ ? i >= std::min(under, *grabbed_) && i <= std::max(under, *grabbed_)
                                      : ImGui::IsItemHovered() && i == under;
      if (is_marked)
        list->AddRectFilled({x, at.y}, {x + step, at.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBgHovered));
      if (bars_[i] == 0) continue;
      const float tall = std::max(2 * context.scale, height * static_cast<float>(bars_[i]) / static_cast<float>(most));
      const double value = std::lerp(span_.low, span_.high, (static_cast<double>(i) + 0.5) / bars);
      const ImVec2 top{x, at.y + height - tall}, foot{x + std::max(1.f, step - 1), at.y + height};
      list->AddRectFilled(top, foot, colour_of(*map, range, value));
      // Where the colour is that of the panel, the outline shows the bar.
      list->AddRect(top, foot, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    }
    list->AddLine({at.x, at.y + height}, {at.x + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    follow_drag(context, at.x, width);
  }

  // In as much room as it has taken so far: what is below, as the slider that changes the values, does not jump with
  // them.
  void draw_figures(PanelContext& context) {
    const ColourMap* const map = context.view.colouring->map;
    const std::pair<const ColourMap*, float> place(map, ImGui::GetContentRegionAvail().x);
    const float top = ImGui::GetCursorPosY();
    dim_text(context, short_text_of(*map, figures_).in(context.language()).c_str());
    const float height = ImGui::GetCursorPosY() - top;
    figures_height_ = std::exchange(figures_place_, place) == place ? std::max(figures_height_, height) : height;
    ImGui::SetCursorPosY(top + figures_height_);
  }

  // Which part of the values the colours are spread over, and the other choice.
  void draw_range(PanelContext& context) {
    const auto [map, range] = *context.view.colouring;
    const MapRange whole = whole_range(*map, figures_), first = first_range(*map, figures_);
    if (whole == first) return;
    const std::string line = "colours " + std::string(map->id);
    if (range == whole) {
      if (ImGui::Button(context.text("Middle 90 %", "中央の 90 %"))) context.run(line);
      tip(context.text("Spreads the colours over the middle nine tenths of the values; the rest look as their ends.",
                       "色を中央の 9 割の値に割り当てます。外側の値は端の色になります。"));
    } else {
      if (ImGui::Button(context.text("All values", "すべての値"))) context.run(line + " all");
      tip(context.text("Spreads the colours from the lowest value to the highest.",
                       "色を最小値から最大値までに割り当てます。"));
    }
  }

  void follow_drag(PanelContext& context, float left, float width) {
    const ColourMap* const map = context.view.colouring->map;
    const float share = std::clamp((ImGui::GetIO().MousePos.x - left) / width, 0.f, 0.9999f);
    const auto bar = static_cast<std::size_t>(share * static_cast<float>(bars_.size()));
    if (ImGui::IsItemActivated()) grabbed_ = bar;
    const bool is_hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
    const std::size_t first = std::min(bar, grabbed_.value_or(bar)), last = std::max(bar, grabbed_.value_or(bar));
    std::uint64_t count = 0;
    for (std::size_t i = first; i <= last; ++i) count += bars_[i];
    const MapRange held = held_by(first, last);
    if (is_hovered) {
      const std::vector<std::string> ends = numbers_of(*map, std::array{held.low, held.high});
      const std::string both = ends[0] == ends[1] ? ends[0] : ends[0] + " .. " + ends[1];
      ImGui::SetTooltip("%s%s: %s", both.c_str(), std::string(sign_of(map->unit)).c_str(),
                        grouped(static_cast<std::int64_t>(count)).c_str());
    }
    if (!ImGui::IsItemDeactivated() || !grabbed_) return;
    grabbed_.reset();
    char line[160];
    std::snprintf(line, sizeof line, "select by %s %.17g %.17g", std::string(map->id).c_str(), held.low, held.high);
    context.run(line);
  }

  // The bars at the ends hold what lies beyond the range too.
  double edge_of(std::size_t bar) const {
    if (bar == 0) return std::min(span_.low, figures_.lowest);
    if (bar == bars_.size()) return std::max(span_.high, figures_.highest);
    return std::lerp(span_.low, span_.high, static_cast<double>(bar) / static_cast<double>(bars_.size()));
  }

  // The lowest and the highest value that these bars may hold.
  MapRange held_by(std::size_t first, std::size_t last) const {
    const double low = edge_of(first), end = edge_of(last + 1);
    const double high = last + 1 == bars_.size() ? end : std::nextafter(end, span_.low);
    return counted_->map->is_count ? MapRange{std::ceil(low), std::floor(high)} : MapRange{low, high};
  }

  void draw_measures(PanelContext& context) {
    if (context.selecting.measures.empty()) return;
    ImGui::Separator();
    for (const Elements& measured : context.selecting.measures)
      labelled(context, names_of_measured(context.mesh(), measured).c_str(),
               measured_text(context.mesh(), measured).in(context.language()));
    if (ImGui::Button(context.text("Clear measures", "計測を消す"))) context.run("measure clear");
  }

  void count_again(const Document& document, Findings& findings, const ViewState& view) {
    const std::uint64_t serial = document.serial(), revision = document.revision();
    if (counted_ == view.colouring && counted_serial_ == serial && counted_revision_ == revision) return;
    const MapValues& values = findings.map_values(*view.colouring);
    span_ = view.colouring->range;
    double bars = most_bars;
    if (values.map().is_count) {  // a bar for each value, as far as they have room
      span_ = {std::floor(span_.low) - 0.5, std::ceil(span_.high) + 0.5};
      bars = std::min(bars, span_.high - span_.low);
    }
    bars_ = histogram(values.all(), span_, static_cast<std::size_t>(bars), Outside::at_the_ends);
    figures_ = figures_of(values.all());
    if (grabbed_ && *grabbed_ >= bars_.size()) grabbed_.reset();
    counted_ = view.colouring;
    counted_serial_ = serial;
    counted_revision_ = revision;
  }

  std::optional<Colouring> counted_;  // of these bars, at this revision of this document
  std::uint64_t counted_serial_ = 0, counted_revision_ = 0;
  std::vector<std::uint32_t> bars_;
  MapRange span_;  // from the first to the last one
  MapFigures figures_;
  float figures_height_ = 0;                                      // the most that they have taken
  std::pair<const ColourMap*, float> figures_place_{nullptr, 0};  // of this map, in this width
  std::optional<std::size_t> grabbed_;                            // the bar where a drag began
};

}  // namespace

std::unique_ptr<Panel> make_colours_panel() { return std::make_unique<ColoursPanel>(); }

}  // namespace ryosen
