// The one table of what the mesh can be coloured by: a number for each vertex, edge or face.
//
// To add a map, write its row. The command `colours`, `select by`, the panel, the drawing and the command line read the
// table. An algorithm whose result is a number per element adds its row for as long as that is there (ScopedColourMap).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/analysis/measures.h"
#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/element.h"
#include "ryosen/base/message.h"

namespace ryosen {

// linear and ratio go from dark to light, ratio by the logarithm; about_middle goes from one colour over white to
// another, as far on both sides of `middle`.
enum class MapScale : std::uint8_t { linear, ratio, about_middle };

class OtherSurface;

struct ColourMap {
  std::string_view id = {};  // as in the commands
  std::string_view name_en = {}, name_ja = {};
  std::string_view legend_en = {}, legend_ja = {};  // what the number is, in a sentence
  MapUnit unit = MapUnit::none;
  MapScale scale = MapScale::linear;
  double middle = 0;
  bool is_count = false;  // its values are whole numbers
  // Asked about live elements of one sort; NaN: there is none. An edge or vertex that is several in the kernel answers
  // for one only, see ProblemRow. What it looks at beyond its element and those that meet it says the last, as in
  // HighlightRow.
  double (*vertex)(Neighbourhood&, Vertex) = nullptr;
  double (*edge)(Neighbourhood&, Edge) = nullptr;
  double (*face)(Neighbourhood&, Face) = nullptr;
  double (*against)(const Mesh&, Vertex, const OtherSurface&) = nullptr;  // only where there is another mesh
  std::string_view attribute = {};  // whose numbers these are, in place of a function; corners: their mean in a face
  bool reads_whole_faces = false;
  bool reads_two_rings = false;  // of a vertex: what is two edges away

  Element::Kind sort() const {
    if (!attribute.empty())
      return attribute.starts_with("vertex.") ? Element::Kind::vertex
             : attribute.starts_with("edge.") ? Element::Kind::edge
                                              : Element::Kind::face;
    return vertex || against ? Element::Kind::vertex : edge ? Element::Kind::edge : Element::Kind::face;
  }
};

std::span<const ColourMap> colour_maps();
// A row of the table, or the map of the attribute with this name (vertex.load), whether a mesh has it or not.
const ColourMap* find_colour_map(std::string_view id);
// Whether a mesh has numbers for it: an attribute with one number per element.
bool has_numbers(const Mesh& mesh, const ColourMap& map);
// That it has none: a clause.
Text no_numbers(const ColourMap& map);
// The table, and behind it the maps of the attributes of a mesh that have one number.
std::vector<const ColourMap*> colour_maps_of(const Mesh& mesh);
// "edge_length|valence|..."
std::string colour_map_ids();

// A row more for as long as this lives; see ScopedHighlight for who may look meanwhile.
class ScopedColourMap {
 public:
  explicit ScopedColourMap(const ColourMap& row);
  ~ScopedColourMap();
  ScopedColourMap(const ScopedColourMap&) = delete;
  ScopedColourMap& operator=(const ScopedColourMap&) = delete;
};

// Values from low to high are shown by these.
struct MapRange {
  double low = 0, high = 0;
  friend bool operator==(const MapRange&, const MapRange&) = default;
};
// Where a value stands between the two colours at the ends, 0 to 1; outside of the range as at its end.
double place_on_scale(const ColourMap& map, MapRange range, double value);
// The colour at a place from 0 to 1, as 0xRRGGBB: of even steps to the eye (in OKLab), in lightness alone safe for
// colour-blind people.
std::uint32_t colour_at(MapScale scale, double place);

}  // namespace ryosen
