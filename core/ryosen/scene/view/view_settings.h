// How a view draws what it shows, beside the camera: what the switches of the view set
// (app/editor/preferences/view_switches.h) and what its shaders read. A switch that needs more of the mesh than places
// and links, as smooth shading needs normals, has that found beside the mesh (corner_normals.h), kept by the session
// and laid into buffers by render/mesh_buffers.h.
#pragma once

namespace ryosen {

enum class Theme { dark, light };
// Each face in a light of its own, or light that goes over evenly from face to face, except at creases.
enum class Shading { flat, smooth };
// Whether the edges of faces are drawn on the surface.
enum class Wire { on, off };
// Whether the surface hides what lies behind it, from the eye and the pointer, or is seen through.
enum class Xray { off, on };
// Whether vertices are drawn: while they are what the pointer picks, or always, or never.
enum class Dots { picked, always, never };
// Of which elements the numbers are drawn: of one kind, of all, or the numbers 3i+j of the corners of faces.
enum class Numbers { off, vertices, edges, faces, halfedges, all, corners };

// Whether the surface has the colours of the file: those of its faces, and where they have none of its vertices; or of
// one of the two alone.
enum class FileColours { on, vertices, faces, off };
// Of which elements the normals are drawn.
enum class Normals { off, vertices, faces };

// Whether there is a grid on the ground.
enum class GroundGrid { off, on };

// One field per switch, an enumeration in the order of the values of its row; each begins with the first one.
struct ViewSettings {
  Theme theme = Theme::dark;
  Shading shading = Shading::flat;
  Wire wire = Wire::on;
  Xray xray = Xray::off;
  Dots dots = Dots::picked;
  Numbers numbers = Numbers::off;
  FileColours file_colours = FileColours::on;
  Normals normals = Normals::off;
  GroundGrid ground = GroundGrid::off;

  // Calls visit(name, number) for each, by the id of its row: a shader gets the number as its `uniform int name`.
  template <class Visit>
  void for_each(Visit visit) const {
    visit("theme", static_cast<int>(theme));
    visit("shading", static_cast<int>(shading));
    visit("wire", static_cast<int>(wire));
    visit("xray", static_cast<int>(xray));
    visit("dots", static_cast<int>(dots));
    visit("numbers", static_cast<int>(numbers));
    visit("file_colours", static_cast<int>(file_colours));
    visit("normals", static_cast<int>(normals));
    visit("ground", static_cast<int>(ground));
  }

  friend bool operator==(const ViewSettings&, const ViewSettings&) = default;
};

}  // namespace ryosen
