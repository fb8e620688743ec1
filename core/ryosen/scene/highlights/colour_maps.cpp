#include "ryosen/scene/highlights/colour_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <map>
#include <mutex>

#include "ryosen/analysis/curvature.h"
#include "ryosen/analysis/measure/measured_surface.h"
#include "ryosen/analysis/measures.h"
#include "ryosen/base/message.h"
#include "ryosen/base/open_table.h"
#include "ryosen/base/rows.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/attribute_text.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

// A wire answers for itself, of the sheets of an edge the lowest with a face.
double length_of_first_sheet(Neighbourhood& around, Edge e) {
  const auto [left, right] = faces(around.mesh(), e);
  return (left || right) && !around.is_first_sheet(e) ? no_value : edge_length(around.mesh(), e);
}
double valence_of_point(Neighbourhood& around, Vertex v) {
  return around.point(v) == v ? double(valence(around.mesh(), v)) : no_value;
}

constexpr std::array built_in_maps{
    ColourMap{.id = "edge_length",
              .name_en = "Edge length",
              .name_ja = "稜線の長さ",
              .legend_en = "How long each edge is, in the unit of the file.",
              .legend_ja = "各稜線の長さ（ファイルの単位）。",
              .unit = MapUnit::length,
              .edge = length_of_first_sheet},
    ColourMap{.id = "smallest_angle",
              .name_en = "Smallest angle",
              .name_ja = "最小の角",
              .legend_en = "The smallest angle of each face, in degrees.",
              .legend_ja = "各面の最も小さい角（度）。",
              .unit = MapUnit::degrees,
              .face = [](Neighbourhood& around, Face f) { return corner_angles(around, f).smallest_deg; }},
    ColourMap{.id = "largest_angle",
              .name_en = "Largest angle",
              .name_ja = "最大の角",
              .legend_en = "The largest angle of each face, in degrees.",
              .legend_ja = "各面の最も大きい角（度）。",
              .unit = MapUnit::degrees,
              .face = [](Neighbourhood& around, Face f) { return corner_angles(around, f).largest_deg; }},
    ColourMap{.id = "aspect",
              .name_en = "Aspect ratio",
              .name_ja = "細長さ",
              .legend_en = "How far each face is from a regular one: 1 is regular, slivers are large.",
              .legend_ja = "各面の正多角形からの外れ（1 が正多角形、細長いほど大きい）。",
              .scale = MapScale::ratio,
              .face = [](Neighbourhood& around, Face f) { return aspect_ratio(around.mesh(), f); }},
    ColourMap{.id = "valence",
              .name_en = "Valence",
              .name_ja = "価数",
              .legend_en = "How many edges meet at each vertex.",
              .legend_ja = "各頂点に集まる稜線の数。",
              .scale = MapScale::about_middle,
              .middle = 6,
              .is_count = true,
              .vertex = valence_of_point},
    ColourMap{.id = "dihedral",
              .name_en = "Dihedral angle",
              .name_ja = "二面角",
              .legend_en = "The angle between the two faces of each edge: 180 is flat, less a ridge, more a groove.",
              .legend_ja = "各稜線の二つの面がなす角（180 が平ら、小さいと山、大きいと谷）。",
              .unit = MapUnit::degrees,
              .scale = MapScale::about_middle,
              .middle = 180,
              .edge = dihedral_angle_deg,
              .reads_whole_faces = true},
    ColourMap{.id = "area",
              .name_en = "Face area",
              .name_ja = "面積",
              .legend_en = "How large each face is, in the square of the unit of the file.",
              .legend_ja = "各面の面積（ファイルの単位の二乗）。",
              .unit = MapUnit::area,
              .face = [](Neighbourhood& around, Face f) { return face_area(around.mesh(), f); }},
    ColourMap{.id = "planarity",
              .name_en = "Distance from plane",
              .name_ja = "平面からのずれ",
              .legend_en = "How far the corners of each face are from its plane; 0 for triangles.",
              .legend_ja = "各面の角がその平面から離れている距離（三角形は 0）。",
              .unit = MapUnit::length,
              .face = distance_from_plane},
    ColourMap{.id = "sides",
              .name_en = "Sides",
              .name_ja = "角の数",
              .legend_en = "How many corners each face has.",
              .legend_ja = "各面の角の数。",
              .is_count = true,
              .face = [](Neighbourhood& around, Face f) { return double(corner_count(around.mesh(), f)); }},
    ColourMap{.id = "mean_curvature",
              .name_en = "Mean curvature",
              .name_ja = "平均曲率",
              .legend_en = "How much the surface bends at each vertex, both directions together: above 0 on hills, "
                           "below 0 in hollows.",
              .legend_ja = "各頂点での曲がり（二方向の平均）。山で正、谷で負。",
              .unit = MapUnit::per_length,
              .scale = MapScale::about_middle,
              .vertex = [](Neighbourhood& around, Vertex v) { return curvature_at(around, v).mean(); },
              .reads_two_rings = true},
    ColourMap{.id = "gaussian_curvature",
              .name_en = "Gaussian curvature",
              .name_ja = "ガウス曲率",
              .legend_en = "The product of both curvatures at each vertex: above 0 on caps and bowls, below 0 on "
                           "saddles, 0 where it could be unrolled.",
              .legend_ja = "各頂点での二つの主曲率の積。椀で正、鞍で負、平らに広げられる所で 0。",
              .unit = MapUnit::per_area,
              .scale = MapScale::about_middle,
              .vertex = [](Neighbourhood& around, Vertex v) { return curvature_at(around, v).gaussian(); },
              .reads_two_rings = true},
    ColourMap{.id = "largest_curvature",
              .name_en = "Largest curvature",
              .name_ja = "最大主曲率",
              .legend_en = "The curvature at each vertex in the direction in which it is largest: 1 over the radius, "
                           "above 0 on hills.",
              .legend_ja = "各頂点で最も大きい方向の曲率（半径の逆数、山で正）。",
              .unit = MapUnit::per_length,
              .scale = MapScale::about_middle,
              .vertex = [](Neighbourhood& around, Vertex v) { return curvature_at(around, v).largest; },
              .reads_two_rings = true},
    ColourMap{.id = "smallest_curvature",
              .name_en = "Smallest curvature",
              .name_ja = "最小主曲率",
              .legend_en = "The curvature at each vertex in the direction in which it is smallest: 1 over the radius, "
                           "below 0 in hollows.",
              .legend_ja = "各頂点で最も小さい方向の曲率（半径の逆数、谷で負）。",
              .unit = MapUnit::per_length,
              .scale = MapScale::about_middle,
              .vertex = [](Neighbourhood& around, Vertex v) { return curvature_at(around, v).smallest; },
              .reads_two_rings = true},
    ColourMap{.id = "distance",
              .name_en = "Distance from the other mesh",
              .name_ja = "もう一つのメッシュからの距離",
              .legend_en = "How far each vertex is from the surface of the mesh that this one is compared with.",
              .legend_ja = "各頂点の、比較しているメッシュの面からの距離。",
              .unit = MapUnit::length,
              .against = [](const Mesh& mesh, Vertex v,
                            const OtherSurface& other) { return other.distance(mesh.position(v)); }},
};

