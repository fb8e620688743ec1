// Relaxation, and the values of points that have moved. First it is looked where each point would come to lie, then
// they move, those of one part of the surface beside those of others.
#include <algorithm>
#include <cmath>

#include "ryosen/algo/remesh/remesher.h"
#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/base/parallel.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/rules/corner_values.h"

namespace ryosen::remesh {

namespace {

constexpr std::size_t steps_for_each = 64;  // of a vertex, to see whether threads are worth it
constexpr unsigned at_once = 16;            // parts, or as many of the vertices, between two reports

}  // namespace

std::optional<Remesher::Relaxed> Remesher::relaxed(Vertex v, const std::vector<std::uint32_t>& parts) {
  const glm::dvec3& here = mesh_.position(v);
  glm::dvec3 sum(0), normal(0);
  double weights = 0;
  Vertex first = mesh_.to(mesh_.halfedge(v));
  bool is_within = true;
  for (const Halfedge h : outgoing(mesh_, v)) {  // counter-clockwise: the next triangle begins where this one ends
    const Vertex second = mesh_.from(mesh_.prev(h));
    const Corners c{here, mesh_.position(first), mesh_.position(second)};
    const glm::dvec3 area = area_normal(c);
    double weight = glm::length(area);
    if (target_.sizing().is_adaptive()) weight /= std::pow(wanted_[first.index] + wanted_[second.index], 2);
    sum += weight * (c[0] + c[1] + c[2]) / 3.0;
    normal += area;
    weights += weight;
    is_within &= parts[first.index] == parts[v.index] || is_fixed(first);
    first = second;
  }
  if (!(weights > 0)) return std::nullopt;
  normal = unit_or_zero(normal);
  const glm::dvec3 mean = sum / weights;
  const auto nearest = target_.nearest(mean + glm::dot(normal, here - mean) * normal, normal, nearby_[v.index]);
  if (!nearest || glm::distance(nearest->place, here) > wanted_[v.index]) return std::nullopt;
  nearby_[v.index] = nearest->triangle;
  return Relaxed{nearest->place, nearest->length, is_within ? parts[v.index] : no_index};
}

// Numbers of parts that lie together on the surface, per vertex, and how many there are.
std::pair<std::vector<std::uint32_t>, std::uint32_t> Remesher::parts_of_surface() const {
  constexpr std::uint32_t triangles_of_part = 1 << 13;
  const std::uint32_t count = target_.triangles() / triangles_of_part + 1;
  std::vector<std::uint32_t> parts(mesh_.vertex_slots(), 0);
  for (std::uint32_t i = 0; i < parts.size(); ++i)
    if (nearby_[i] != no_index) parts[i] = nearby_[i] / triangles_of_part;
  return {std::move(parts), count};
}

void Remesher::move(std::span<const Vertex> vertices, const std::vector<std::optional<Relaxed>>& found) {
  SurfaceKeeper::MoveJudge judge(keeper_);
  for (const Vertex v : vertices)
    if (try_move(v, found[v.index]->place, judge)) wanted_[v.index] = found[v.index]->length;
}

bool Remesher::relax(Progress& progress) {
  const std::uint32_t n = mesh_.vertex_slots();
  const unsigned threads = threads_for(steps_for_each * mesh_.live().vertices);
  const auto surface = parts_of_surface();
  const std::vector<std::uint32_t>& parts = surface.first;
  const std::uint32_t count = surface.second;
  std::vector<std::optional<Relaxed>> found(n);
  constexpr std::uint32_t block = 1 << 15;
  for (std::uint32_t first = 0; first < n; first += block) {
    if (!progress.go_on()) return false;
    const std::uint32_t here = std::min(block, n - first);
    for_each_task(at_once, threads, [&](unsigned i) {
      const std::uint32_t end = first + part_begin(here, i + 1, at_once);
      for (Vertex v(first + part_begin(here, i, at_once)); v.index < end; ++v.index)
        if (mesh_.is_alive(v) && !is_fixed(v)) found[v.index] = relaxed(v, parts);
    });
  }
  // No vertex within a part has a face in common with one within another, and the edit has no journal that they would
  // write to; those between parts come last.
  std::vector<std::vector<Vertex>> within(count);
  std::vector<Vertex> between;
  for (Vertex v(0); v.index < n; ++v.index)
    if (found[v.index]) (found[v.index]->part == no_index ? between : within[found[v.index]->part]).push_back(v);
  const bool is_beside = keeper_.may_move_beside();
  for (std::uint32_t first = 0; first < count; first += at_once) {
    if (!progress.go_on()) return false;
    for_each_task(std::min(at_once, count - first), is_beside ? threads : 1,
                  [&](unsigned i) { move(within[first + i], found); });
  }
  move(between, found);
  return progress.go_on();
}

namespace {

std::size_t largest(const std::array<double, 3>& weights) {
  return static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
}

std::array<Halfedge, 3> corners_of_face(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return {h, mesh.next(h), mesh.prev(h)};
}

// All of one corner.
Target::Share share_of_corner(const Mesh& mesh, Halfedge corner) {
  const Face f = mesh.face(corner);
  Target::Share share{f, {}};
  const auto corners = corners_of_face(mesh, f);
  for (std::size_t i = 0; i < 3; ++i) share.weights[i] = corners[i] == corner ? 1 : 0;
  return share;
}

// Writes what lies on faces of a mesh of triangles as it was before the edit, which has only added to its pools.
class ShareWriter {
 public:
  ShareWriter(Edit& edit, const Mesh& before) : edit_(edit), before_(before), attributes_(corner_attributes(before)) {}

