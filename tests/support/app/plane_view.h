// A small view of a mesh in the plane: from above, with its edges as lines. It shows that another kind of view needs
// nothing of the one in space: hover, selection and changes come by the session.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "app/editor/document/change_feed.h"
#include "app/editor/views/view.h"
#include "render/image.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {
class Session;
}

namespace ryosen::test {

class PlaneView final : public View {
 public:
  static constexpr Rgba ground{20, 20, 20, 255}, line{90, 90, 90, 255}, selected{250, 150, 0, 255},
      hovered{0, 200, 250, 255};

  // The square from `low` on, so long a side, is what it shows. It is one of the session's views until it ends.
  PlaneView(Session& session, glm::dvec2 origin, Size size, glm::dvec2 low, double side);
  ~PlaneView() override;
  PlaneView(const PlaneView&) = delete;
  PlaneView& operator=(const PlaneView&) = delete;

  const Document& document() const override;
  bool contains(glm::dvec2 pixel) const override;
  std::optional<Picked> pick(glm::dvec2 pixel, PickMode what, double radius_px) override;

  // Takes what changed since the last call.
  void follow();
  Image draw() const;
  std::size_t rebuilds() const { return rebuilds_; }
  // The pixel, of the picture that all views share, of a place.
  glm::dvec2 pixel_of(glm::dvec2 place) const;

 private:
  bool is_drawn(Edge e) const;
  glm::dvec2 place(Vertex v) const { return places_[v.index]; }

  Session& session_;
  glm::dvec2 origin_;
  Size size_;
  glm::dvec2 low_;
  double side_;
  ChangeFeed::Cursor seen_;
  std::vector<glm::dvec2> places_;  // of the vertices, as they were followed
  std::size_t rebuilds_ = 0;
};

}  // namespace ryosen::test
