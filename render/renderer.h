// Renders a mesh with what lies over it, as a camera sees it, and keeps the picture.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "render/cluster_places.h"
#include "render/dirty_rects.h"
#include "render/gl/framebuffer.h"
#include "render/image.h"
#include "render/mesh_buffers.h"
#include "render/overlay.h"
#include "render/palette.h"
#include "render/pass/background.h"
#include "render/pass/cut.h"
#include "render/pass/grid.h"
#include "render/pass/ids.h"
#include "render/pass/labels.h"
#include "render/pass/overlay.h"
#include "render/pass/resolve.h"
#include "render/pass/surface.h"
#include "render/pass/xray.h"
#include "render/refinement.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/base/handle.h"
#include "ryosen/base/result.h"
#include "ryosen/scene/view/camera.h"
#include "ryosen/scene/view/clip_plane.h"

namespace ryosen {

// Overlay layers that change independently, in drawing order.
enum class Layer {
  normals,
  left_edges,
  highlights,
  verdicts,
  question,
  selection,
  links,
  measures,
  steps,
  hover,
  handles,
  axes
};
inline constexpr std::size_t layer_count = enum_count<Layer>;

// The visible triangle at each pixel of a view, rows top-down.
struct IdImage {
  Size size;
  std::vector<std::uint32_t> triangle;  // number in the TriangleSource, no_index if none
  std::vector<std::uint32_t> face;      // its face, no_index if none
  std::vector<float> depth;             // along the view direction, in mesh units; 0 if none
};

// Keeps a picture of the mesh and redraws only what has changed. Setters only record changes; draw() does the work and
// needs the context that was current when the renderer was made. Rectangles are in picture pixels.
class Renderer {
 public:
  // Fails with ExitCode::no_backend if a shader does not compile or link.
  static Result<std::unique_ptr<Renderer>> make();

  // The picture's size, and the supersampling factor per dimension (1 to 8).
  void resize(Size size, int supersample = 1);
  void set_settings(const ViewSettings& settings);
  // How many pixels wide is what lines, points and patterns count as one; 1 at first.
  void set_display_scale(float scale);
  // Without a background the picture has an alpha channel.
  void set_transparent(bool transparent);
  void set_camera(const Camera& camera);
  // What lies beyond a plane is not drawn, nor what the layers up to `hover` have there.
  void set_clip(const std::optional<ClipPlane>& plane);
  // Draws every so many-th triangle only, a part that is even over the surface, since they are ordered along it. A
  // power of two up to MeshBuffers::cluster_size; at first 1, which draws all.
  void set_thinning(std::uint32_t thinning);
  std::uint32_t thinning() const { return thinning_; }
  // draw() stops after about so many triangles, at least one rectangle, and goes on when it is called again; 0 as at
  // first: it does not stop.
  void set_most_triangles(std::size_t most) { most_triangles_ = most; }
  // draw() goes on, when all is drawn, to draw a part at a time with several samples a pixel, until is_refined(). What
  // changes is drawn with those of resize() at first. No effect where they are as many.
  void set_refining(bool refines) { refines_ = refines; }
  // Makes what refining needs, at a picture of the present size, so that its first part takes no longer than the
  // others.
  void prepare_refining();
  bool is_refined() const { return !can_refine_ || (is_drawn() && refinement_.is_done()); }
  // Such a draw() refines parts of at most so much effort together, which is about nanoseconds of one core; one part at
  // least, of a few pixels where it must be. 0, as at first: a tile.
  void set_most_refining(double effort) { most_refining_ = effort; }
  // Of what the last draw() refined.
  double refining_effort() const { return refining_effort_; }
  // What the numbers of the faces' tints mean, from 1 on.
  void set_tints(std::span<const DrawnTint> tints);
  // Replaces the content of a layer.
  void set_overlay(Layer layer, const Overlay& overlay);
  // Replaces a numbered part of a layer, at the cost of that part; see OverlayBuffer::set_part.
  void set_overlay_part(Layer layer, std::uint32_t part, const Overlay& overlay);
  // Whether a layer is drawn, at first each. What changes in one that is not costs no redraw.
  void show_layer(Layer layer, bool shown);
  // So many elements will come: their memory is not moved again and again meanwhile.
  void reserve_overlay(Layer layer, std::size_t elements);
  // The texts over the picture, in its pixels, and their glyphs; see LabelsPass.
  void set_labels(std::span<const DrawnLabel> texts);
  void set_label_fonts(ImFontAtlas& atlas) { passes_.labels.set_fonts(atlas); }
  // Replaces the mesh; chooses the buffer space and clears the overlays. Linear.
  void set_mesh(const TriangleSource& source);
  // Applies a change of the mesh, see MeshBuffers::update. Costs the changes.
  void update_mesh(const TriangleSource& source, std::span<const std::uint32_t> vertices,
                   std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> faces);

