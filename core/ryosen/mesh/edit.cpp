#include "ryosen/mesh/edit.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <utility>

#ifdef RYOSEN_CHECKED
#include "ryosen/mesh/invariants.h"
#endif

namespace ryosen {

void Edit::commit() {
#ifdef RYOSEN_CHECKED
  constexpr std::uint32_t largest_checked = 4000;
  if (std::max(mesh_.halfedge_slots(), mesh_.vertex_slots()) <= largest_checked) {
    if (const auto broken = check_invariants(mesh_)) {
      std::fprintf(stderr, "invariant broken at commit: %s\n", broken->sentence.c_str());
      std::abort();
    }
  }
#endif
#ifdef RYOSEN_PROVENANCE
  if (const auto reason = untold()) {
    std::fprintf(stderr, "values at commit: %s\n", reason->c_str());
    std::abort();
  }
#endif
  if (journal_) journal_->commit();
  open_ = false;
}

void Edit::set_copy_links(Vertex v, Vertex next, Vertex point) {
  std::vector<Vertex>& next_copy = mesh_.columns_.next_copy;
  std::vector<Vertex>& copy_point = mesh_.columns_.copy_point;
  if (next_copy.empty()) {
    next_copy.resize(mesh_.vertex_slots());
    for (std::uint32_t i = 0; i < next_copy.size(); ++i) next_copy[i] = Vertex(i);
    copy_point = next_copy;
  }
  write<Column::next_copy>(v.index, next_copy[v.index], next);
  write<Column::copy_point>(v.index, copy_point[v.index], point);
}

void Edit::add_ring(Face f, Halfedge h) {
  MeshColumns& c = mesh_.columns_;
  if (c.first_ring.empty()) c.first_ring.resize(mesh_.face_slots(), no_index);
  const auto number = static_cast<std::uint32_t>(c.rings.size());
  c.rings.push_back({h, c.first_ring[f.index]});
  write<Column::first_ring>(f.index, c.first_ring[f.index], number);
  ++c.live.rings;
}

void Edit::remove_ring(Face f, std::uint32_t ring) {
  MeshColumns& c = mesh_.columns_;
  const std::uint32_t after = c.rings[ring].next;
  if (c.first_ring[f.index] == ring) {
    write<Column::first_ring>(f.index, c.first_ring[f.index], after);
  } else {
    std::uint32_t before = c.first_ring[f.index];
    while (c.rings[before].next != ring) before = c.rings[before].next;
    write<Column::ring>(before, c.rings[before], Ring{c.rings[before].halfedge, after});
  }
  write<Column::ring>(ring, c.rings[ring], Ring{dead_halfedge, no_index});
  --c.live.rings;
}

void Edit::extend_attributes(ElementKind element, std::uint32_t count) {
  for (AttributeColumn& a : mesh_.columns_.attributes)
    if (a.element == element)
      for (std::uint32_t i = 0; i < count; ++i) a.data.insert(a.data.end(), a.fill.begin(), a.fill.end());
}

Vertex Edit::add_vertex(const glm::dvec3& position) {
  MeshColumns& c = mesh_.columns_;
  const Vertex v(c.vertex_halfedge.size());
  c.vertex_halfedge.emplace_back();
  c.positions.push_back(position);
  if (!c.next_copy.empty()) {
    c.next_copy.push_back(v);
    c.copy_point.push_back(v);
  }
  extend_attributes(ElementKind::vertex, 1);
  provenance_.creates(ElementKind::vertex, v.index);
  ++c.live.vertices;
  return v;
}

Halfedge Edit::add_edge(Vertex from, Vertex to) {
  MeshColumns& c = mesh_.columns_;
  const Halfedge h(c.halfedges.size());
  c.halfedges.push_back({from, Halfedge(), Halfedge(), Face()});
  c.halfedges.push_back({to, Halfedge(), Halfedge(), Face()});
  extend_attributes(ElementKind::edge, 1);
  extend_attributes(ElementKind::corner, 2);
  provenance_.creates(ElementKind::edge, edge(h).index);
  ++c.live.edges;
  return h;
}

Face Edit::add_face(Halfedge first) {
  MeshColumns& c = mesh_.columns_;
  const Face f(c.face_halfedge.size());
  c.face_halfedge.push_back(first);
  if (!c.first_ring.empty()) c.first_ring.push_back(no_index);
  extend_attributes(ElementKind::face, 1);
  provenance_.creates(ElementKind::face, f.index);
  ++c.live.faces;
  return f;
}

void Edit::remove(Vertex v) {
  provenance_.removes(ElementKind::vertex, v.index);
  set_halfedge(v, dead_halfedge);
  --mesh_.columns_.live.vertices;
}

void Edit::remove(Edge e) {
  provenance_.removes(ElementKind::edge, e.index);
  set_from(halfedge(e, 0), dead_from);
  --mesh_.columns_.live.edges;
}

void Edit::remove(Face f) {
  provenance_.removes(ElementKind::face, f.index);
  set_halfedge(f, dead_halfedge);
  --mesh_.columns_.live.faces;
}

std::span<const CornerAttribute> Edit::pooled() {
  if (!std::exchange(knows_pooled_, true)) pooled_ = corner_attributes(mesh_);
  return pooled_;
}

namespace {

// The words of one value; rows of many numbers alone need memory for it.
class ValueWords {
 public:
  explicit ValueWords(std::size_t count) : count_(count) {
    if (count > small_.size()) large_.resize(count);
  }
  std::span<std::uint32_t> words() {
    return large_.empty() ? std::span<std::uint32_t>(small_).first(count_) : std::span<std::uint32_t>(large_);
  }

