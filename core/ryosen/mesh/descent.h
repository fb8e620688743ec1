// The elements that the elements of a mesh come from, told by the edits in between.
//
//   Descent descent(mesh);
//   Edit edit(mesh, &journal, &descent);   the face f0 is cut into f0 and f1
//   descent.origin(Face(1))                is f0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/source_list.h"

namespace ryosen {

// Whether the columns have this element, alive; a corner, where its halfedge has a face.
bool is_there(const MeshColumns& columns, ElementKind kind, std::uint32_t index);
// The name of an element in messages: "f3", "corner h5".
std::string name_of(ElementKind kind, std::uint32_t index);

// An element keeps its origin as long as it lives. A new one has the origin of its only source, or that of all its
// sources where they have the same; else it has none, and gets none later. Vertices and corners are recorded in test
// builds alone, which check them; the origin of a corner, the halfedge that leaves its vertex along its face, changes
// with its values.
class Descent {
 public:
  // Records nothing.
  Descent() = default;
  // The elements of this mesh are their own origins.
  explicit Descent(const Mesh& mesh);
  // The same in test builds, which check what is told; elsewhere it records nothing.
  static Descent for_checks(const Mesh& mesh);

#ifdef RYOSEN_PROVENANCE
  static constexpr bool is_checked = true;
#else
  static constexpr bool is_checked = false;
#endif
  static constexpr bool records(ElementKind kind) {
    return is_checked || kind == ElementKind::edge || kind == ElementKind::face;
  }

  bool is_recording() const { return is_recording_; }
  // The element before that this one is or is a part of; none where it has no origin.
  Edge origin(Edge e) const { return Edge(origin(ElementKind::edge, e.index)); }
  Face origin(Face f) const { return Face(origin(ElementKind::face, f.index)); }
  // An edge counts as new from here on, and the one that it was as dropped.
  void lose(Edge e);

  // An edit tells the sources of an element; one without sources is new. O(sources).
  void tell(ElementKind kind, std::uint32_t to, std::span<const std::uint32_t> sources);
  // The same of corners that move, all at once: the first of each pair comes from the second. Corners that are only
  // second are new.
  void tell_moved(std::span<const std::pair<Halfedge, Halfedge>> to_from);
  // An element is united with another or dropped.
  void end(ElementKind kind, std::uint32_t index);
  // All elements are replaced, or those of one kind: `next` tells where the new ones come from. O(elements).
  void follow(const Descent& next);
  void follow(ElementKind kind, const SourceList& next);

  // A sentence on an element of `after` whose sources were not told, or on one of `before` that became nothing and was
  // neither united nor dropped. O(elements).
  std::optional<std::string> untold(const MeshColumns& before, const MeshColumns& after) const;

 private:
  static constexpr std::uint32_t untold_origin = no_index - 1;
  struct Kind {
    std::vector<std::uint32_t> origins;  // no_index where there is none
    std::vector<bool> ended;             // by index before
  };

  Kind& of(ElementKind kind) { return kinds_[static_cast<std::size_t>(kind)]; }
  std::uint32_t origin(ElementKind kind, std::uint32_t index) const {
    return is_told(kind, index) ? kinds_[static_cast<std::size_t>(kind)].origins[index] : no_index;
  }
  bool is_told(ElementKind kind, std::uint32_t index) const {
    const std::vector<std::uint32_t>& origins = kinds_[static_cast<std::size_t>(kind)].origins;
    return index < origins.size() && origins[index] != untold_origin;
  }
  void set_origin(ElementKind kind, std::uint32_t index, std::uint32_t origin);

  std::array<Kind, 4> kinds_;
  bool is_recording_ = false;
};

// The elements that these elements of the mesh before have become, in the order of these; a vertex keeps its number.
// Halves of edges become those of the parts on the same side. O(result), and what is found by a logarithm.
std::vector<Element> descended(const Mesh& mesh, const Descent& descent, std::span<const Element> elements);

}  // namespace ryosen
