#include "ryosen/analysis/overlap_tree.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ryosen {

namespace {

constexpr std::uint32_t least_star = 64;      // fewest triangles around a point that get a subtree
constexpr std::uint32_t least_slivers = 128;  // fewest triangles that get a view aligned with them
constexpr std::uint32_t least_stack = 128;    // fewest triangles that are parted by their normals
constexpr double sliver_size = 16.0;          // ratio of box to triangle area above which boxes separate poorly

// Partitions at the `middle`-th item by box centre along the axis of largest extent.
template <class Item, class Number>
void halve(std::span<Item> items, std::size_t middle, const Number& number) {
  const auto center = [](const Item& item, std::size_t axis) { return item.box.lowest[axis] + item.box.highest[axis]; };
  OverlapBox centers = OverlapBox::of_nothing();
  for (const Item& item : items) {
    const std::array<float, OverlapBox::sides> c{center(item, 0), center(item, 1), center(item, 2)};
    centers.grow({c, c});
  }
  std::size_t axis = 0;
  const auto width = [&](std::size_t k) { return centers.highest[k] - centers.lowest[k]; };
  for (std::size_t k = 1; k < 3; ++k)
    if (width(k) > width(axis)) axis = k;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle), items.end(),
                   [&](const Item& a, const Item& b) {
                     const float x = center(a, axis), y = center(b, axis);
                     return x != y ? x < y : number(a) < number(b);
                   });
}

glm::dvec3 longest_side(const NumberedTriangle& t) {
  glm::dvec3 longest(0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 side = t.places[(k + 1) % 3] - t.places[k];
    if (glm::dot(side, side) > glm::dot(longest, longest)) longest = side;
  }
  return longest;
}

// How many of the boxes would fit side by side along the axis along which they lie furthest apart for their size.
float separation(std::span<const OverlapBox> boxes) {
  float most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float lowest = std::numeric_limits<float>::infinity(), highest = -lowest, width = 0;
    for (const OverlapBox& box : boxes) {
      const float middle = 0.5F * box.lowest[axis] + 0.5F * box.highest[axis];
      lowest = std::min(lowest, middle);
      highest = std::max(highest, middle);
      width += (box.highest[axis] - box.lowest[axis]) / static_cast<float>(boxes.size());
    }
    if (highest > lowest) most = std::max(most, (highest - lowest) / width);
  }
  return most;
}

}  // namespace

OverlapTree::OverlapTree(const NumberedSurface& surface, unsigned threads) : surface_(surface) {
  add_view(OverlapView(surface.origin(), surface.scale(), glm::dmat3(1.0)));
  collect_triangles(threads);
  std::vector<Star> stars = gather_stars();
  const std::uint32_t others = stars.empty() ? static_cast<std::uint32_t>(triangles_.size()) : stars.front().first;
  nodes_.resize(nodes_for(others) + nodes_for(stars));
  if (others > 0) build(0, 0, others, views_.front(), threads);
  if (!stars.empty()) build_stars(nodes_for(others), stars, threads);
}

void OverlapTree::collect_triangles(unsigned threads) {
  triangles_.resize(surface_.slots());
  for_each_part(surface_.slots(), threads, [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t slot = begin; slot < end; ++slot)
      triangles_[slot] = surface_.is_flat(slot) ? Triangle{OverlapBox::of_nothing(), no_index}
                                                : Triangle{views_.front().box_of(surface_.triangle(slot)), slot};
  });
  std::erase_if(triangles_, [](const Triangle& t) { return t.slot == no_index; });
}

std::vector<OverlapTree::Star> OverlapTree::gather_stars() {
  const std::vector<std::uint32_t> at_point = surface_.triangles_at_points();
  if (std::none_of(at_point.begin(), at_point.end(), [](std::uint32_t n) { return n >= least_star; })) return {};
  // A triangle belongs to the star of its corner with the most triangles.
  const auto is_lesser = [&](std::uint32_t a, std::uint32_t b) {
    return at_point[a] != at_point[b] ? at_point[a] < at_point[b] : a > b;
  };
  std::vector<std::uint32_t> star_of(surface_.slots(), no_index), size(at_point.size(), 0);
  for (const Triangle& t : triangles_) {
    const auto numbers = surface_.triangle(t.slot).numbers;
    const std::uint32_t tip = *std::max_element(numbers.begin(), numbers.end(), is_lesser);
    if (at_point[tip] < least_star) continue;
    star_of[t.slot] = tip;
    ++size[tip];
  }
  // A star that kept no more triangles than a leaf holds is dissolved.
  const auto tip_of = [&](const Triangle& t) {
    const std::uint32_t tip = star_of[t.slot];
    return tip != no_index && size[tip] > leaf_size ? tip : no_index;
  };
  const auto in_stars = std::stable_partition(triangles_.begin(), triangles_.end(),
                                              [&](const Triangle& t) { return tip_of(t) == no_index; });
  std::stable_sort(in_stars, triangles_.end(),
                   [&](const Triangle& a, const Triangle& b) { return tip_of(a) < tip_of(b); });
  std::vector<Star> stars;
  for (auto i = static_cast<std::uint32_t>(in_stars - triangles_.begin()); i < triangles_.size(); ++i) {
    const std::uint32_t tip = tip_of(triangles_[i]);
    if (stars.empty() || stars.back().point != tip) stars.push_back({OverlapBox::of_nothing(), i, i, tip});
    stars.back().box.grow(triangles_[i].box);
    stars.back().last = i + 1;
  }
  return stars;
}