 private:
  std::size_t count_;
  std::array<std::uint32_t, 16> small_;
  std::vector<std::uint32_t> large_;
};

}  // namespace

std::uint32_t Edit::derive_in_pool(std::size_t pool_attribute, std::span<const std::uint32_t> sources,
                                   std::span<const double> weights) {
  std::optional<std::uint32_t> one;
  bool are_equal = true, has_none = false;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (weights[i] == 0) continue;
    if (!one) one = sources[i];
    are_equal = are_equal && sources[i] == *one;
    has_none = has_none || sources[i] == no_index;
  }
  if (are_equal) return *one;
  if (has_none) return no_index;
  const AttributeColumn& pool = mesh_.columns_.attributes[pool_attribute];
  ValueWords value(pool.words());
  derive_value(pool, sources, weights, Derivation::copies, value.words());
  return append_value(pool_attribute, value.words());
}

std::vector<std::uint32_t> Edit::derived(std::size_t attribute, std::span<const std::uint32_t> sources,
                                         std::span<const double> weights, Derivation derivation) {
  const AttributeColumn& column = mesh_.columns_.attributes[attribute];
  for (const CornerAttribute& each : pooled()) {
    if (each.index_column != attribute) continue;
    std::vector<std::uint32_t> indices;
    for (const std::uint32_t source : sources) indices.push_back(column.data[source]);
    return {derive_in_pool(each.pool_column, indices, weights)};
  }
  std::vector<std::uint32_t> value(column.words());
  derive_value(column, sources, weights, derivation, value);
  return value;
}

bool Edit::derive_column(std::size_t attribute, std::uint32_t to, std::span<const std::uint32_t> sources,
                         std::span<const double> weights, Derivation derivation) {
  const AttributeColumn& column = mesh_.columns_.attributes[attribute];
  ValueWords value(column.words());
  derive_value(column, sources, weights, derivation, value.words());
  return set_attribute(attribute, to, value.words());
}

