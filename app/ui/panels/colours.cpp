// What the surface is coloured by: its legend, the histogram as a tool to select with, and what was measured.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "app/editor/measure_text.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

constexpr std::size_t bar_count = 48;

class ColoursPanel : public Panel {
 public:
  void draw(PanelContext& context) override;

 private:
  void draw_choice(PanelContext& context);
  void draw_legend(PanelContext& context);
  void draw_histogram(PanelContext& context);
  void draw_figures(PanelContext& context);
  void draw_range(PanelContext& context);
  void follow_drag(PanelContext& context, float left, float width);
  void draw_measures(PanelContext& context);
  void count_again(Session& session);

  std::optional<Colouring> counted_;  // of these bars, at this revision of this document
  std::uint64_t counted_serial_ = 0, counted_revision_ = 0;
  std::vector<std::uint32_t> bars_;
  MapFigures figures_;
  float figures_height_ = 0;                                      // the most that they have taken
  std::pair<const ColourMap*, float> figures_place_{nullptr, 0};  // of this map, in this width
  std::optional<std::size_t> grabbed_;                            // the bar where a drag began
};

ImU32 colour_of(const ColourMap& map, MapRange range, double value) {
  return to_imgui32(rgb(colour_at(map.scale, place_on_scale(map, range, value))));
}

void ColoursPanel::count_again(Session& session) {
  const std::uint64_t serial = session.document().serial(), revision = session.document().revision();
  if (counted_ == session.colouring && counted_serial_ == serial && counted_revision_ == revision) return;
  const MapValues& values = session.map_values();
  bars_ = histogram(values.all(), session.colouring->range, bar_count, Outside::at_the_ends);
  figures_ = figures_of(values.all());
  counted_ = session.colouring;
  counted_serial_ = serial;
  counted_revision_ = revision;
}

void ColoursPanel::draw_choice(PanelContext& context) {
  const ColourMap* const map = context.session.colouring ? context.session.colouring->map : nullptr;
  const char* const off = context.text("No colour map", "色分けなし");
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##map", map ? context.text(map->name_en, map->name_ja) : off)) return;
  if (ImGui::Selectable(off, !map)) context.run("colours off");
  for (const ColourMap& row : colour_maps()) {
    if (ImGui::Selectable(context.text(row.name_en, row.name_ja), &row == map))
      context.run("colours " + std::string(row.id));
    tip(context.text(row.legend_en, row.legend_ja));
  }
  ImGui::EndCombo();
}

// The colours from the low end to the high one, with a value below each end and the middle.
void ColoursPanel::draw_legend(PanelContext& context) {
  const ColourMap* const map = context.session.colouring->map;
  const MapRange range = context.session.colouring->range;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = 12 * context.scale;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const int steps = std::max(1, static_cast<int>(width));
  for (int i = 0; i < steps; ++i) {
    const float x = at.x + static_cast<float>(i);
    const double value = std::lerp(range.low, range.high, (i + 0.5) / steps);
    list->AddRectFilled({x, at.y}, {x + 1, at.y + height}, colour_of(*map, range, value));
  }
  ImGui::Dummy({width, height});
  const std::vector<std::string> numbers =
      numbers_alike(std::array{range.low, std::midpoint(range.low, range.high), range.high});
  const auto words = [&](std::size_t i, const char* sign = "") {
    return sign + numbers[i] + std::string(sign_of(map->unit));
  };
  const auto room = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  const auto tick = [&](const std::string& text, float share) {
    list->AddText({at.x + share * (width - room(text)), at.y + height}, ImGui::GetColorU32(ImGuiCol_Text),
                  text.c_str());
  };
  const std::string low = words(0, figures_.lowest < range.low ? "< " : ""), middle = words(1),
                    high = words(2, figures_.highest > range.high ? "> " : "");
  tick(low, 0);
  const float gap = 6 * context.scale, beside = (width - room(middle)) / 2 - gap;
  if (room(low) <= beside && room(high) <= beside) tick(middle, 0.5f);
  tick(high, 1);
  ImGui::Dummy({width, ImGui::GetTextLineHeight()});
}

