// Relaxation: first it is looked where each point would come to lie, then they move, those of one part of the surface
// beside those of others.
#include <cmath>

#include "ryosen/algo/remesh/remesher.h"
#include "ryosen/base/parallel.h"

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

}  // namespace ryosen::remesh