bool Edit::derive_all(ElementKind element, std::uint32_t to, std::span<const std::uint32_t> sources,
                      std::span<const double> weights, Derivation derivation) {
  const auto is_pooled = [&](std::size_t k) {
    const auto own = pooled();
    return std::any_of(own.begin(), own.end(), [&](const CornerAttribute& each) { return each.index_column == k; });
  };
  bool has_changed = false;
  for (std::size_t k = 0; k < mesh_.columns_.attributes.size(); ++k)
    if (mesh_.columns_.attributes[k].is_of(element) && !(element == ElementKind::corner && is_pooled(k)))
      has_changed |= derive_column(k, to, sources, weights, derivation);
  if (element != ElementKind::corner) return has_changed;
  std::vector<std::uint32_t> indices(sources.size());
  for (const CornerAttribute& attribute : pooled()) {
    for (std::size_t i = 0; i < sources.size(); ++i)
      indices[i] = mesh_.columns_.attributes[attribute.index_column].data[sources[i]];
    const std::uint32_t index = derive_in_pool(attribute.pool_column, indices, weights);
    has_changed |= set_attribute(attribute.index_column, to, {&index, 1});
  }
  return has_changed;
}

void Edit::blend(Vertex to, std::span<const Vertex> sources, std::span<const double> weights) {
  for (std::size_t k = 0; k < mesh_.columns_.attributes.size(); ++k) {
    const AttributeColumn& column = mesh_.columns_.attributes[k];
    if (column.is_of(ElementKind::vertex) && column.rule == ValueRule::blend && is_floating(column.type.scalar))
      derive_column(k, to.index, indices_of(sources), weights, Derivation::copies);
  }
}

bool Edit::needs_shares_to_unite(ElementKind element) const {
  const std::vector<AttributeColumn>& all = mesh_.columns_.attributes;
  return std::any_of(all.begin(), all.end(), [&](const AttributeColumn& column) {
    return column.is_of(element) &&
           ((column.rule == ValueRule::blend && is_floating(column.type.scalar)) || column.rule == ValueRule::own);
  });
}

void Edit::unite_all(ElementKind element, std::uint32_t to, std::span<const std::uint32_t> sources,
                     std::vector<double> shares) {
  double total = std::accumulate(shares.begin(), shares.end(), 0.0);
  if (!(total > 0 && std::isfinite(total))) {
    std::fill(shares.begin(), shares.end(), 1.0);
    total = static_cast<double>(shares.size());
  }
  for (double& share : shares) share /= total;
  derive_all(element, to, sources, shares, Derivation::unites);
}

bool Edit::needs_shares_to_divide(ElementKind element) const {
  const std::vector<AttributeColumn>& all = mesh_.columns_.attributes;
  return std::any_of(all.begin(), all.end(), [&](const AttributeColumn& column) {
    return column.is_of(element) && (column.rule == ValueRule::sum || column.rule == ValueRule::own);
  });
}

void Edit::divide_all(ElementKind element, std::uint32_t source, std::span<const std::uint32_t> parts,
                      std::span<const double> shares) {
  for (std::size_t k = 0; k < mesh_.columns_.attributes.size(); ++k) {
    const AttributeColumn& column = mesh_.columns_.attributes[k];
    if (!column.is_of(element)) continue;
    const std::vector<std::uint32_t> values = divide_value(column, source, shares);
    for (std::size_t i = 0; i < parts.size(); ++i)
      set_attribute(k, parts[i], std::span(values).subspan(i * column.words(), column.words()));
  }
}

void Edit::reset(ElementKind element, std::uint32_t to) {
  for (std::size_t k = 0; k < mesh_.columns_.attributes.size(); ++k)
    if (const AttributeColumn& column = mesh_.columns_.attributes[k]; column.is_of(element))
      set_attribute(k, to, column.fill);
}

void Edit::move_corners(std::span<const std::pair<Halfedge, Halfedge>> to_from) {
  for (const auto& [to, from] : to_from)
    for (const Halfedge h : {to, from}) provenance_.tells(ElementKind::corner, h.index);
  if (descent_) descent_->tell_moved(to_from);
  for (std::size_t k = 0; k < mesh_.columns_.attributes.size(); ++k) {
    const AttributeColumn& column = mesh_.columns_.attributes[k];
    if (!column.is_of(ElementKind::corner)) continue;
    const std::size_t words = column.words();
    std::vector<std::uint32_t> values;
    for (const auto& [to, from] : to_from) {
      const auto begin = column.data.begin() + static_cast<std::ptrdiff_t>(from.index * words);
      values.insert(values.end(), begin, begin + static_cast<std::ptrdiff_t>(words));
    }
    for (const auto& [to, from] : to_from) set_attribute(k, from.index, column.fill);
    std::span<const std::uint32_t> rest(values);
    for (const auto& [to, from] : to_from) {
      set_attribute(k, to.index, rest.first(words));
      rest = rest.subspan(words);
    }
  }
}

