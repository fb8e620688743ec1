#include "ryosen/scene/highlights/map_values.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "ryosen/analysis/ask_elements.h"
#include "ryosen/analysis/edit_reach.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

const double MapValues::missing = std::numeric_limits<double>::quiet_NaN();

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

int attribute_of(const Mesh& mesh, const ColourMap& map) {
  return map.attribute.empty() || !has_numbers(mesh, map) ? -1 : mesh.find_attribute(map.attribute);
}

// One vertex answers for a point, and one sheet for an edge.
template <class Ask>
auto with_attribute(const Mesh& mesh, const ColourMap& map, const Ask& ask) {
  const int attribute = attribute_of(mesh, map);
  const AttributeColumn* const column =
      attribute < 0 ? nullptr : &mesh.attributes()[static_cast<std::size_t>(attribute)];
  if (map.sort() == Element::Kind::vertex)
    return ask(Vertex(), [column](Neighbourhood& around, Vertex v) {
      return column && around.point(v) == v ? number_at(*column, v.index) : no_number;
    });
  if (map.sort() == Element::Kind::edge)
    return ask(Edge(), [column](Neighbourhood& around, Edge e) {
      const auto [left, right] = faces(around.mesh(), e);
      const bool answers = !(left || right) || around.is_first_sheet(e);
      return column && answers ? number_at(*column, e.index) : no_number;
    });
  return ask(Face(), [column](Neighbourhood& around, Face f) {
    if (!column) return no_number;
    if (column->element == ElementKind::face) return number_at(*column, f.index);
    double sum = 0, corners = 0;
    for (const Halfedge h : halfedges_around(around.mesh(), f)) {
      sum += number_at(*column, h.index);
      ++corners;
    }
    return sum / corners;
  });
}

// Calls ask(handle of the sort, the row's function about it).
template <class Ask>
auto with_sort(const Mesh& mesh, const ColourMap& map, const OtherSurface* other, Ask ask) {
  if (!map.attribute.empty()) return with_attribute(mesh, map, ask);
  if (map.against)
    return ask(Vertex(), [&map, other](Neighbourhood& around, Vertex v) {
      return other ? map.against(around.mesh(), v, *other) : std::numeric_limits<double>::quiet_NaN();
    });
  if (map.vertex) return ask(Vertex(), map.vertex);
  if (map.edge) return ask(Edge(), map.edge);
  return ask(Face(), map.face);
}

bool is_same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

}  // namespace

MapValues::MapValues(const Mesh& mesh, const ColourMap& map, unsigned threads,
                     std::shared_ptr<const OtherSurface> other)
    : map_(&map), other_(std::move(other)), had_copies_(mesh.has_copies()), attribute_(attribute_of(mesh, map)) {
  with_sort(mesh, map, other_.get(), [&](auto handle, auto value) {
    using Handle = decltype(handle);
    const std::uint32_t slots = slots_of(mesh, Handle());
    values_.assign(slots, missing);
    for_each_part(slots, threads ? threads : threads_for(slots), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      Neighbourhood around(mesh, Neighbourhood::Reach::whole);
      for (std::uint32_t i = begin; i < end; ++i)
        if (mesh.is_alive(Handle(i))) values_[i] = value(around, Handle(i));
    });
  });
}

std::optional<std::vector<std::uint32_t>> MapValues::update(const Mesh& mesh, const Journal& journal, std::size_t i) {
  if (journal.replaces_everything(i) || had_copies_ != mesh.has_copies() || attribute_ != attribute_of(mesh, *map_)) {
    *this = MapValues(mesh, *map_, 0, other_);
    return std::nullopt;
  }
  Neighbourhood around(mesh);
  EditReach reach =
      edit_reach(journal, i, around, map_->attribute.empty() ? WrittenValues::ignored : WrittenValues::counted);
  if (map_->reads_whole_faces) add_whole_faces(around, reach);
  if (map_->reads_two_rings) add_neighbours(around, reach);
  std::vector<std::uint32_t> changed;
  const auto ask = [&](const auto& elements, auto value) {
    for (const auto element : elements) {
      if (element.index >= values_.size()) continue;
      const bool is_there = mesh.exists(element) && mesh.is_alive(element);
      const double now = is_there ? value(around, element) : missing;
      if (is_same(now, values_[element.index])) continue;
      values_[element.index] = now;
      changed.push_back(element.index);
    }
  };
  with_sort(mesh, *map_, other_.get(), [&](auto handle, auto value) {
    using Handle = decltype(handle);
    values_.resize(slots_of(mesh, Handle()), missing);
    if constexpr (std::is_same_v<Handle, Vertex>) ask(reach.vertices, value);
    if constexpr (std::is_same_v<Handle, Edge>) ask(reach.edges, value);
    if constexpr (std::is_same_v<Handle, Face>) ask(reach.faces, value);
  });
  return changed;
}

