#include "ryosen/algo/simplify/attribute_error.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "ryosen/algo/simplify/collapse_surface.h"
#include "ryosen/base/parallel.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

ValueSums& ValueSums::operator+=(const ValueSums& other) {
  weight += other.weight;
  for (std::size_t i = 0; i < most_channels; ++i) {
    gradients[i] += other.gradients[i];
    offsets[i] += other.offsets[i];
  }
  return *this;
}

namespace {

// A change of a colour from 0 to 1 counts with a weight of 1 as a distance of this share of the mesh's longest side:
// beyond that colours come no nearer, but distances grow.
constexpr double distance_of_colours = 0.02;

// The largest side of the box around all finite places.
double largest_side(const CollapseSurface& surface) {
  Box box;
  for (const Vertex v : live_vertices(surface.mesh()))
    if (is_finite(surface.place(v))) box.add(surface.place(v));
  if (box.is_empty()) return 0;
  const glm::dvec3 size = box.highest - box.lowest;
  return std::max({size.x, size.y, size.z});
}

// Adds the squares of the mean of the sums, `sign` times: of one triangle these are all its squares.
void add_squares_of_mean(Quadric& sum, const ValueSums& sums, std::size_t channels, double sign) {
  if (!(sums.weight > 0)) return;
  const double share = sign / sums.weight;
  for (std::size_t i = 0; i < channels; ++i) {
    const glm::dvec3& g = sums.gradients[i];
    const glm::dvec3 shared = share * g;
    sum.xx += shared.x * g.x;
    sum.xy += shared.x * g.y;
    sum.xz += shared.x * g.z;
    sum.yy += shared.y * g.y;
    sum.yz += shared.y * g.z;
    sum.zz += shared.z * g.z;
    sum.b += sums.offsets[i] * shared;
    sum.c += share * sums.offsets[i] * sums.offsets[i];
  }
}

std::array<glm::dvec3, 3> places_of(const CollapseSurface& surface, Halfedge corner) {
  const Mesh& mesh = surface.mesh();
  return {surface.place(mesh.from(corner)), surface.place(mesh.to(corner)),
          surface.place(mesh.from(mesh.prev(corner)))};
}

}  // namespace

std::optional<AttributeError> AttributeError::of(const CollapseSurface& surface, double weight) {
  if (!(weight > 0)) return std::nullopt;
  AttributeError error(surface.mesh(), weight);
  error.find_colours(surface);
  error.find_texture(surface);
  if (!error.colour_ && !error.texture_) return std::nullopt;
  error.sum_gradients(surface);
  return error;
}

std::optional<AttributeError::Attribute> AttributeError::varying(std::string_view column, std::uint32_t rows,
                                                                 double factor) const {
  const int found = mesh_.find_attribute(column);
  if (found < 0 || !(factor > 0)) return std::nullopt;
  Attribute attribute;
  attribute.column = static_cast<std::size_t>(found);
  attribute.factor = factor;
  const AttributeColumn& values = mesh_.attributes()[attribute.column];
  const std::uint32_t channels = std::min<std::uint32_t>(values.type.count, ValueSums::most_channels);
  for (std::uint32_t channel = 0; channel < channels; ++channel) {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (std::uint32_t row = 0; row < rows; ++row) {
      const double number = number_at(values, row, channel);
      if (!std::isfinite(number)) continue;
      lowest = std::min(lowest, number);
      highest = std::max(highest, number);
    }
    if (!(lowest < highest)) continue;
    attribute.lowest[attribute.channels.size()] = lowest;
    attribute.highest[attribute.channels.size()] = highest;
    attribute.channels.push_back(channel);
  }
  return attribute.channels.empty() ? std::nullopt : std::optional(attribute);
}

void AttributeError::find_colours(const CollapseSurface& surface) {
  if (mesh_.find_attribute(attribute_names::colour) < 0) return;
  colour_ =
      varying(attribute_names::colour, mesh_.vertex_slots(), weight_ * distance_of_colours * largest_side(surface));
}

// It is scaled by the root of the areas of the surface and its texture.
void AttributeError::find_texture(const CollapseSurface& surface) {
  const int index = mesh_.find_attribute(attribute_names::texcoord),
            pool = mesh_.find_attribute(attribute_names::texcoord_pool);
  if (index < 0 || pool < 0) return;
  chart_column_ = static_cast<std::size_t>(index);
  const AttributeColumn& values = mesh_.attributes()[static_cast<std::size_t>(pool)];
  double area = 0, texture_area = 0;
  for (const Face f : live_faces(mesh_)) {
    const Halfedge corner = mesh_.halfedge(f);
    const std::array<std::uint32_t, 3> charts{chart(corner), chart(mesh_.next(corner)), chart(mesh_.prev(corner))};
    if (std::find(charts.begin(), charts.end(), no_index) != charts.end()) continue;
    const auto [p, q, r] = places_of(surface, corner);
    const auto value = [&](std::size_t i) { return attribute_value<glm::dvec3>(values, charts[i]); };
    const glm::dvec3 u = value(1) - value(0), v = value(2) - value(0);
    const double own = glm::length(glm::cross(q - p, r - p)), own_texture = std::abs(u.x * v.y - u.y * v.x);
    if (!std::isfinite(own) || !std::isfinite(own_texture)) continue;
    area += own;
    texture_area += own_texture;
  }
  if (!(texture_area > 0)) return;
  texture_ = varying(attribute_names::texcoord_pool, static_cast<std::uint32_t>(values.data.size() / values.words()),
                     weight_ * std::sqrt(area / texture_area));
}

