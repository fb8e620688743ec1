// Steps that the view shows one after another in the place of the document's mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/commands/text/outcomes.h"
#include "ryosen/base/element.h"
#include "ryosen/base/result.h"
#include "ryosen/scene/view/camera.h"

namespace ryosen {

class Document;
class Framing;
class Mesh;
class Shown;
struct ViewState;

// Goes through steps. The mesh of a state is shown beside the history (Shown), so that nothing of the document changes;
// an edit ends the player.
class Player {
 public:
  // A word beside an element that a step is about.
  struct Mark {
    Element element;
    std::string_view word;
  };

  Player();
  virtual ~Player() = default;

  // Unique among those of this process; never 0.
  std::uint64_t serial() const { return serial_; }
  // Arguments of the command `steps` that begin it.
  virtual const std::string& call() const = 0;
  virtual Text name() const = 0;
  virtual std::size_t size() const = 0;
  // 0 before the first step, at most size().
  std::size_t position() const { return position_; }
  void go_to(std::size_t position);
  // The step that leads to the position, in words; the name before the first one.
  virtual Text caption() const = 0;
  virtual std::vector<Mark> marks() const = 0;
  // Shows meshes of its own in place of that of the document.
  virtual bool edits() const = 0;
  // The mesh of this state; null where it is that of the document.
  virtual const Mesh* other_mesh() const = 0;
  // True where the first state is empty: the view frames the last one then.
  virtual bool begins_with_nothing() const = 0;
  // The same steps on the document as it is now, before the first one.
  virtual Result<std::shared_ptr<Player>> again(const Document& document) const = 0;

  bool is_running = false;  // a frontend goes forward from time to time
  std::optional<Camera> camera_before;
  bool was_framed = false;                // and nobody had moved that: it may need another size by now
  std::vector<glm::dvec3> places_at_end;  // that are framed instead of those of a step

 private:
  virtual void take_step() = 0;  // the position has changed

  std::uint64_t serial_;
  std::size_t position_ = 0;
};

// Begins to play. No player may be there.
void begin_playing(const Document& document, ViewState& view, Framing& framing, Shown& shown,
                   const std::shared_ptr<Player>& player);
void end_playing(ViewState& view, Framing& framing, Shown& shown);
// Ends it on request, and says so.
Outcome leave_playing(ViewState& view, Framing& framing, Shown& shown);

// Looks from where somebody looked before it was played.
void look_as_before(ViewState& view, Framing& framing, const Player& player);
Text end_of(const Player& player);

}  // namespace ryosen