  // Redraws what has changed since the last draw, in a few rectangles, and returns their bounding rectangle. The
  // picture is identical, pixel by pixel, to a full redraw, once is_drawn().
  PixelRect draw();
  // Whether nothing is left to be redrawn.
  bool is_drawn() const { return dirty_.empty() && waiting_.empty() && !planes_stale_; }
  // Whether the picture shows all triangles, and is_drawn().
  bool is_whole() const { return thinning_ == 1 && is_drawn(); }
  // How many triangles the last draw() drew or found hidden, and among how many the next one, if it drew all, would
  // find those it shows.
  std::size_t triangles_drawn() const { return triangles_drawn_; }
  std::size_t triangles_in_view();
  // How many of them the last draw() left out, because nearer ones hide them.
  std::size_t triangles_hidden() const { return triangles_hidden_; }
  // The rectangles drawn by the last draw().
  std::span<const PixelRect> redrawn() const { return redrawn_.rects(); }
  // Draws a rectangle unconditionally.
  void draw(const PixelRect& rect);

  // The last drawn picture.
  Image read_pixels() const;
  const Framebuffer& picture() const { return supersample_ > 1 ? resolved_ : rendered_; }
  // Renders and reads the id image, without supersampling.
  IdImage read_ids();

  const Camera& camera() const { return camera_; }
  Size size() const { return size_; }

 private:
  struct Passes {
    SurfacePass surface;
    CutPass cut;
    XrayPass xray;
    BackgroundPass background;
    GridPass grid;
    OverlayPass overlay;
    ResolvePass resolve;
    IdsPass ids;
    LabelsPass labels;
  };

  explicit Renderer(std::optional<Failure>& failure);  // of the first shader that is refused
  void all_changed();
  // Takes a value over; where it is another, all is to be redrawn. Whether it is.
  template <class T>
  bool follow(const T& value, T& member) {
    if (value == member) return false;
    member = value;
    all_changed();
    return true;
  }
  void changed(std::span<const TouchedBox> touched);
  void follow_camera();  // places the planes where they are stale; then all is to be redrawn
  void place_planes();
  void follow_ground();  // where it is another, all is to be redrawn
  Frame frame(const PixelRect& rect, int scale) const;
  // Draws the ground and these clusters over it.
  void draw_scene(const Frame& frame, const DrawTarget& target, std::span<const std::uint32_t> clusters);
  // Draws these clusters from front to back. Where there are many it looks in between which of the rest are hidden.
  void draw_surface(const Frame& frame, const DrawTarget& target, std::span<const std::uint32_t> clusters);
  // Draws the surface, the ground and the overlays into a rectangle of the frame.
  void draw_all(const Frame& frame, const DrawTarget& target, std::span<const std::uint32_t> clusters);
  void refine();
  void refine(const Refinement::Part& part);
  // Of refining this rectangle, with what of the overlays lies there.
  double effort_of(const PixelRect& rect) const;
  // Takes the next rectangle that waits, halved until it has no more triangles than one draw() may draw.
  PixelRect take_waiting();
  // Whether more triangles are in it than these, so that it is to be halved; 0: never.
  bool is_too_much(const PixelRect& rect, std::size_t most_triangles) const;

  Passes passes_;
  MeshBuffers mesh_;
  std::array<OverlayBuffer, layer_count> overlays_;
  std::array<bool, layer_count> is_shown_{};
  Framebuffer rendered_;
  Framebuffer resolved_;
  Framebuffer fine_;  // a tile of the refinement
  Refinement refinement_;
  Camera camera_;
  Size size_{1, 1};
  int supersample_ = 1;
  float display_scale_ = 1;
  ViewSettings settings_;
  std::optional<ClipPlane> clip_;
  Ground ground_;
  std::vector<DrawnTint> tints_;
  bool transparent_ = false, refines_ = false, can_refine_ = true;
  std::uint32_t thinning_ = 1;
  std::size_t most_triangles_ = 0, triangles_drawn_ = 0, triangles_hidden_ = 0;
  double most_refining_ = 0, refining_effort_ = 0;
  DirtyRects dirty_, redrawn_;
  std::vector<PixelRect> waiting_;  // what draw() has left, the next one last; may overlap
  bool planes_stale_ = true;        // near, far and the cluster order are out of date
  double near_ = 0.1, far_ = 1;     // in buffer space
  ClusterPlaces places_;
  Occlusion occlusion_;
};

}  // namespace ryosen