ValueSums AttributeError::sums_of(const std::array<glm::dvec3, 3>& corners, const Attribute& attribute,
                                  const std::array<std::uint32_t, 3>& values) const {
  const glm::dvec3 u = corners[1] - corners[0], v = corners[2] - corners[0], normal = glm::cross(u, v);
  const double square = glm::dot(normal, normal);
  if (!(square > 0) || std::find(values.begin(), values.end(), no_index) != values.end()) return {};
  // A value that grows by a along u and by b along v has the gradient a times along_u and b times along_v.
  const glm::dvec3 along_u = glm::cross(v, normal) / square, along_v = glm::cross(normal, u) / square;
  const AttributeColumn& column = mesh_.attributes()[attribute.column];
  ValueSums sums{std::sqrt(square)};
  for (std::size_t i = 0; i < attribute.channels.size(); ++i) {
    const auto number = [&](std::size_t corner) {
      return attribute.factor * number_at(column, values[corner], attribute.channels[i]);
    };
    const double here = number(0);
    const glm::dvec3 gradient = (number(1) - here) * along_u + (number(2) - here) * along_v;
    const double offset = here - glm::dot(gradient, corners[0]);
    if (!std::isfinite(offset)) return {};
    sums.gradients[i] = sums.weight * gradient;
    sums.offsets[i] = sums.weight * offset;
  }
  return sums;
}

void AttributeError::sum_gradients_at(const CollapseSurface& surface, Vertex v, std::vector<Wedge>& wedges) {
  const std::size_t first = wedges.size();
  for (const Halfedge corner : outgoing(mesh_, v)) {
    if (mesh_.is_outside(corner)) continue;
    const Halfedge next = mesh_.next(corner), prev = mesh_.prev(corner);
    const std::array<glm::dvec3, 3> places = places_of(surface, corner);
    if (colour_) {
      const ValueSums sums = sums_of(places, *colour_, {v.index, mesh_.to(corner).index, mesh_.from(prev).index});
      add_squares_of_mean(quadrics_[v.index], sums, colour_->channels.size(), 1);
      colours_[v.index] += sums;
    }
    if (!texture_) continue;
    const ValueSums sums = sums_of(places, *texture_, {chart(corner), chart(next), chart(prev)});
    if (!(sums.weight > 0)) continue;
    add_squares_of_mean(quadrics_[v.index], sums, texture_->channels.size(), 1);
    const auto same = std::find_if(wedges.begin() + static_cast<std::ptrdiff_t>(first), wedges.end(),
                                   [&](const Wedge& wedge) { return wedge.chart == chart(corner); });
    if (same == wedges.end())
      wedges.push_back({chart(corner), v.index, sums});  // `next` keeps the vertex until all are linked
    else
      same->sums += sums;
  }
}

void AttributeError::sum_gradients(const CollapseSurface& surface) {
  const std::uint32_t slots = mesh_.vertex_slots();
  quadrics_.resize(slots);
  if (colour_) colours_.resize(slots);
  if (texture_) first_wedges_.assign(slots, no_index);
  const unsigned threads = threads_for(slots);
  std::vector<std::vector<Wedge>> wedges_of_parts(threads);
  for_each_part(slots, threads, [&](unsigned part, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i)
      if (const Vertex v(i); mesh_.is_alive(v) && !mesh_.is_isolated(v))
        sum_gradients_at(surface, v, wedges_of_parts[part]);
  });
  for (const std::vector<Wedge>& part : wedges_of_parts)
    for (const Wedge& wedge : part) {
      const Vertex v(wedge.next);
      wedges_.push_back({wedge.chart, first_wedges_[v.index], wedge.sums});
      first_wedges_[v.index] = static_cast<std::uint32_t>(wedges_.size() - 1);
    }
}

Quadric AttributeError::of_edge(Halfedge h) const {
  const std::uint32_t a = mesh_.from(h).index, b = mesh_.to(h).index;
  Quadric sum = quadrics_[a] + quadrics_[b];
  sum.weight = sum.c;
  if (colour_) {
    ValueSums colours = colours_[a];
    add_squares_of_mean(sum, colours += colours_[b], colour_->channels.size(), -1);
  }
  if (texture_) subtract_charts(sum, h);
  return sum;
}

