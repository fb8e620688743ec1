#include "ryosen/io/losses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ryosen/geometry/single_precision.h"
#include "ryosen/indexed/indexed.h"
#include "ryosen/io/byte_colours.h"
#include "ryosen/io/ply_columns.h"
#include "ryosen/io/reporter.h"
#include "ryosen/io/stl.h"
#include "ryosen/io/txt.h"

namespace ryosen {
namespace {

bool holds_polygons(const MeshFile& file, Holds held) {
  return holds(held, Holds::polygons) || (file.has_free_facets && holds(held, Holds::free_facets));
}

std::uint64_t many_corners(const MeshFile& file, Holds held) {
  if (holds_polygons(file, held)) return 0;
  std::uint64_t count = 0;
  for (std::size_t f = 0; f < file.mesh.face_count(); ++f) count += file.mesh.face(f).size() > 3 ? 1 : 0;
  return count - file.mesh.bridged.size();
}

std::uint64_t corner_values(const IndexedMesh& mesh, const CornerValues& values, bool per_corner, bool for_vertices) {
  if (values.pool.empty() || per_corner || (for_vertices && per_vertex(mesh, values))) return 0;
  return values.pool.size();
}

std::uint64_t texcoords(const MeshFile& file, Holds held) {
  return corner_values(file.mesh, file.mesh.texcoords, holds(held, Holds::corner_texcoords),
                       holds(held, Holds::vertex_texcoords));
}

std::uint64_t third_texcoords(const MeshFile& file, Holds held) {
  const CornerValues& values = file.mesh.texcoords;
  if (holds(held, Holds::third_texcoord) || texcoords(file, held) != 0) return 0;
  return values.components == 3 ? values.pool.size() : 0;
}

std::uint64_t normals(const MeshFile& file, Holds held) {
  return corner_values(file.mesh, file.mesh.normals, holds(held, Holds::corner_normals),
                       holds(held, Holds::vertex_normals));
}

std::uint64_t missing_colours(const MeshFile& file, Holds held) {
  if (holds(held, Holds::missing_colours) || !holds(held, Holds::vertex_colours)) return 0;
  const auto& colours = file.mesh.vertex_colours;
  const auto is_none = [](const glm::dvec4& colour) { return std::isnan(colour.x); };
  return static_cast<std::uint64_t>(std::count_if(colours.begin(), colours.end(), is_none));
}

std::uint64_t rounded_colours(const MeshFile& file, Holds held) {
  if (holds(held, Holds::any_vertex_colours) || !holds(held, Holds::vertex_colours)) return 0;
  return count_rounded_colours(file);
}

// A format that keeps the properties of the file keeps their types.
std::uint64_t colours_between_bytes(const MeshFile& file, Holds held) {
  return holds(held, Holds::properties) ? ply_rounded_colours(file) : 0;
}

std::uint64_t face_colours(const MeshFile& file, Holds held) {
  const std::vector<std::uint8_t>& count = file.mesh.face_colours.count;
  if (holds(held, Holds::any_face_colours) || count.empty()) return 0;
  const auto without = static_cast<std::uint64_t>(std::count(count.begin(), count.end(), 0));
  const bool are_held = holds(held, Holds::face_colours) && ply_face_colour_components(file.mesh.face_colours) != 0;
  return are_held ? without : count.size() - without;
}

// Faces with a number that 32 bits do not hold beside the others, with a sign or without.
std::uint64_t faces_beyond_32_bits(const std::vector<QuarantinedFace>& faces) {
  std::int64_t least = 0, most = 0;
  for (const QuarantinedFace& face : faces)
    for (const std::int64_t corner : face.corners) {
      least = std::min(least, corner);
      most = std::max(most, corner);
    }
  if (least >= 0 && most <= std::numeric_limits<std::uint32_t>::max()) return 0;
  using Signed = std::numeric_limits<std::int32_t>;
  return static_cast<std::uint64_t>(std::count_if(faces.begin(), faces.end(), [](const QuarantinedFace& face) {
    return std::any_of(face.corners.begin(), face.corners.end(),
                       [](std::int64_t corner) { return corner < Signed::min() || corner > Signed::max(); });
  }));
}

std::uint64_t quarantined_faces(const MeshFile& file, Holds held) {
  if (holds(held, Holds::quarantine))
    return holds(held, Holds::wide_numbers) ? 0 : faces_beyond_32_bits(file.mesh.quarantine);
  const TxtQuarantine listed(file.mesh);
  const auto is_held = [&](const QuarantinedFace& face) {
    const bool exists = face.has_corners_within(file.mesh.positions.size());
    if (face.corners.size() != 3) return holds_polygons(file, held) && exists && !face.corners.empty();
    return (holds(held, Holds::odd_triangles) && listed.holds(face)) || (holds(held, Holds::flat_triangles) && exists);
  };
  const auto& faces = file.mesh.quarantine;
  return faces.size() - static_cast<std::uint64_t>(std::count_if(faces.begin(), faces.end(), is_held));
}

// Vertices used by a face that formats without separate vertices can hold.
std::vector<bool> used_vertices(const IndexedMesh& mesh) {
  std::vector<bool> used(mesh.positions.size(), false);
  for (const std::uint32_t corner : mesh.corners) used[corner] = true;
  for (const QuarantinedFace& face : mesh.quarantine) {
    if (!face.has_corners_within(used.size())) continue;
    for (const std::int64_t corner : face.corners) used[static_cast<std::size_t>(corner)] = true;
  }
  return used;
}

std::uint64_t isolated_vertices(const MeshFile& file, Holds held) {
  if (holds(held, Holds::vertices)) return 0;
  const std::vector<bool> used = used_vertices(file.mesh);
  return static_cast<std::uint64_t>(std::count(used.begin(), used.end(), false));
}

// Points whose identity is lost when read back: those at the position of an earlier point, and those with a NaN
// coordinate used by more than one corner, which become several.
std::uint64_t welded_points(const MeshFile& file, Holds held) {
  if (holds(held, Holds::vertices)) return 0;
  const IndexedMesh& mesh = file.mesh;
  const std::vector<bool> used = used_vertices(mesh);
  std::vector<std::uint32_t> points;
  std::uint64_t count = 0;
  std::vector<std::uint8_t> corners_at;  // of points with a NaN coordinate: 0, 1, or more
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    const glm::dvec3& p = mesh.positions[v];
    if (p == p)
      points.push_back(static_cast<std::uint32_t>(v));
    else
      corners_at.resize(used.size());
  }
  if (!corners_at.empty()) {
    for (const std::uint32_t corner : mesh.corners) {
      const glm::dvec3& p = mesh.positions[corner];
      if (!(p == p) && corners_at[corner] < 2 && ++corners_at[corner] == 2) ++count;
    }
  }
  const bool is_rounded = !holds(held, Holds::doubles);
  const auto place = [&](std::uint32_t v) {
    glm::dvec3 p = mesh.positions[v] + 0.0;  // -0 is 0
    if (is_rounded) p = to_single(p);
    return std::array{p.x, p.y, p.z};
  };
  std::sort(points.begin(), points.end(), [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  for (std::size_t i = 1; i < points.size(); ++i) count += place(points[i]) == place(points[i - 1]) ? 1 : 0;
  return count;
}

bool is_held_elsewhere(const AttributeColumn& column, Holds held) {
  return holds(held, Holds::facet_attributes) && column.name == facet_attribute &&
         column.type == value_type<std::uint16_t>;
}

// Edges count as rows where one has a value.
std::uint64_t extra_properties(const MeshFile& file, Holds held) {
  if (holds(held, Holds::properties)) return ply_unwritten_attributes(file);
  std::uint64_t count = 0;
  for (const PropertyTable& table : file.properties.tables) {
    if (table.is_further()) continue;
    for (const Property& property : table.properties) count += property.is_kept() ? 1 : 0;
  }
  for (const AttributeColumn& column : file.mesh.attributes) {
    const bool counts_as_rows = column.element == ElementKind::edge && !file.mesh.edges.empty();
    count += !counts_as_rows && !is_held_elsewhere(column, held) ? 1 : 0;
  }
  return count;
}

std::vector<std::string> names_of_properties(const MeshFile& file, Holds held) {
  std::vector<std::string> names;
  for (const AttributeColumn& column : file.mesh.attributes)
    if (column.element != ElementKind::edge && !is_held_elsewhere(column, held)) names.push_back(column.name);
  return names;
}

std::uint64_t extra_rows(const MeshFile& file, Holds held) {
  if (holds(held, Holds::properties)) return 0;
  std::uint64_t count = file.properties.obj_info.size() + file.mesh.edges.size();
  for (const UnknownLines& lines : file.properties.unknown_lines)
    count += static_cast<std::uint64_t>(std::count(lines.text.begin(), lines.text.end(), '\n'));
  for (const PropertyTable& table : file.properties.tables) count += table.is_further() ? table.rows : 0;
  return count;
}

std::uint64_t own_rules(const MeshFile& file, Holds held) {
  if (!holds(held, Holds::properties)) return 0;
  const auto& all = file.mesh.attributes;
  return static_cast<std::uint64_t>(std::count_if(
      all.begin(), all.end(), [](const AttributeColumn& column) { return column.rule == ValueRule::own; }));
}

std::uint64_t comments(const MeshFile& file, Holds held) {
  const std::vector<std::string>& lines = file.head_comments;
  if (holds(held, Holds::comments) || lines.empty()) return 0;
  return lines.size() - (holds(held, Holds::first_comment) && may_head_stl(lines[0]) ? 1 : 0);
}

std::uint64_t wordless_head(const MeshFile& file, Holds held) {
  return has_wordless_head(file) && !(holds(held, Holds::first_comment) && may_head_stl(file.stl_head)) ? 1 : 0;
}

// What single precision makes of a number.
enum class Single { same, rounded, zero, infinite };

Single as_single(double value) {
  if (!std::isfinite(value)) return Single::same;
  constexpr double least_infinite = 0x1.ffffffp127;  // from here on the nearest single is infinity
  if (std::abs(value) >= least_infinite) return Single::infinite;
  const auto single = static_cast<float>(value);
  if (static_cast<double>(single) == value) return Single::same;
  return single == 0 ? Single::zero : Single::rounded;
}

template <Single Fate>
bool meets(const glm::dvec3& p) {
  return as_single(p.x) == Fate || as_single(p.y) == Fate || as_single(p.z) == Fate;
}

// The vertices that are written and fare so.
template <Single Fate, class Visit>
void for_each_single(const MeshFile& file, Holds held, const Visit& visit) {
  if (holds(held, Holds::doubles)) return;
  const std::vector<bool> is_written =
      holds(held, Holds::vertices) ? std::vector<bool>(file.mesh.positions.size(), true) : used_vertices(file.mesh);
  for (std::uint32_t v = 0; v < is_written.size(); ++v)
    if (is_written[v] && meets<Fate>(file.mesh.positions[v])) visit(v);
}

template <Single Fate>
std::uint64_t count_singles(const MeshFile& file, Holds held) {
  std::uint64_t count = 0;
  for_each_single<Fate>(file, held, [&](std::uint32_t) { ++count; });
  return count;
}

template <Single Fate>
std::optional<std::uint64_t> first_single(const MeshFile& file, Holds held) {
  std::optional<std::uint64_t> first;
  for_each_single<Fate>(file, held, [&](std::uint32_t v) { first = first.value_or(v); });
  return first;
}

template <Holds Held, class Get>
std::uint64_t unless(Holds held, Get get) {
  return holds(held, Held) ? 0 : get();
}

}  // namespace

const std::vector<LossKind>& loss_kinds() {
  using File = const MeshFile&;
  static const std::vector<LossKind> kinds = {
      {"loses_polygons", "faces with more than three corners, which are cut into triangles",
       "4 頂点以上の面(三角形に分割されます)", many_corners},
      {"loses_rings", "faces with holes, which are cut into triangles", "穴のある面(三角形に分割されます)",
       [](File f, Holds h) -> std::uint64_t { return holds_polygons(f, h) ? 0 : f.mesh.bridged.size(); }},
      {"loses_quarantined", "faces that were set aside", "隔離された面", quarantined_faces},
      {"loses_isolated_vertices", "vertices without a face", "面に属さない頂点", isolated_vertices},
      {"loses_topology", "points at equal places, which become one, or at no place, which fall apart",
       "同じ位置にある別々の点(1 点になります)と、位置を持たない点(ばらばらになります)", welded_points},
      {"loses_precision", "vertices whose coordinates need more than single precision, which are rounded",
       "単精度では表せない座標を持つ頂点(丸められます)", count_singles<Single::rounded>},
      {"loses_large_numbers", "vertices with coordinates beyond single precision, which become infinite",
       "単精度の範囲を超える座標を持つ頂点(無限大になります)", count_singles<Single::infinite>,
       LossSentence::cannot_hold, first_single<Single::infinite>},
      {"loses_small_numbers", "vertices with coordinates too small for single precision, which become 0",
       "単精度には小さすぎる座標を持つ頂点(0 になります)", count_singles<Single::zero>, LossSentence::cannot_hold,
       first_single<Single::zero>},
      {"loses_wires", "edges without a face", "面を持たない稜線",
       [](File f, Holds h) { return unless<Holds::elements>(h, [&] { return f.wires.size(); }); }},
      {"loses_wires", "Edges without a face are written as lines, and reading gives lines back, not edges",
       "面を持たない稜線は線として書き出され、読み込むと稜線ではなく線になります。稜線の数",
       [](File f, Holds h) -> std::uint64_t { return holds(h, Holds::elements) ? f.wires.size() : 0; },
       LossSentence::own},
      {"loses_elements", "lines and points", "線と点の要素",
       [](File f, Holds h) { return unless<Holds::elements>(h, [&] { return f.elements.items.size(); }); }},
      {"loses_texcoords", "texture coordinates", "テクスチャ座標", texcoords},
      {"loses_third_texcoord", "the third numbers of texture coordinates", "テクスチャ座標の 3 番目の数",
       third_texcoords},
      {"loses_normals", "normals", "法線", normals},
      {"loses_vertex_colours", "colours of vertices", "頂点の色",
       [](File f, Holds h) { return unless<Holds::vertex_colours>(h, [&] { return f.mesh.vertex_colours.size(); }); }},
      {"loses_missing_colours", "vertices without a colour, which become white", "色のない頂点(白になります)",
       missing_colours},
      {"loses_exact_colours", "colours of vertices or faces among brighter ones than white, which are rounded",
       "白より明るい色を含む頂点や面の色(丸められます)", rounded_colours},
      {"loses_exact_colours", "Colours are rounded to the uchar that the file has for them; vertices and faces",
       "色は、ファイルの型 uchar に合わせて丸められます。頂点と面の数", colours_between_bytes, LossSentence::own},
      {"loses_face_colours", "colours of faces, or faces without one among others", "面の色(または色のない面の区別)",
       face_colours},
      {"loses_weights", "weights of vertices", "頂点の重み",
       [](File f, Holds h) { return unless<Holds::weights>(h, [&] { return f.mesh.vertex_weights.size(); }); }},
      {"loses_groups", "names of groups", "グループ名",
       [](File f, Holds h) { return unless<Holds::groups>(h, [&] { return f.mesh.groups.names.size(); }); }},
      {"loses_objects", "names of objects", "オブジェクト名",
       [](File f, Holds h) { return unless<Holds::names>(h, [&] { return f.mesh.objects.names.size(); }); }},
      {"loses_smoothing", "smoothing groups", "スムージンググループ",
       [](File f, Holds h) { return unless<Holds::names>(h, [&] { return f.mesh.smoothing.names.size(); }); }},
      {"loses_materials", "names of materials", "マテリアル名",
       [](File f, Holds h) { return unless<Holds::names>(h, [&] { return f.mesh.materials.names.size(); }); }},
      {"loses_libraries", "material libraries", "マテリアルファイル",
       [](File f, Holds h) { return unless<Holds::names>(h, [&] { return f.material_libraries.size(); }); }},
      {"loses_properties", "further properties of vertices or faces", "頂点または面のその他のプロパティ",
       extra_properties, LossSentence::cannot_hold, nullptr, names_of_properties},
      {"loses_rules", "own rules of attributes, which get the usual rule of their type",
       "属性の独自の規則(型の標準の規則になります)", own_rules},
      {"loses_extra_elements", "rows of further elements, lines obj_info and unknown lines of a header",
       "その他の要素、obj_info の行、ヘッダーの未知の行", extra_rows},
      {"loses_comments", "lines of comments", "コメントの行", comments},
      {"loses_head", "the head of the binary STL file", "バイナリ STL ファイルの先頭部分", wordless_head},
      {"loses_unread_lines", "Reading left out lines that it does not understand, and they are not written; lines",
       "読み込み時に解釈できなかった行は書き出されません。行の数", [](File f, Holds) { return f.left_out.lines; },
       LossSentence::own},
      {"loses_unread_values",
       "Reading left out or rounded numbers and indices, and they are not written as they were; places",
       "読み込み時に無視した、または丸めた数と番号は、元のとおりには書き出されません。箇所の数",
       [](File f, Holds) { return f.left_out.values; }, LossSentence::own},
      {"loses_unread_rest",
       "Reading left out what stands behind the end of the mesh, and it is not written; lines or bytes",
       "読み込み時に無視した、メッシュの終わりより後の部分は書き出されません。行またはバイトの数",
       [](File f, Holds) { return f.left_out.rest; }, LossSentence::own},
  };
  return kinds;
}

Message Loss::message(const Text& format) const {
  const std::string number = std::to_string(count);
  if (kind->sentence == LossSentence::own)
    return make_message(Severity::warning, kind->code,
                        {std::string(kind->en) + ": " + number + ".", std::string(kind->ja) + ": " + number + "。"});
  constexpr std::size_t most_names = 5;
  std::string named;
  for (std::size_t i = 0; i < std::min(names.size(), most_names); ++i) named += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most_names) named += ", ...";
  const std::string vertex = first ? "v" + std::to_string(*first) : "";
  return make_message(Severity::warning, kind->code,
                      {format.en + " cannot hold " + std::string(kind->en) + ": " + number +
                           (first           ? " (the first is " + vertex + ")."
                            : named.empty() ? "."
                                            : " (" + named + ")."),
                       format.ja + " は次のものを保持できません: " + std::string(kind->ja) + " " + number + " 個" +
                           (first           ? "(最初は " + vertex + ")。"
                            : named.empty() ? "。"
                                            : "(" + named + ")。")});
}

std::vector<Loss> find_losses(const MeshFile& file, Holds held) {
  std::vector<Loss> losses;
  for (const LossKind& kind : loss_kinds())
    if (const std::uint64_t count = kind.count(file, held))
      losses.push_back({&kind, count, kind.first ? kind.first(file, held) : std::nullopt,
                        kind.names ? kind.names(file, held) : std::vector<std::string>()});
  return losses;
}

}  // namespace ryosen