MapFigures figures_of(std::span<const double> values) {
  MapFigures figures;
  std::vector<double> sorted;
  double sum = 0, lost = 0;  // by the rounding of the sum
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    const double value = values[i];
    if (!std::isfinite(value)) continue;
    if (sorted.empty() || value < figures.lowest) figures.lowest = value, figures.lowest_at = i;
    if (sorted.empty() || value > figures.highest) figures.highest = value, figures.highest_at = i;
    sorted.push_back(value);
    const double add = value - lost, next = sum + add;
    lost = (next - sum) - add;
    sum = next;
  }
  if (sorted.empty()) return figures;
  std::sort(sorted.begin(), sorted.end());
  figures.count = sorted.size();
  figures.mean = sum / static_cast<double>(sorted.size());
  double squares = 0;
  for (const double value : sorted) squares += (value - figures.mean) * (value - figures.mean);
  figures.deviation = std::sqrt(squares / static_cast<double>(sorted.size()));
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    return std::lerp(sorted[below], sorted[std::min(below + 1, sorted.size() - 1)], place - std::floor(place));
  };
  figures.percentile_5 = at(0.05);
  figures.quartile_1 = at(0.25);
  figures.median = at(0.5);
  figures.quartile_3 = at(0.75);
  figures.percentile_95 = at(0.95);
  return figures;
}

std::optional<MapRange> extent_of(std::span<const double> values) {
  std::optional<MapRange> extent;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (!extent) extent = MapRange{value, value};
    extent->low = std::min(extent->low, value);
    extent->high = std::max(extent->high, value);
  }
  return extent;
}

namespace {

MapRange about_middle(const ColourMap& map, MapRange range) {
  if (map.scale != MapScale::about_middle || map.is_count) return range;
  const double reach = std::max(range.high - map.middle, map.middle - range.low);
  return {map.middle - reach, map.middle + reach};
}

}  // namespace

MapRange whole_range(const ColourMap& map, const MapFigures& figures) {
  return about_middle(map, {figures.lowest, figures.highest});
}

MapRange first_range(const ColourMap& map, const MapFigures& figures) {
  const double width = figures.percentile_95 - figures.percentile_5;
  if (!(width > 0)) return whole_range(map, figures);
  MapRange range{figures.percentile_5, figures.percentile_95};
  if (range.low - figures.lowest < 0.02 * width) range.low = figures.lowest;
  if (figures.highest - range.high < 0.02 * width) range.high = figures.highest;
  if (map.is_count) range = {std::floor(range.low), std::ceil(range.high)};  // percentiles lie between values
  return about_middle(map, range);
}

std::vector<std::uint32_t> histogram(std::span<const double> values, MapRange range, std::size_t bars,
                                     Outside outside) {
  std::vector<std::uint32_t> counts(bars, 0);
  const double width = range.high - range.low;
  for (const double value : values) {
    const bool is_outside = value < range.low || value > range.high;
    if (!std::isfinite(value) || (is_outside && outside == Outside::left_out)) continue;
    const double share = width > 0 ? std::clamp((value - range.low) / width, 0.0, 1.0) : value > range.high ? 1 : 0;
    ++counts[std::min(static_cast<std::size_t>(share * static_cast<double>(bars)), bars - 1)];
  }
  return counts;
}

}  // namespace ryosen