// The charts on either side of the edge go on as one, those elsewhere around an end by themselves.
void AttributeError::subtract_charts(Quadric& sum, Halfedge h) const {
  std::array<std::array<std::uint32_t, 2>, 2> sides{};  // by side the charts at both ends
  sides[0] = {chart(h), mesh_.is_outside(h) ? no_index : chart(mesh_.next(h))};
  sides[1] = {mesh_.is_outside(twin(h)) ? no_index : chart(mesh_.next(twin(h))), chart(twin(h))};
  const bool are_one = sides[0][0] == sides[1][0] || sides[0][1] == sides[1][1];
  const std::size_t channels = texture_->channels.size();
  std::array<ValueSums, 2> joined;
  for (const std::size_t end : {0u, 1u}) {
    const Vertex v = end == 0 ? mesh_.from(h) : mesh_.to(h);
    for (std::uint32_t i = first_wedges_[v.index]; i != no_index; i = wedges_[i].next) {
      const Wedge& wedge = wedges_[i];
      if (wedge.chart == sides[0][end])
        joined[0] += wedge.sums;
      else if (wedge.chart == sides[1][end])
        joined[are_one ? 0 : 1] += wedge.sums;
      else
        add_squares_of_mean(sum, wedge.sums, channels, -1);
    }
  }
  for (const ValueSums& sums : joined) add_squares_of_mean(sum, sums, channels, -1);
}

AttributeError::Charts AttributeError::charts_around(Halfedge h) const {
  Charts charts;
  if (!texture_) return charts;
  for (const Halfedge end : {h, twin(h)})
    for (const Halfedge corner : outgoing(mesh_, mesh_.from(end))) charts.emplace_back(corner, chart(corner));
  return charts;
}

void AttributeError::follow(const Charts& before, Halfedge h) {
  if (!texture_) return;
  for (const Halfedge end : {h, twin(h)}) {
    const Vertex v = mesh_.from(end);
    for (std::uint32_t i = first_wedges_[v.index]; i != no_index; i = wedges_[i].next)
      for (const auto& [corner, was] : before)
        if (was == wedges_[i].chart && mesh_.from(corner) == v) {
          wedges_[i].chart = chart(corner);
          break;
        }
  }
}

void AttributeError::give(Vertex v, std::uint32_t wedge) {
  for (std::uint32_t i = first_wedges_[v.index]; i != no_index; i = wedges_[i].next)
    if (wedges_[i].chart == wedges_[wedge].chart) {
      wedges_[i].sums += wedges_[wedge].sums;
      return;
    }
  wedges_[wedge].next = first_wedges_[v.index];
  first_wedges_[v.index] = wedge;
}

void AttributeError::merge(Vertex gone, Vertex kept) {
  quadrics_[kept.index] += quadrics_[gone.index];
  if (colour_) colours_[kept.index] += colours_[gone.index];
  if (!texture_) return;
  std::uint32_t next = first_wedges_[kept.index];
  first_wedges_[kept.index] = no_index;
  for (const std::uint32_t others : {next, first_wedges_[gone.index]})
    for (std::uint32_t i = others; i != no_index; i = next) {
      next = wedges_[i].next;
      give(kept, i);
    }
  first_wedges_[gone.index] = no_index;
}

void AttributeError::add_copy(Vertex of) {
  quadrics_.push_back(Quadric(quadrics_[of.index]));
  if (colour_) colours_.push_back(ValueSums(colours_[of.index]));
  if (!texture_) return;
  first_wedges_.push_back(no_index);
  const Vertex copy(static_cast<std::uint32_t>(first_wedges_.size() - 1));
  for (std::uint32_t i = first_wedges_[of.index]; i != no_index; i = wedges_[i].next) {
    wedges_.push_back(Wedge(wedges_[i]));
    give(copy, static_cast<std::uint32_t>(wedges_.size() - 1));
  }
}

void AttributeError::write(Edit& edit, Vertex v, const ValueSums& sums, const glm::dvec3& place) const {
  if (!(sums.weight > 0)) return;
  const AttributeColumn& column = mesh_.attributes()[colour_->column];
  auto colour = attribute_value<glm::dvec4>(column, v.index);
  for (std::size_t i = 0; i < colour_->channels.size(); ++i) {
    const double best = (glm::dot(sums.gradients[i], place) + sums.offsets[i]) / (sums.weight * colour_->factor);
    colour[static_cast<int>(colour_->channels[i])] = std::clamp(best, colour_->lowest[i], colour_->highest[i]);
  }
  edit.set_attribute(colour_->column, v.index, attribute_words(colour));
}

void AttributeError::write_colours(Edit& edit, Halfedge h, const glm::dvec3& place) const {
  if (!colour_) return;
  const Vertex a = mesh_.from(h), b = mesh_.to(h);
  ValueSums sums = colours_[a.index];
  sums += colours_[b.index];
  write(edit, a, sums, place);
  write(edit, b, sums, place);
}

void AttributeError::write_colours(Edit& edit, Vertex v, const glm::dvec3& place) const {
  if (colour_) write(edit, v, colours_[v.index], place);
}

}  // namespace ryosen
