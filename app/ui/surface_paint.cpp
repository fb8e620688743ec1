#include "app/ui/surface_paint.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/findings.h"
#include "render/colour.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

// The colours of the values that the surface is coloured by.
void paint_values(Findings& findings, const ViewState& view, TriangleSource& source) {
  const Colouring& colouring = *view.colouring;
  const MapValues& values = findings.map_values(colouring);
  const Mesh& mesh = findings.mesh();
  constexpr std::size_t steps = 1024;
  std::vector<std::uint32_t> scale(steps);
  for (std::size_t i = 0; i < steps; ++i) {
    const auto [r, g, b, a] = rgb(colour_at(colouring.map->scale, double(i) / (steps - 1)));
    scale[i] = std::uint32_t{r} | std::uint32_t{g} << 8 | std::uint32_t{b} << 16 | std::uint32_t{a} << 24;
  }
  const auto of = [&values, colouring, scale = std::move(scale)](std::uint32_t slot) -> std::uint32_t {
    const double value = values.of(slot);
    if (std::isnan(value)) return 0;
    return scale[static_cast<std::size_t>(place_on_scale(*colouring.map, colouring.range, value) * (steps - 1) + 0.5)];
  };
  const Element::Kind sort = colouring.map->sort();
  source.paint = sort == Element::Kind::edge ? Paint::sides : Paint::corners;
  source.colours = [&mesh, sort, of](const DrawnTriangle& triangle) {
    std::array<std::uint32_t, 3> colours{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex v(triangle.corners[k]);
      if (sort == Element::Kind::face) colours[k] = of(triangle.face);
      if (sort == Element::Kind::vertex) colours[k] = of(point(mesh, v).index);
      if (sort != Element::Kind::edge || !(triangle.edge_bits >> k & 1)) continue;
      if (const Halfedge h = find_halfedge(mesh, v, Vertex(triangle.corners[(k + 1) % 3])))
        colours[k] = of(edge(h).index);
    }
    return colours;
  };
}

// As of TriangleSource::colours; none where one of the three is not finite.
std::uint32_t packed_colour(const glm::dvec4& colour) {
  std::uint32_t bytes = 0xff000000u;
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(colour[i])) return 0;
    bytes |= static_cast<std::uint32_t>(std::lround(255 * std::clamp(colour[i], 0.0, 1.0))) << (8 * i);
  }
  return bytes;
}

// The colours of the file that are to be seen; null where there are none.
struct ShownFileColours {
  const AttributeColumn* of_vertices = nullptr;
  const FaceColours* of_faces = nullptr;

  explicit ShownFileColours(const Document& document, const ViewState& view) {
    const FileColours which = view.settings.file_colours;
    const Mesh& mesh = document.mesh();
    const int column = mesh.find_attribute(attribute_names::colour);
    const FaceColours& colours = document.tables().face_colours;
    if (which == FileColours::off) return;
    if (which != FileColours::faces && column >= 0) of_vertices = &mesh.attributes()[static_cast<std::size_t>(column)];
    if (which != FileColours::vertices && !colours.values.empty()) of_faces = &colours;
  }
  bool are_none() const { return !of_vertices && !of_faces; }
};

// The colours of a file, of faces where they have one.
void paint_file(const Document& document, const ViewState& view, TriangleSource& source) {
  const ShownFileColours shown(document, view);
  if (shown.are_none()) return;
  source.paint = Paint::own;
  source.colours = [of_vertices = shown.of_vertices,
                    of_faces = shown.of_faces](const DrawnTriangle& triangle) -> std::array<std::uint32_t, 3> {
    const std::uint32_t f = triangle.face;
    const bool has_colour = of_faces && f < of_faces->count.size() && of_faces->count[f] >= 3;
    const std::uint32_t of_face = has_colour ? packed_colour(of_faces->values[f]) : 0;
    if (of_face != 0 || !of_vertices) return {of_face, of_face, of_face};
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = packed_colour(attribute_value<glm::dvec4>(*of_vertices, triangle.corners[k]));
    return corners;
  };
}

}  // namespace

bool is_painted(const Document& document, const ViewState& view) {
  return view.colouring || !ShownFileColours(document, view).are_none();
}

void paint_surface(const Document& document, Findings& findings, const ViewState& view, TriangleSource& source) {
  if (view.colouring)
    paint_values(findings, view, source);
  else
    paint_file(document, view, source);
}

}  // namespace ryosen