constinit OpenTable<ColourMap, 32> map_table(built_in_maps);

// The map of an attribute; rows stay where they are.
struct AttributeMap {
  std::string name;
  Text title, legend;
  ColourMap map;

  explicit AttributeMap(std::string_view attribute)
      : name(attribute),
        title(is_of_corners() ? Text{name + " (mean per face)", name + "（面ごとの平均）"} : Text{name, name}),
        legend{"The values of the attribute " + name + (is_of_corners() ? ", their mean in each face." : "."),
               "属性 " + name + " の値" + (is_of_corners() ? "の面ごとの平均。" : "。")},
        map{.id = name,
            .name_en = title.en,
            .name_ja = title.ja,
            .legend_en = legend.en,
            .legend_ja = legend.ja,
            .attribute = name} {}
  bool is_of_corners() const { return name.starts_with("corner."); }
  AttributeMap(const AttributeMap&) = delete;
};

const ColourMap* map_of_attribute(std::string_view name) {
  static std::mutex mutex;
  static std::map<std::string, AttributeMap, std::less<>> maps;
  const std::lock_guard lock(mutex);
  auto found = maps.find(name);
  if (found == maps.end()) found = maps.try_emplace(std::string(name), name).first;
  return &found->second.map;
}

double gamma(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

// To sRGB from lightness and two colour axes.
std::uint32_t from_oklab(const glm::dvec3& lab) {
  const double l = std::pow(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z, 3);
  const double m = std::pow(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z, 3);
  const double s = std::pow(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z, 3);
  const auto byte = [](double linear) { return static_cast<std::uint32_t>(std::lround(255 * gamma(linear))); };
  return byte(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s) << 16 |
         byte(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s) << 8 |
         byte(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s);
}

// Blue to yellow, and blue over white to orange: what all colour-blind people but very few tell apart.
constexpr glm::dvec3 dark_blue{0.28, 0.0, -0.11}, yellow{0.92, -0.01, 0.17};
constexpr glm::dvec3 blue{0.46, -0.02, -0.14}, white{0.96, 0.0, 0.0}, orange{0.56, 0.09, 0.115};

}  // namespace