bool Edit::set_attribute(std::size_t attribute, std::uint32_t index, std::span<const std::uint32_t> words) {
  AttributeColumn& a = mesh_.columns_.attributes[attribute];
  std::uint32_t* cell = a.data.data() + std::size_t{index} * a.words();
  if (std::equal(words.begin(), words.end(), cell)) return false;
  assert(a.element != ElementKind::pool);
  const bool is_new = attribute >= attributes_before_ ||
                      index >= length_of(a.element, before_.vertices, before_.halfedges, before_.faces);
  if (journal_ && !is_new) journal_->record_value(attribute, index, cell, a.words());
  std::copy(words.begin(), words.end(), cell);
  return true;
}

std::uint32_t Edit::append_value(std::size_t pool_attribute, std::span<const std::uint32_t> words) {
  AttributeColumn& a = mesh_.columns_.attributes[pool_attribute];
  a.data.insert(a.data.end(), words.begin(), words.end());
  return static_cast<std::uint32_t>(a.data.size() / a.words() - 1);
}

std::size_t Edit::add_attribute(AttributeColumn column) {
  std::vector<AttributeColumn>& attributes = mesh_.columns_.attributes;
  assert(column.element != ElementKind::pool && mesh_.find_attribute(column.name) < 0);
  assert((column.rule == ValueRule::own) == (column.own_rule != nullptr));
  assert(column.fill.size() == column.words() && column.data.empty() && attributes.size() < most_attributes);
  const std::size_t count = length_of(column.element, mesh_.vertex_slots(), mesh_.halfedge_slots(), mesh_.face_slots());
  column.data.reserve(count * column.words());
  for (std::size_t i = 0; i < count; ++i) column.data.insert(column.data.end(), column.fill.begin(), column.fill.end());
  attributes.push_back(std::move(column));
  if (journal_) journal_->record_added(attributes.size() - 1);
  return attributes.size() - 1;
}

void Edit::remove_attribute(std::size_t attribute) {
  const auto mark = [&](std::size_t k) {
    std::uint32_t& is_removed = mesh_.columns_.attributes[k].is_removed;
    if (journal_ && k < attributes_before_)
      journal_->record(Column::attribute_removed, static_cast<std::uint32_t>(k), &is_removed, sizeof is_removed);
    is_removed = 1;
  };
  for (const CornerAttribute& each : pooled())
    if (each.index_column == attribute || each.pool_column == attribute) {
      mark(each.index_column);
      mark(each.pool_column);
    }
  mark(attribute);
  knows_pooled_ = false;
}

Descent Edit::new_descent() const { return descent_ ? Descent(mesh_) : Descent::for_checks(mesh_); }

void Edit::record(ElementKind kind, std::uint32_t to, std::span<const std::uint32_t> sources, Derivation derivation) {
  descent_->tell(kind, to, sources);
  if (derivation != Derivation::unites) return;
  for (const std::uint32_t source : sources)
    if (source != to) descent_->end(kind, source);
}

void Edit::replace(MeshColumns columns, const Descent& descent) {
#ifdef RYOSEN_PROVENANCE
  provenance_.replaces(descent.untold(mesh_.columns_, columns));
#endif
  if (descent_) descent_->follow(descent);
  swap_columns(std::move(columns));
}

void Edit::replace_by_other(MeshColumns columns) {
  if (descent_) *descent_ = Descent();
  descent_ = nullptr;
  swap_columns(std::move(columns));
}

void Edit::swap_columns(MeshColumns columns) {
  std::swap(mesh_.columns_, columns);
  if (journal_) journal_->record_replaced(std::move(columns));
}

}  // namespace ryosen
