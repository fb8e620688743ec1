// Moving, turning and scaling the selection by hand: what the pointer and the keys say becomes a transform, which only
// the view shows until it is carried out as one command.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/commands/text/command.h"
#include "app/editor/input/input.h"
#include "ryosen/algo/transform/moved_points.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/ops/op.h"
#include "ryosen/scene/pick/picker.h"
#include "ryosen/scene/view/camera.h"
#include "ryosen/scene/view/round_step.h"

namespace ryosen {

// How far from the pointer on the screen a vertex is held, or landed on, at display scale 1.
inline constexpr double snap_radius_px = 2 * pick_radius_px;

// What a movement lands on: an element, the place on it, and its name.
struct SnapTarget {
  Element element;
  glm::dvec3 place{0};
  std::string name = {};
};

class TransformGesture {
 public:
  // Begins with the points of the elements, of which there must be one, where the pointer is.
  TransformGesture(PointTransform::Kind kind, const Mesh& mesh, Elements elements, glm::dvec2 pixel);

  // Follows the pointer. With Ctrl it snaps: what is held lands on what lies under the pointer, or moves in steps of
  // the ground, as far as they can be told apart and are not too long to be of use; a turn goes in steps of 5 degrees,
  // a scaling in tenths. With Shift too the steps are a tenth of that. Pixels are those of the view.
  struct Where {
    const Camera& camera;
    Size view;
    glm::dvec2 pixel;
    bool snaps = false, is_fine = false;
    std::optional<SnapTarget> under = {};  // where it snaps
    RoundStep step = {};                   // of the ground
    double size_scale = 1;                 // of pixels
  };
  void follow(const Mesh& mesh, const Where& where);
  // X, Y, Z and N (the normal) choose an axis or let it go; with Shift a movement stays in the plane across it; digits,
  // sign and dot type the number; Backspace; O switches the falloff. False: no key of a gesture.
  bool key(const Mesh& mesh, std::string_view chord);
  // The point that lands on what a movement snaps to, one of those that are moved; else their middle does.
  void hold(const Mesh& mesh, Vertex point);
  // Widens the falloff by steps of a tenth; false where there is none.
  bool widen(const Mesh& mesh, double steps);

  // Where the points would be. Their original places are those of the mesh.
  const std::vector<MovedPoint>& moved() const { return moved_; }
  glm::dvec3 place(const Mesh& mesh, const MovedPoint& point) const {
    return transform_(mesh.position(point.point), point.share);
  }
  // The algorithm that does it, and whether it would change anything.
  AlgorithmCall call() const;
  bool does_nothing() const;
  // How far it moves everything alike; none where it does something else.
  std::optional<glm::dvec3> movement() const;
  bool is_movement() const { return kind_ == PointTransform::Kind::move; }
  // "Move X 0.25, falloff 0.5".
  Text told() const;
  // It moves what an operator or algorithm of this name makes, which calls it so; no falloff takes along what is there.
  void is_part_of(Text name) {
    called_ = std::move(name);
    takes_falloff_ = false;
  }
  bool takes_falloff() const { return takes_falloff_; }
  const Elements& elements() const { return elements_; }
  bool has_falloff() const { return falloff_ > 0; }
  double falloff() const { return falloff_; }
  glm::dvec3 middle() const { return middle_; }
  // The axis that was chosen, with its letter; whether a movement is in the plane across it. A letter of 0 is none.
  std::optional<glm::dvec3> axis() const { return axis_; }
  char axis_letter() const { return axis_letter_; }
  bool is_in_plane() const { return is_in_plane_; }
  // What it snaps to just now; null where that is no element.
  const SnapTarget* snapped_to() const { return typed_.empty() && snapped_to_ ? &*snapped_to_ : nullptr; }

 private:
  void find_moved(const Mesh& mesh);
  void follow_move(const Where& where);
  glm::dvec3 moved_by(const Where& where, const std::optional<RoundStep>& step) const;
  glm::dvec3 moved_onto(const glm::dvec3& target) const;
  glm::dvec3 moved_in_plane(const Where& where) const;
  Text told_snap() const;
  void follow_turn(const Where& where);
  void follow_scale(const Where& where);
  glm::dvec3 typed_direction() const;
  void take_number();
  void choose_axis(const Mesh& mesh, char letter, bool in_plane);

  PointTransform::Kind kind_;
  Text called_{"Move", "移動"};  // of a movement
  Elements elements_;
  std::vector<Vertex> points_;
  std::vector<MovedPoint> moved_;
  glm::dvec3 middle_{0};
  std::optional<glm::dvec3> held_;  // and the name of that point
  std::string held_name_;
  double size_ = 1;  // of the mesh
  double falloff_ = 0;
  glm::dvec2 start_;
  std::optional<glm::dvec2> last_;
  char axis_letter_ = 0;
  bool takes_falloff_ = true;
  std::optional<glm::dvec3> axis_;
  bool is_in_plane_ = false;
  std::optional<SnapTarget> snapped_to_;
  std::optional<double> step_;  // in which it moves just now
  std::string typed_;
  double turned_deg_ = 0;  // by the pointer, over several turns
  PointTransform transform_;
};

}  // namespace ryosen