std::span<const ColourMap> colour_maps() { return map_table.rows(); }
const ColourMap* find_colour_map(std::string_view id) {
  const ColourMap* const row = map_table.find(id);
  return row || !element_of_attribute(id) ? row : map_of_attribute(id);
}

bool has_numbers(const Mesh& mesh, const ColourMap& map) {
  if (map.attribute.empty()) return true;
  const AttributeColumn* const column = find_column(mesh, map.attribute);
  return column && column->type.count == 1 && !is_reserved_name(map.attribute);
}

Text no_numbers(const ColourMap& map) {
  const std::string name(map.id);
  return {"there is no attribute " + name + " with one number per element",
          "要素ごとに数を一つ持つ属性 " + name + " はありません"};
}

std::vector<const ColourMap*> colour_maps_of(const Mesh& mesh) {
  std::vector<const ColourMap*> maps;
  for (const ColourMap& map : colour_maps()) maps.push_back(&map);
  for (const AttributeColumn* const column : free_attributes(mesh))
    if (column->type.count == 1) maps.push_back(find_colour_map(column->name));
  return maps;
}

std::string colour_map_ids() { return joined_ids(colour_maps()); }

ScopedColourMap::ScopedColourMap(const ColourMap& row) { map_table.add(row); }
ScopedColourMap::~ScopedColourMap() { map_table.remove_last(); }

double place_on_scale(const ColourMap& map, MapRange range, double value) {
  const double v = std::clamp(value, range.low, range.high);
  if (map.scale == MapScale::about_middle) {
    const double reach = std::max(std::abs(range.low - map.middle), std::abs(range.high - map.middle));
    return reach > 0 ? std::clamp(0.5 + 0.5 * (v - map.middle) / reach, 0.0, 1.0) : 0.5;
  }
  if (!(range.high > range.low)) return 0.5;
  if (map.scale == MapScale::ratio && range.low > 0) return std::log(v / range.low) / std::log(range.high / range.low);
  return (v - range.low) / (range.high - range.low);
}

std::uint32_t colour_at(MapScale scale, double place) {
  const double t = std::clamp(place, 0.0, 1.0);
  if (scale != MapScale::about_middle) return from_oklab(glm::mix(dark_blue, yellow, t));
  return from_oklab(t < 0.5 ? glm::mix(blue, white, 2 * t) : glm::mix(white, orange, 2 * t - 1));
}

}  // namespace ryosen