void ColoursPanel::follow_drag(PanelContext& context, float left, float width) {
  const ColourMap* const map = context.session.colouring->map;
  const MapRange range = context.session.colouring->range;
  // The bars at the ends hold what lies beyond the range too.
  const auto edge_of = [&](std::size_t bar) {
    if (bar == 0) return std::min(range.low, figures_.lowest);
    if (bar == bar_count) return std::max(range.high, figures_.highest);
    return std::lerp(range.low, range.high, static_cast<double>(bar) / static_cast<double>(bar_count));
  };
  const float share = std::clamp((ImGui::GetIO().MousePos.x - left) / width, 0.f, 0.9999f);
  const auto bar = static_cast<std::size_t>(share * static_cast<float>(bar_count));
  if (ImGui::IsItemActivated()) grabbed_ = bar;
  const bool is_hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  const std::size_t first = std::min(bar, grabbed_.value_or(bar)), last = std::max(bar, grabbed_.value_or(bar));
  std::uint64_t count = 0;
  for (std::size_t i = first; i <= last; ++i) count += bars_[i];
  const std::vector<std::string> ends = numbers_alike(std::array{edge_of(first), edge_of(last + 1)});
  if (is_hovered)
    ImGui::SetTooltip("%s .. %s%s: %s", ends[0].c_str(), ends[1].c_str(), std::string(sign_of(map->unit)).c_str(),
                      grouped(static_cast<std::int64_t>(count)).c_str());
  if (!ImGui::IsItemDeactivated() || !grabbed_) return;
  grabbed_.reset();
  char line[160];
  const double end = last + 1 == bar_count ? edge_of(bar_count) : std::nextafter(edge_of(last + 1), range.low);
  std::snprintf(line, sizeof line, "select by %s %.17g %.17g", std::string(map->id).c_str(), edge_of(first), end);
  context.run(line);
}

void ColoursPanel::draw_histogram(PanelContext& context) {
  const ColourMap* const map = context.session.colouring->map;
  const MapRange range = context.session.colouring->range;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = 64 * context.scale;
  ImGui::InvisibleButton("histogram", {width, height});
  const std::uint32_t most = std::max(1u, *std::max_element(bars_.begin(), bars_.end()));
  const float step = width / static_cast<float>(bar_count), pointer = ImGui::GetIO().MousePos.x;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const auto under =
      static_cast<std::size_t>(std::clamp((pointer - at.x) / step, 0.f, static_cast<float>(bar_count - 1)));
  for (std::size_t i = 0; i < bar_count; ++i) {
    const float x = at.x + static_cast<float>(i) * step;
    const bool is_marked = grabbed_ ? i >= std::min(under, *grabbed_) && i <= std::max(under, *grabbed_)
                                    : ImGui::IsItemHovered() && i == under;
    if (is_marked)
      list->AddRectFilled({x, at.y}, {x + step, at.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBgHovered));
    if (bars_[i] == 0) continue;
    const float tall = std::max(2 * context.scale, height * static_cast<float>(bars_[i]) / static_cast<float>(most));
    const double value =
        std::lerp(range.low, range.high, (static_cast<double>(i) + 0.5) / static_cast<double>(bar_count));
    const ImVec2 top{x, at.y + height - tall}, foot{x + std::max(1.f, step - 1), at.y + height};
    list->AddRectFilled(top, foot, colour_of(*map, range, value));
    // Where the colour is that of the panel, the outline shows the bar.
    list->AddRect(top, foot, ImGui::GetColorU32(ImGuiCol_TextDisabled));
  }
  list->AddLine({at.x, at.y + height}, {at.x + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
  follow_drag(context, at.x, width);
}

// Which part of the values the colours are spread over, and the other choice.
void ColoursPanel::draw_range(PanelContext& context) {
  const ColourMap* const map = context.session.colouring->map;
  const MapRange range = context.session.colouring->range;
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

void ColoursPanel::draw_measures(PanelContext& context) {
  const Session& session = context.session;
  if (session.measures.empty()) return;
  ImGui::Separator();
  for (const Elements& measured : session.measures)
    labelled(context, names_of_measured(session.mesh(), measured).c_str(),
             measured_text(session.mesh(), measured).in(context.language()));
  if (ImGui::Button(context.text("Clear measures", "計測を消す"))) context.run("measure clear");
}

// In as much room as it has taken so far: what is below, as the slider that changes the values, does not jump with them.
void ColoursPanel::draw_figures(PanelContext& context) {
  const ColourMap* const map = context.session.colouring->map;
  const std::pair<const ColourMap*, float> place(map, ImGui::GetContentRegionAvail().x);
  const float top = ImGui::GetCursorPosY();
  dim_text(context, short_text_of(*map, figures_).in(context.language()).c_str());
  const float height = ImGui::GetCursorPosY() - top;
  figures_height_ = std::exchange(figures_place_, place) == place ? std::max(figures_height_, height) : height;
  ImGui::SetCursorPosY(top + figures_height_);
}

void ColoursPanel::draw(PanelContext& context) {
  Session& session = context.session;
  draw_choice(context);
  if (session.colouring) {
    count_again(session);
    draw_histogram(context);
    draw_legend(context);
    draw_figures(context);
    draw_range(context);
  }
  ImGui::BeginDisabled(session.selection.empty());
  if (ImGui::Button(context.text("Measure the selection", "選択を計測"))) context.run("measure selected");
  ImGui::EndDisabled();
  draw_measures(context);
}

}  // namespace

std::unique_ptr<Panel> make_colours_panel() { return std::make_unique<ColoursPanel>(); }

}  // namespace ryosen
