// The overlay of the verdicts of the tool in hand on all elements that it acts on.
#pragma once

#include <cstdint>

#include "render/renderer.h"
#include "ryosen/ops/preview/tool_verdicts.h"

namespace ryosen {

class Findings;
class Gesturing;
class Session;

// Drawn in blocks of elements: at first so many of them in a frame as cost few milliseconds, where the session asks in
// slices too, and shown when all are there; after an edit those with an element that was asked again.
class VerdictLayer {
 public:
  // All are drawn anew: something is hidden or shown, or it has another mesh.
  void forget() { is_stale_ = true; }
  // Passes to the renderer what has changed.
  void follow(Session& session, Renderer& renderer);
  // More is to be passed in the next frame, or to be asked before it.
  bool is_waiting() const { return is_waiting_; }

 private:
  void begin(Session& session, Renderer& renderer, const ToolVerdicts* verdicts);
  // Drops what an undo has taken away, and forgets a block that was or is not full.
  void follow_slots(Renderer& renderer, std::uint32_t slots);
  void draw_block(Findings& findings, const Gesturing& gesturing, Renderer& renderer, const ToolVerdicts& verdicts,
                  std::uint32_t block) const;

  bool is_stale_ = true, is_waiting_ = false;
  std::uint64_t serial_ = 0;  // of the verdicts that are drawn; 0 for none
  Theme theme_ = Theme::dark;
  std::uint32_t drawn_ = 0, slots_ = 0;  // blocks, and how many elements there were
  double room_ = 0;                      // of points
};

}  // namespace ryosen
