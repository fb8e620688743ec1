// One view of a mesh: what is drawn in it, from where, and the picture that comes out.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/enum_table.h"
#include "core/base/handle.h"
#include "core/base/result.h"
#include "core/view/camera.h"
#include "render/dirty_rects.h"
#include "render/face_tint.h"
#include "render/gl/framebuffer.h"
#include "render/image.h"
#include "render/mesh_buffers.h"
#include "render/overlay.h"
#include "render/palette.h"
#include "render/pass/background.h"
#include "render/pass/ids.h"
#include "render/pass/overlay.h"
#include "render/pass/resolve.h"
#include "render/pass/surface.h"

namespace ryosen {

// Overlays that change independently of each other, drawn in this order.
enum class Layer { highlights, selection, hover };
inline constexpr std::size_t layer_count = enum_count<Layer>;

// What is seen at each pixel of a view, rows from the top down.
struct IdImage {
  Size size;
  std::vector<std::uint32_t> triangle;  // number in the TriangleSource, no_index where there is none
  std::vector<std::uint32_t> face;      // its face, no_index where there is none
  std::vector<float> depth;             // along the view direction, in mesh units; 0 where there is none
};

// Keeps a picture of the mesh and redraws of it what has changed. Setters only take note; draw() does the work, in the
// context that was current when the view was made. Rectangles are in pixels of the picture.
class View {
 public:
  // Fails with ExitCode::no_backend when the driver refuses a shader.
  static Result<std::unique_ptr<View>> make();

  // The picture's size, and how many rendered pixels a side make one of its pixels (1 to 8).
  void resize(Size size, int supersample = 1);
  void set_theme(Theme theme);
  // Without a background the picture has an alpha channel.
  void set_transparent(bool transparent);
  void set_camera(const Camera& camera);
  // What the numbers of the faces' tints mean, from 1 on.
  void set_tints(std::span<const DrawnTint> tints);
  // Replaces what the layer holds.
  void set_overlay(Layer layer, const Overlay& overlay);
  // Replaces a numbered part of the layer, at the cost of that part; see OverlayBuffer::set_part.
  void set_overlay_part(Layer layer, std::uint32_t part, const Overlay& overlay);
  // Takes a mesh anew: the origin of the buffers and their scale are chosen here. Linear.
  void set_mesh(const TriangleSource& source);
  // Takes over a change of the mesh, see MeshBuffers::update. Costs what changed.
  void update_mesh(const TriangleSource& source, std::span<const std::uint32_t> vertices,
                   std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> faces);

  // True when draw() would draw something.
  bool needs_drawing() const { return !dirty_.empty(); }
  // Draws what has changed since the last draw, in a few rectangles, and returns the box around them. The picture is
  // the same, pixel by pixel, as if all of it had been drawn.
  PixelRect draw();
  // The rectangles that the last draw() drew.
  std::span<const PixelRect> redrawn() const { return redrawn_.rects(); }
  // Draws a rectangle, changed or not.
  void draw(const PixelRect& rect);

  // The picture as it was drawn last.
  Image read_pixels() const;
  const Framebuffer& picture() const { return supersample_ > 1 ? resolved_ : rendered_; }
  // Draws and reads which triangle is seen where, at one rendered pixel per pixel.
  IdImage read_ids();

  const Camera& camera() const { return camera_; }
  Size size() const { return size_; }

 private:
  struct Passes {
    SurfacePass surface;
    BackgroundPass background;
    OverlayPass overlay;
    ResolvePass resolve;
    IdsPass ids;
  };

  explicit View(Passes passes);
  void all_changed();
  void changed(std::span<const TouchedBox> touched);
  void place_planes();
  void sort_clusters();
  Frame frame(const PixelRect& rect, int scale) const;
  void place_cluster(std::uint32_t cluster, const Frame& whole);
  std::vector<std::uint32_t> clusters_in(const PixelRect& rect) const;

  Passes passes_;
  MeshBuffers mesh_;
  std::array<OverlayBuffer, layer_count> overlays_;
  Framebuffer rendered_;
  Framebuffer resolved_;
  Camera camera_;
  Size size_{1, 1};
  int supersample_ = 1;
  Theme theme_ = Theme::dark;
  std::vector<DrawnTint> tints_;
  bool transparent_ = false;
  DirtyRects dirty_, redrawn_;
  bool planes_stale_ = true;               // near, far and the order of clusters belong to another camera or mesh
  double near_ = 0.1, far_ = 1;            // in buffer space
  std::vector<std::uint32_t> order_;       // clusters from near to far
  std::vector<PixelRect> cluster_places_;  // where each cluster may be seen, in pixels of the picture
};

}  // namespace ryosen
