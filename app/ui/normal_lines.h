// The overlay of normals: lines from the vertices or the middles of faces along them.
#pragma once

#include <cstdint>
#include <vector>

#include "app/editor/document/change_feed.h"
#include "render/renderer.h"
#include "ryosen/scene/view/view_settings.h"

namespace ryosen {

struct SeenMesh;

// At a vertex one line for each normal that smooth shading has there: several at creases. Drawn in blocks of elements,
// those that changed alone.
class NormalLines {
 public:
  // What changed in the mesh since the last call of follow().
  void note(const SeenMesh& seen, const ChangeFeed::Changes& changes, std::span<const std::uint32_t> triangles,
            bool everything);
  // Passes the lines to the renderer. Linear where the setting or the whole mesh is another.
  void follow(const SeenMesh& seen, Renderer& renderer);

 private:
  Overlay block(const SeenMesh& seen, std::uint32_t number) const;

  Normals drawn_ = Normals::off;
  Theme theme_ = Theme::dark;
  bool all_stale_ = true;
  double length_ = 0;
  std::vector<std::uint32_t> stale_;  // blocks
};

}  // namespace ryosen