std::uint32_t OverlapTree::nodes_for(std::span<const Star> stars) {
  if (stars.empty()) return 0;
  auto nodes = static_cast<std::uint32_t>(stars.size()) - 1;
  for (const Star& star : stars) nodes += nodes_for(star.last - star.first);
  return nodes;
}

void OverlapTree::build(std::uint32_t node, std::uint32_t first, std::uint32_t last, const OverlapView& view,
                        unsigned threads) {
  Node& n = nodes_[node];
  n = {OverlapBox::of_nothing(), &view, node + nodes_for(last - first)};
  for (std::uint32_t i = first; i < last; ++i) n.box.grow(triangles_[i].box);
  if (last - first <= leaf_size) {
    n.first = first;
    n.count = last - first;
    return;
  }
  const OverlapView& below = view_below(first, last, view);
  if (&below != &view) look(first, last, below);
  if (last - first < least_stack || view.is_from_tip() || !is_stack(first, last))
    return divide(node, first, last, below, threads);
  OverlapView along = below;
  const Sheets sheets = sheets_in(first, last, along);
  if (sheets != Sheets::parallel)
    return divide(node, first, last, below, threads, sheets == Sheets::not_apart ? By::place : By::normal);
  const OverlapView& flat = add_view(along);
  look(first, last, flat);
  divide(node, first, last, flat, threads);
}

void OverlapTree::build_stars(std::uint32_t node, std::span<Star> stars, unsigned threads) {
  Node& n = nodes_[node];
  n = {OverlapBox::of_nothing(), &views_.front(), node + nodes_for(stars)};
  for (const Star& star : stars) n.box.grow(star.box);
  if (stars.size() == 1) {
    const OverlapView& view = add_view(view_of_star(stars[0]));
    look(stars[0].first, stars[0].last, view);
    divide(node, stars[0].first, stars[0].last, view, threads);
    return;
  }
  const std::size_t middle = stars.size() / 2;
  halve(stars, middle, [](const Star& star) { return star.first; });
  build_stars(node + 1, stars.first(middle), threads);
  build_stars(node + 1 + nodes_for(stars.first(middle)), stars.subspan(middle), threads);
}

void OverlapTree::divide(std::uint32_t node, std::uint32_t first, std::uint32_t last, const OverlapView& view,
                         unsigned threads, By by) {
  const std::uint32_t middle = first + leaf_size * ((leaf_count(last - first) + 1) / 2);
  if (by == By::normal)
    halve_by_normal(first, middle, last);
  else
    halve(std::span(triangles_).subspan(first, last - first), middle - first, [](const Triangle& t) { return t.slot; });
  const std::uint32_t left = node + 1, right = left + nodes_for(middle - first);
  for_each_part(2, threads > 1 ? 2 : 1, [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t half = begin; half < end; ++half)
      half == 0 ? build(left, first, middle, view, threads / 2) : build(right, middle, last, view, threads / 2);
  });
}

const OverlapView& OverlapTree::view_below(std::uint32_t first, std::uint32_t last, const OverlapView& view) {
  if (last - first < least_slivers || view.is_from_tip()) return view;
  double box_size = 0.0, area = 0.0;
  AlignedSum along;
  for (std::uint32_t k = 0; k < samples; ++k) {
    const NumberedTriangle t = surface_.triangle(sample(first, last, k).slot);
    box_size += static_cast<double>(sample(first, last, k).box.size());
    area += glm::length(surface_.scaled_normal(t)) / 2;
    along.add(longest_side(t));
  }
  if (!(box_size > sliver_size * area)) return view;
  const OverlapView aslant(surface_.origin(), surface_.scale(), axes_along(along.value()));
  double aslant_size = 0.0;
  for (std::uint32_t k = 0; k < samples; ++k)
    aslant_size += static_cast<double>(aslant.box_of(surface_.triangle(sample(first, last, k).slot)).size());
  return aslant_size < box_size / 2 ? add_view(aslant) : view;
}

bool OverlapTree::is_stack(std::uint32_t first, std::uint32_t last) const {
  constexpr float least_separation = 4;
  std::array<OverlapBox, samples> boxes;
  for (std::uint32_t k = 0; k < samples; ++k) boxes[k] = sample(first, last, k).box;
  return separation(boxes) < least_separation;
}

