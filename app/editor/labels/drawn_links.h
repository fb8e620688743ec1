// The links of the selected element, or all halfedges in view, as arrows inside their faces, shifted from the edge so
// that twins lie side by side. What is drawn, labelled and clicked is the same list.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/base/message.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/scene/view/camera.h"

namespace ryosen {

class Findings;
class Gesturing;
class Selecting;
class Session;
struct ViewState;

// When they are drawn, in the order of the switch `links`.
enum class LinksShown : std::uint8_t { in_mode, selection, all, faces, off };

// What an arrow is to the selected element; `all` to none.
enum class LinkRole : std::uint8_t { all, trail, itself, next, prev, twin, vertex, face, around, wing, ring, normal };

struct LinkArrow {
  glm::dvec3 from{0}, to{0};  // equal for a mark at a vertex
  LinkRole role = LinkRole::all;
  Halfedge halfedge = {};    // that a click selects; none where the arrow is no halfedge
  Face on = {};              // the face it lies in
  glm::dvec3 inward{0};      // of length 1, from its edge into that face
  bool is_boundary = false;  // the halfedge or its twin has no face
  Text label = {};           // empty for none
};

// Halfedges as such arrows, where vertices are drawn at `places`, without those whose edge has no length.
std::vector<LinkArrow> arrows_of(const Mesh& mesh, const ViewState& view, std::span<const glm::dvec3> places,
                                 const std::vector<Halfedge>& halfedges);

// Kept by the session.
class DrawnLinks {
 public:
  // At most so many halfedges are drawn by `all` and `faces`: the longest on the screen, each at least so many pixels
  // long.
  static constexpr std::size_t most = 2000;
  static constexpr double least_px = 26;

  LinksShown shown = LinksShown::in_mode;

  bool is_on(const Findings& findings, const Selecting& selecting, const Gesturing& gesturing) const;
  // As the session is now; kept until it changes. Cost: with `all` and `faces` the edges, else those around the
  // selection.
  const std::vector<LinkArrow>& of(const Session& session);
  // The arrow of a halfedge that is drawn within a few pixels of a pixel of the view: neither cut off nor hidden by the
  // surface there. Null where there is none; valid until of() is asked again.
  const LinkArrow* at(Session& session, glm::dvec2 pixel);

  // A step from one halfedge to the next: the trail goes on where the last one ended, else it begins anew.
  void walked(Halfedge from, Halfedge to);
  const std::vector<Halfedge>& trail() const { return trail_; }
  // Of another mesh it means nothing.
  void forget_trail();

 private:
  // All that they depend on.
  struct Key {
    std::uint64_t serial = 0, revision = 0, hidden = 0, trail = 0;
    LinksShown shown = LinksShown::off;
    Camera camera;
    Size view;
    double scale = 1;
    std::uint64_t selection = 0;  // by its stamp
    friend bool operator==(const Key&, const Key&) = default;
  };
  std::optional<Key> key_;
  std::vector<LinkArrow> arrows_;
  std::vector<Halfedge> trail_;
  std::uint64_t trail_revision_ = 0;
};

}  // namespace ryosen
