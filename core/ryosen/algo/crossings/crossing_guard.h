// Keeps a surface of triangles free of self-intersections while its edges collapse and swap and its vertices move:
// exactly, in the sense of find_self_intersections.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "ryosen/algo/crossings/near_faces.h"
#include "ryosen/analysis/box_tree.h"
#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/triangle_corners.h"

namespace ryosen {

// Boxes, each of two parts of the surface that met there.
class MetPlaces {
 public:
  struct Place {
    Box box;
    std::uint32_t part, other;
  };

  MetPlaces() = default;
  // With a part for each face slot.
  MetPlaces(std::vector<std::uint32_t> parts, const std::vector<Place>& places) : parts_(std::move(parts)) {
    std::vector<Box> boxes;
    for (const Place& place : places) {
      boxes.push_back(place.box);
      owners_.push_back({place.part, place.other});
      pairs_.insert(key(place.part, place.other));
    }
    boxes_ = BoxTree(std::move(boxes));
  }

  bool is_empty() const { return boxes_.is_empty(); }
  const std::vector<std::uint32_t>& parts() const { return parts_; }
  bool have_met(std::uint32_t part, std::uint32_t other) const { return pairs_.contains(key(part, other)); }
  // Whether a triangle of a part lies in one of its boxes: what it has in common with any other one lies there too.
  // O(log n) and the boxes around it, as the next.
  bool enclose(const Box& triangle, std::uint32_t part) const {
    return !boxes_.visit([&](const Box& box) { return box.encloses(triangle); },
                         [&](std::uint32_t i) { return owners_[i][0] != part && owners_[i][1] != part; });
  }
  // Whether the middle of what two triangles have in common lies in any.
  bool hold(const TriangleCorners& a, const TriangleCorners& b) const {
    const glm::dvec3 middle = common_box(a, b).middle();
    const Box place{middle, middle};
    return !boxes_.visit([&](const Box& box) { return box.encloses(place); }, [](std::uint32_t) { return false; });
  }

 private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32u | std::max(a, b);
  }

  BoxTree boxes_;
  std::vector<std::array<std::uint32_t, 2>> owners_;  // of each box
  std::vector<std::uint32_t> parts_;
  std::unordered_set<std::uint64_t> pairs_;
};

class CrossingGuard {
 public:
  // Guards a mesh of triangles. O(n log n).
  explicit CrossingGuard(const Mesh& mesh) : CrossingGuard(mesh, nowhere()) {}
  // Guards one in which parts meet at some places, which outlive the guard: there they may go on meeting. Where faces
  // meet elsewhere, a step may make as many such pairs as it takes away.
  CrossingGuard(const Mesh& mesh, const MetPlaces& met)
      : mesh_(mesh),
        met_(met),
        parts_(met.parts()),
        allowed_(met.is_empty() ? Allowed::none : Allowed::as_many),
        faces_(mesh) {}
  // From here on a step may make as many pairs that meet as it takes away, wherever they are.
  void count() { allowed_ = Allowed::as_many; }
  // From here on a collapse may leave no more pairs that meet than there were, and each comes from one that met before
  // it: a face comes from itself, and from a face that goes and has a side in common with it.
  //
  //       w          The collapse of u to v takes the face u v w away, and its sides u w and v w become one. So the
  //    a / \ b      faces a and b beside it take its place, and what met it may meet one of them. A step whose faces
  //     u---v        would be in more than 1,000 such pairs is refused.
  void inherit() { allowed_ = Allowed::inherited; }

  // Whether faces would meet elsewhere than at what they share if from(h) became to(h) there. A face that would lose
  // its area counts too. Cost: n log n of the faces around both ends and those near them.
  bool would_meet(Halfedge h, const glm::dvec3& position) const;
  // The same if v moved there.
  bool would_meet(Vertex v, const glm::dvec3& position) const;
  // The same if the edge of h, between two triangles, were swapped.
  bool would_meet_swapped(Halfedge h) const;
  // The same if it were split there, in all its sheets.
  bool would_meet_split(Halfedge h, const glm::dvec3& position) const;

  // The vertex stands for another one too, and has come to its place, or has new faces: those around it are up to date.
  void follow(Vertex kept);
  // It has moved, and that is all.
  void follow_move(Vertex moved) { faces_.follow_move(moved); }
  // A face that has other corners.
  void follow(Face f) { faces_.follow(f); }
  // A face that is gone.
  void forget(Face f) { faces_.forget(f); }

  // How many faces it has found near those that a step would change.
  std::uint64_t looks() const { return looks_; }

 private:
  struct Changed {
    Face face;
    NumberedTriangle triangle;
    Box box = box_of(triangle.places);
  };
  // A face that goes, and one beside it that stays.
  struct Heir {
    Face gone, heir;
  };
  // What a step does: faces that change, and those that go.
  struct Step {
    std::vector<Changed> changed;
    std::vector<Face> gone;
    std::vector<Heir> heirs;  // of those that go
    // By face: the number of the step that it was last of.
    std::vector<std::uint32_t> last;
    std::uint32_t number = 0;

    void begin(std::uint32_t face_slots);
    void mark(Face f) { last[f.index] = number; }
    bool concerns(Face f) const { return last[f.index] == number; }
  };

  // Pairs that may meet where others did before a step.
  enum class Allowed { none, as_many, inherited };
  static constexpr std::size_t few = 64, most_compared = 1000;  // faces, and pairs

  static const MetPlaces& nowhere();
  NumberedTriangle triangle(Face f) const { return triangle(mesh_.halfedge(f)); }
  // The triangle at a halfedge, from its start on.
  NumberedTriangle triangle(Halfedge h) const;
  void begin() const;
  void change(const NumberedTriangle& t, Face f) const;
  // The face of a side of an edge that collapses.
  void remove(Halfedge side) const;
  bool would_meet() const;
  // The faces that change and go, as they are before the step.
  std::vector<Changed> before() const;
  // Whether more pairs would meet than before.
  bool adds() const;
  // Whether each pair that would meet comes from one that does, and they become no more.
  bool inherits() const;
  bool is_inherited(Face a, Face b) const;
  // Whether two triangles meet elsewhere than at what they share, and than where their parts met before.
  bool meet(const Changed& a, const Changed& b) const;
  // How many pairs of faces one of which is among these do, at most so many.
  std::size_t meetings(const std::vector<Changed>& faces, std::size_t most) const;
  // Calls visit(one, other) for each, until it returns false; then so does this.
  template <class Visit>
  bool visit_meetings(const std::vector<Changed>& faces, const Visit& visit) const;
  // The same of very many, by a tree.
  template <class Visit>
  bool visit_meetings_by_tree(const std::vector<Changed>& faces, const Visit& visit) const;
  void find_near(const std::vector<Changed>& faces) const;

  const Mesh& mesh_;
  const MetPlaces& met_;
  std::vector<std::uint32_t> parts_;  // by face; empty where none met
  Allowed allowed_;
  mutable NearFaces faces_;
  // Of the step that is judged.
  mutable Step step_;
  mutable bool loses_area_ = false;
  mutable std::vector<Changed> near_;
  mutable std::vector<NumberedTriangle> asked_;
  mutable std::vector<Face> found_;
  mutable std::uint64_t looks_ = 0;
};

}  // namespace ryosen
