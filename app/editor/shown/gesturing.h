// Moves, turns or scales points by hand: those of the selection, or of what an extrusion, a split or a copy has made of
// it before anything moves. While that lasts only the view changes; its end is one command. Commands that edit end it
// without one.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/editor/shown/transform_gesture.h"
#include "ryosen/base/element.h"
#include "ryosen/document/outcome.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

class Session;

class Gesturing {
 public:
  explicit Gesturing(Session& session) : session_(session) {}

  Outcome begin(PointTransform::Kind kind);
  // Does an operator with a position that can be dragged (OpDrag) and moves what it makes: one command in the end, and
  // nothing where it is given up.
  Outcome begin(const AnyOp& op);
  // The same: extrudes the selected faces, else edges; splits the edge under the tool in hand, else the selected one;
  // duplicates the selection.
  Outcome begin_extrusion();
  Outcome begin_split();
  Outcome begin_copy();

  bool is_active() const { return transform() != nullptr; }  // one goes on
  const TransformGesture* transform() const;                 // of that; null for none
  void follow(glm::dvec2 pixel, Modifiers modifiers);
  std::optional<Outcome> key(const std::string& chord);  // none: there is no gesture
  bool widen(double steps);
  Outcome end();
  Outcome give_up();  // says what it leaves
  void cancel();

  // The places of vertices as they are drawn, those of the mesh but for a gesture; the step goes up with it.
  std::span<const glm::dvec3> drawn_positions() const;
  std::uint64_t step() const { return step_; }
  // Faces that it would turn over or leave without area.
  std::span<const Face> spoilt() const;

  // For the session: what it makes is no longer on trial; there is no memory to bring the view back; the highlights
  // have been found anew.
  void forget();
  void drop() { ongoing_.reset(); }
  void judge_as_drawn();

 private:
  struct Ongoing;
  struct OngoingDeleter {
    void operator()(Ongoing* ongoing) const;
  };

  const Mesh& mesh() const;
  void begin_with(PointTransform::Kind kind, Elements elements);
  void follow_what_moves();
  void show();
  void note();
  // Problems that depend on places, of the faces that a gesture changes, as they are.
  void judge_as_is();
  void list_coincident(bool are_listed);  // of points that lie on others by what is on trial

  Session& session_;
  std::unique_ptr<Ongoing, OngoingDeleter> ongoing_;
  std::uint64_t step_ = 0;
};

}  // namespace ryosen