  // The vertex, and all its corners alike, get the values there: linear within the face, but those that are no numbers
  // are of the corner with the largest share. A corner without a value makes it none.
  void write(Vertex v, const Target::Share& share) {
    const auto corners = corners_of_face(before_, share.face);
    write_vertex_values(v, {before_.from(corners[0]), before_.from(corners[1]), before_.from(corners[2])}, share);
    for (const CornerAttribute& attribute : attributes_) {
      const std::uint32_t index = value_of(attribute, corners, share);
      for (const Halfedge h : outgoing(edit_.mesh(), v))
        edit_.set_attribute(attribute.index_column, h.index, {&index, 1});
    }
  }

 private:
  // The nearest source comes first.
  void write_vertex_values(Vertex v, const std::array<Vertex, 3>& corners, const Target::Share& share) {
    std::array<std::uint32_t, 3> at{corners[0].index, corners[1].index, corners[2].index};
    std::array<double, 3> weights = share.weights;
    const std::size_t nearest = largest(weights);
    std::swap(at[0], at[nearest]);
    std::swap(weights[0], weights[nearest]);
    const std::size_t count = weights[0] == 1 ? 1 : 3;
    std::vector<std::uint32_t> value;
    for (std::size_t k = 0; k < before_.attributes().size(); ++k) {
      const AttributeColumn& column = before_.attributes()[k];
      if (!column.is_of(ElementKind::vertex)) continue;
      value.resize(column.words());
      derive_value(column, std::span(at).first(count), std::span(weights).first(count), Derivation::copies, value);
      edit_.set_attribute(k, v.index, value);
    }
  }

  std::uint32_t value_of(const CornerAttribute& attribute, const std::array<Halfedge, 3>& corners,
                         const Target::Share& share) {
    const std::vector<std::uint32_t>& indices = before_.attributes()[attribute.index_column].data;
    const std::array<std::uint32_t, 3> at{indices[corners[0].index], indices[corners[1].index],
                                          indices[corners[2].index]};
    return edit_.derive_in_pool(attribute.pool_column, at, share.weights);
  }

  Edit& edit_;
  const Mesh& before_;
  std::vector<CornerAttribute> attributes_;
};

// By face slot: a number that faces have in common which can be reached from each other without crossing a feature.
std::vector<std::uint32_t> charts_of(const Mesh& mesh, const Features& features) {
  DisjointSets sets(mesh.face_slots());
  for (const Edge e : live_edges(mesh)) {
    if (features.edges[e.index]) continue;
    sets.join(mesh.face(halfedge(e)).index, mesh.face(twin(halfedge(e))).index);
  }
  std::vector<std::uint32_t> charts(mesh.face_slots());
  for (std::uint32_t f = 0; f < charts.size(); ++f) charts[f] = sets.root(f);
  return charts;
}

}  // namespace

// Where on the surface as it was each vertex lies that is no feature. What features enclose stays enclosed, and a face
// that stays keeps its number: so it is known to what chart of the surface each chart of the mesh belongs, and a point
// near a seam does not take values of its other side.
std::vector<std::optional<Target::Share>> Remesher::shares(const Mesh& before) const {
  const std::vector<std::uint32_t> old_charts = charts_of(before, begun_with_), charts = charts_of(mesh_, features_);
  std::vector<std::uint32_t> old_of(mesh_.face_slots(), no_index);
  for (Face f(0); f.index < before.face_slots(); ++f.index)
    if (mesh_.is_alive(f)) old_of[charts[f.index]] = old_charts[f.index];
  std::vector<std::optional<Target::Share>> found(mesh_.vertex_slots());
  const std::uint32_t n = mesh_.vertex_slots();
  for_each_part(n, threads_for(steps_for_each * n), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (Vertex v(begin); v.index < end; ++v.index) {
      if (!mesh_.is_alive(v) || is_fixed(v)) continue;
      if (v.index < before.vertex_slots() && mesh_.position(v) == before.position(v)) {
        found[v.index] = share_of_corner(before, before.halfedge(v));
        continue;
      }
      const std::uint32_t chart = old_of[charts[mesh_.face(mesh_.halfedge(v)).index]];
      found[v.index] = target_.share(mesh_.position(v), normal_of(v), nearby_[v.index],
                                     [&](Face f) { return chart == no_index || old_charts[f.index] == chart; });
    }
  });
  return found;
}

void Remesher::share_corner_values(Vertex v) {
  const Halfedge first = mesh_.halfedge(v);
  for (const Halfedge h : outgoing(mesh_, v))
    if (h != first) edit_.derive(h, first, Derivation::copies);
}

void Remesher::take_values(const Mesh& before) {
  if (before.attributes().empty()) return;
  const auto found = shares(before);
  ShareWriter writer(edit_, before);
  for (Vertex v(0); v.index < mesh_.vertex_slots(); ++v.index)
    if (found[v.index]) writer.write(v, *found[v.index]);
  // Points that stayed keep what they had, whatever was collapsed into them.
  for (std::size_t k = 0; k < before.attributes().size(); ++k) {
    const AttributeColumn& column = before.attributes()[k];
    if (!column.is_of(ElementKind::vertex)) continue;
    for (Vertex v(0); v.index < before.vertex_slots(); ++v.index)
      if (mesh_.is_alive(v) && is_fixed(v))
        edit_.set_attribute(k, v.index,
                            std::span(column.data).subspan(std::size_t{v.index} * column.words(), column.words()));
  }
}

}  // namespace ryosen::remesh
