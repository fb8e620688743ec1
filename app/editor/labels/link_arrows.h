// How the arrows of links lie in their faces, and which of them an element has.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/labels/drawn_links.h"
#include "app/editor/shown/gesturing.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

inline bool has_finite_length(const glm::dvec3& way) {
  const double squared = glm::dot(way, way);
  return std::isfinite(squared) && squared > 0;
}

// Lays arrows into the faces of the mesh as it is drawn. Both are needed as long.
class ArrowMaker {
 public:
  ArrowMaker(const Mesh& mesh, const ViewState& view, std::span<const glm::dvec3> places)
      : m_(mesh), places_(places), forward_(axes(view.camera).forward) {}

  // None where the edge has no length.
  std::optional<LinkArrow> of(Halfedge h, LinkRole role, Text label = {}) {
    const glm::dvec3 &p = place(m_.from(h)), &q = place(m_.to(h));
    if (!has_finite_length(q - p)) return std::nullopt;
    const double length = glm::length(q - p);
    const glm::dvec3 along = (q - p) / length;
    const Face f = m_.face(h), across = m_.face(twin(h));
    glm::dvec3 inward(0);
    double room = length;
    if (f || across) {
      const Frame& frame = frame_of(f ? f : across);
      inward = glm::cross(frame.normal, along);  // without a face it leads away from that of the twin
      if (f) room = frame.inradius;
    }
    if (!has_finite_length(inward)) inward = glm::cross(along, forward_);
    if (!has_finite_length(inward)) return std::nullopt;
    inward = glm::normalize(inward);
    const double shift = std::min(0.11 * length, 0.5 * room);
    double first = 0.1 * length, last = first;
    if (f) {
      first = trim(m_.from(h), m_.from(m_.prev(h)), along, shift, length);
      last = trim(m_.to(h), m_.to(m_.next(h)), -along, shift, length);
    }
    LinkArrow arrow{p + first * along + shift * inward, q - last * along + shift * inward, role, h, f, inward};
    arrow.is_boundary = !f || !across;
    arrow.label = std::move(label);
    return arrow;
  }
  glm::dvec3 normal(Face f) { return frame_of(f).normal; }
  double size(Face f) { return 2 * frame_of(f).inradius; }

 private:
  struct Frame {
    glm::dvec3 normal{0};  // of length 1, or 0
    double inradius = 0;   // of a regular polygon of this area and perimeter
  };

  const glm::dvec3& place(Vertex v) const { return places_[v.index]; }
  // How far behind a corner an arrow begins, so that it lies on the bisector of a corner that is not reflex. `along`
  // leads away from the corner, as does the way to `other`.
  double trim(Vertex corner, Vertex other, const glm::dvec3& along, double shift, double length) const {
    const double least = 0.1 * length;
    const glm::dvec3 side = place(other) - place(corner);
    if (!has_finite_length(side)) return least;
    const double cosine = std::clamp(glm::dot(along, side) / glm::length(side), -1.0, 1.0);
    const double half = std::sqrt((1 - cosine) / (1 + cosine + 1e-12));  // the tangent of half the angle
    return std::clamp(half > 0 ? shift / half : length, least, 0.4 * length);
  }

  const Frame& frame_of(Face f) {
    const auto [at, is_new] = frames_.try_emplace(f.index);
    if (!is_new) return at->second;
    const glm::dvec3& first = place(m_.from(m_.halfedge(f)));
    glm::dvec3 sum(0);
    double perimeter = 0;
    for (const Halfedge h : loop(m_, m_.halfedge(f))) {
      sum += glm::cross(place(m_.from(h)) - first, place(m_.to(h)) - first);
      perimeter += glm::length(place(m_.to(h)) - place(m_.from(h)));
    }
    if (has_finite_length(sum) && perimeter > 0) at->second = {glm::normalize(sum), glm::length(sum) / perimeter};
    return at->second;
  }

  const Mesh& m_;
  std::span<const glm::dvec3> places_;
  glm::dvec3 forward_;
  std::map<std::uint32_t, Frame> frames_;
};

// Adds the links of a living element, at most 200.
void add_links_of(const Mesh& mesh, std::span<const glm::dvec3> places, ArrowMaker& make, const Element& e,
                  std::vector<LinkArrow>& arrows);

}  // namespace ryosen
