#include "app/ui/normal_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/document/findings.h"
#include "app/editor/views/seen_mesh.h"
#include "render/palette.h"
#include "ryosen/analysis/measures.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/scene/view/packed_normal.h"

namespace ryosen {

namespace {

constexpr std::uint32_t block_slots = 512;

std::uint32_t slots_of(const Mesh& mesh, Normals which) {
  return which == Normals::faces ? mesh.face_slots() : mesh.vertex_slots();
}

// What smooth shading has at the vertex, each once.
std::vector<std::uint32_t> normals_at(Findings& findings, Vertex v) {
  const Mesh& mesh = findings.mesh();
  const CornerNormals& normals = findings.corner_normals();
  const SurfaceTriangles& triangles = findings.picker().triangles();
  std::vector<std::uint32_t> packed;
  for (const Face f : faces_around(mesh, v)) {
    if (f.is_none() || findings.hidden().hides(mesh, f)) continue;
    for (const std::uint32_t slot : triangles.slots_of(mesh, f)) {
      const SurfaceTriangle triangle = triangles.at(mesh, slot);
      for (std::size_t k = 0; k < 3; ++k)
        if (triangle.corners[k] == v.index) packed.push_back(normals.packed()[slot][k]);
    }
  }
  sort_unique(packed);
  return packed;
}

}  // namespace

void NormalLines::note(const SeenMesh& seen, const ChangeFeed::Changes& changes, std::span<const std::uint32_t> slots,
                       bool everything) {
  all_stale_ |= everything;
  if (drawn_ == Normals::off || all_stale_) return;
  const auto add = [&](std::uint32_t slot) { stale_.push_back(slot / block_slots); };
  if (drawn_ == Normals::faces)
    for (const std::uint32_t f : changes.faces) add(f);
  else
    for (const std::uint32_t v : changes.vertices) add(v);
  const SurfaceTriangles& triangles = seen.findings.picker().triangles();
  for (const std::uint32_t slot : slots) {
    if (slot >= triangles.slots()) continue;
    const SurfaceTriangle triangle = triangles.at(seen.findings.mesh(), slot);
    if (triangle.face == no_index) continue;
    if (drawn_ == Normals::faces)
      add(triangle.face);
    else
      for (const std::uint32_t v : triangle.corners) add(v);
  }
}

Overlay NormalLines::block(const SeenMesh& seen, std::uint32_t number) const {
  Findings& findings = seen.findings;
  const Mesh& mesh = findings.mesh();
  const std::span<const glm::dvec3> places = seen.places;
  const Rgba colour = with_alpha(palette(theme_).label, 190);
  const std::uint32_t end = std::min((number + 1) * block_slots, slots_of(mesh, drawn_));
  Overlay overlay;
  const auto draw = [&](const glm::dvec3& from, const glm::dvec3& along) {
    if (along == glm::dvec3(0)) return;
    overlay.lines.push_back({from, from + length_ * along, colour, LineStyle::solid, 1.2f, 0});
  };
  Neighbourhood around(mesh);
  for (std::uint32_t i = number * block_slots; i < end; ++i) {
    if (drawn_ == Normals::vertices) {
      const Vertex v(i);
      if (!mesh.is_alive(v) || findings.hidden().hides(mesh, v)) continue;
      for (const std::uint32_t packed : normals_at(findings, v)) draw(places[i], unpacked_normal(packed));
    } else {
      const Face f(i);
      if (!mesh.is_alive(f) || findings.hidden().hides(mesh, f)) continue;
      glm::dvec3 sum(0);
      double corners = 0;
      for (const Vertex v : vertices_around(mesh, f)) sum += places[v.index], ++corners;
      draw(sum / corners, around.normal(f));
    }
  }
  return overlay;
}

void NormalLines::follow(const SeenMesh& seen, Renderer& renderer) {
  const ViewSettings& settings = seen.view.settings;
  const Mesh& mesh = seen.findings.mesh();
  all_stale_ |= drawn_ != settings.normals || theme_ != settings.theme;
  if (all_stale_) {
    if (drawn_ != Normals::off || settings.normals != Normals::off) renderer.set_overlay(Layer::normals, {});
    stale_.clear();
    if (settings.normals != Normals::off) {
      length_ = 0.5 * mean_edge_length(mesh);
      for (std::uint32_t i = 0; i * block_slots < slots_of(mesh, settings.normals); ++i) stale_.push_back(i);
    }
  }
  drawn_ = settings.normals;
  theme_ = settings.theme;
  all_stale_ = false;
  sort_unique(stale_);
  for (const std::uint32_t number : stale_) renderer.set_overlay_part(Layer::normals, number, block(seen, number));
  stale_.clear();
}

}  // namespace ryosen