OverlapTree::Sheets OverlapTree::sheets_in(std::uint32_t first, std::uint32_t last, OverlapView& view) const {
  constexpr double least_parallel = 0.99;
  constexpr float better = 4;
  std::array<OverlapBox, samples> now, then;
  AlignedSum along;
  double size = 0.0;
  for (std::uint32_t k = 0; k < samples; ++k) {
    const glm::dvec3 normal = surface_.scaled_normal(surface_.triangle(sample(first, last, k).slot));
    along.add(normal);
    size += glm::length(normal);
    now[k] = sample(first, last, k).box;
  }
  if (!(glm::length(along.value()) >= least_parallel * size)) return Sheets::of_several_normals;
  view = OverlapView(surface_.origin(), surface_.scale(), axes_along(along.value()));
  for (std::uint32_t k = 0; k < samples; ++k) then[k] = view.box_of(surface_.triangle(sample(first, last, k).slot));
  return separation(then) > better * separation(now) ? Sheets::parallel : Sheets::not_apart;
}

void OverlapTree::halve_by_normal(std::uint32_t first, std::uint32_t middle, std::uint32_t last) {
  std::vector<glm::dvec3> normals(last - first);
  AlignedSum along;
  for (std::uint32_t i = first; i < last; ++i) {
    const glm::dvec3 normal = surface_.scaled_normal(surface_.triangle(triangles_[i].slot));
    const double length = glm::length(normal);
    normals[i - first] = length > 0.0 ? normal / length : glm::dvec3(0.0);
    along.add(normals[i - first]);
  }
  glm::dvec3 sum(0.0), squares(0.0);
  for (glm::dvec3& normal : normals) {
    if (glm::dot(normal, along.value()) < 0.0) normal = -normal;
    sum += normal;
    squares += normal * normal;
  }
  const glm::dvec3 spread = squares - sum * sum / static_cast<double>(normals.size());
  const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
  std::vector<std::pair<double, Triangle>> keyed;
  keyed.reserve(normals.size());
  for (std::uint32_t i = first; i < last; ++i) keyed.emplace_back(normals[i - first][axis], triangles_[i]);
  std::nth_element(keyed.begin(), keyed.begin() + (middle - first), keyed.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.slot < b.second.slot;
  });
  for (std::uint32_t i = first; i < last; ++i) triangles_[i] = keyed[i - first].second;
}

// Aligned with the mean normal: a flat star then maps to the equator of the octahedron and a cone to a circle around
// the pole. If the normals cancel, the sum of sign-aligned normals.
OverlapView OverlapTree::view_of_star(const Star& star) const {
  AlignedSum aligned;
  glm::dvec3 sum(0.0), tip(0.0);
  double size = 0.0;
  for (std::uint32_t i = star.first; i < star.last; ++i) {
    const NumberedTriangle t = surface_.triangle(triangles_[i].slot);
    const glm::dvec3 normal = surface_.scaled_normal(t);
    aligned.add(normal);
    sum += normal;
    size += glm::length(normal);
    for (std::size_t k = 0; k < 3; ++k)
      if (t.numbers[k] == star.point) tip = t.places[k];
  }
  const glm::dvec3 axis = glm::length(sum) > size / 8 ? sum : aligned.value();
  return OverlapView::from_tip(tip, surface_.scale(), star.point, axes_along(axis));
}

const OverlapView& OverlapTree::add_view(const OverlapView& view) {
  const std::lock_guard lock(views_change_);
  return views_.emplace_back(view);
}

void OverlapTree::look(std::uint32_t first, std::uint32_t last, const OverlapView& view) {
  stop_if_interrupted();
  for (std::uint32_t i = first; i < last; ++i) triangles_[i].box = view.box_of(surface_.triangle(triangles_[i].slot));
}

std::vector<std::uint32_t> OverlapTree::leaves_of_slots() const {
  std::vector<std::uint32_t> leaves(surface_.slots(), no_index);
  for (std::uint32_t node = 0; node < node_count(); ++node)
    for (std::uint32_t i = 0; i < nodes_[node].count; ++i) leaves[triangles_[nodes_[node].first + i].slot] = node;
  return leaves;
}

void OverlapTree::look(const Node& leaf, const OverlapView& view, Leaf& seen) const {
  seen.view = &view;
  seen.whole = OverlapBox::of_nothing();
  for (std::uint32_t i = 0; i < leaf.count; ++i) {
    const Triangle& t = triangles_[leaf.first + i];
    seen.boxes[i] = &view == leaf.view ? t.box : view.box_of(surface_.triangle(t.slot));
    seen.whole.grow(seen.boxes[i]);
  }
}

}  // namespace ryosen
