#include "ryosen/io/edited_file.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "ryosen/base/sort_unique.h"
#include "ryosen/io/format.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {
namespace {

// Without wires that coincide with lines, so that they do not occur twice when the file is read again.
std::vector<std::pair<std::uint32_t, std::uint32_t>> wires_beside(const ElementList& lines, const Mesh& mesh,
                                                                  const std::vector<std::uint32_t>& number) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wires;
  for (const Edge e : live_edges(mesh)) {
    if (!mesh.is_wire(e)) continue;
    const auto [a, b] = ends(mesh, e);
    wires.push_back(std::minmax(number[a.index], number[b.index]));
  }
  if (wires.empty()) return wires;
  sort_unique(wires);
  std::set<std::pair<std::int64_t, std::int64_t>> drawn;
  for (const LineElement& item : lines.items)
    for (std::uint32_t i = 1; !item.is_points && i < item.count; ++i)
      drawn.insert(std::minmax(lines.vertices[item.first + i - 1], lines.vertices[item.first + i]));
  std::erase_if(wires, [&](const auto& wire) { return drawn.contains(wire); });
  return wires;
}

// Leaves out the entries of a pool that neither corners nor `quarantined` faces nor lines use.
void drop_unused(CornerValues& values, std::vector<QuarantinedFace>& quarantine,
                 CompactList<std::uint32_t> QuarantinedFace::*quarantined, std::vector<std::uint32_t>& of_lines) {
  std::vector<std::uint32_t> number(values.pool.size(), no_index);
  const auto for_each_use = [&](const auto& visit) {
    for (std::uint32_t& entry : values.index)
      if (entry < number.size()) visit(entry);
    for (std::uint32_t& entry : of_lines)
      if (entry < number.size()) visit(entry);
    for (QuarantinedFace& face : quarantine)
      for (std::uint32_t& entry : face.*quarantined)
        if (entry < number.size()) visit(entry);
  };
  for_each_use([&](std::uint32_t entry) { number[entry] = 0; });
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < number.size(); ++i) {
    if (number[i] == no_index) continue;
    values.pool[kept] = values.pool[i];
    number[i] = kept++;
  }
  if (kept == values.pool.size()) return;
  values.pool.resize(kept);
  for_each_use([&](std::uint32_t& entry) { entry = number[entry]; });
}

// Those of the numbers that are vertices of the file, ascending, each once.
std::vector<Vertex> existing_vertices(const std::vector<std::int64_t>& numbers, std::size_t file_vertices) {
  std::vector<Vertex> found;
  for (const std::int64_t number : numbers)
    if (number >= 0 && number < static_cast<std::int64_t>(file_vertices))
      found.emplace_back(static_cast<std::uint32_t>(number));
  sort_unique(found);
  return found;
}

// In a format without pools of its own one with an entry per vertex has those of isolated vertices too.
bool has_pools(const MeshFile& file) {
  return !file.format || !file.format->holds || holds(file.format->holds(file.encoding), Holds::corner_normals);
}

}  // namespace

ElementTotals totals_of(const MeshFile& file) {
  ElementTotals totals;
  for (const LineElement& item : file.elements.items) ++(item.is_points ? totals.points : totals.lines);
  for (const PropertyTable& table : file.properties.tables) {
    const bool has_ends = std::any_of(table.properties.begin(), table.properties.end(), [](const Property& p) {
      return p.role == PropertyRole::vertex_number && !p.is_list;
    });
    if (table.is_further() && has_ends) totals.lines += table.rows;
  }
  return totals;
}

std::vector<Vertex> vertices_on_lines(const MeshFile& file, std::size_t file_vertices) {
  std::vector<std::int64_t> numbers = vertices_named(file.properties);
  for (const LineElement& item : file.elements.items)
    if (!item.is_points)
      std::copy_n(file.elements.vertices.begin() + item.first, item.count, std::back_inserter(numbers));
  return existing_vertices(numbers, file_vertices);
}

ElementList renumbered(const ElementList& elements, std::span<const std::uint32_t> vertex_number,
                       std::span<const std::uint32_t> face_number, std::size_t old_vertices, std::size_t new_vertices) {
  const auto old_end = static_cast<std::int64_t>(std::min(old_vertices, vertex_number.size()));
  const auto file_end = static_cast<std::int64_t>(old_vertices), new_end = static_cast<std::int64_t>(new_vertices);
  ElementList out;
  std::size_t face = 0;
  std::uint32_t faces_before = 0;  // remaining faces below `face`
  for (LineElement item : elements.items) {
    for (; face < std::min<std::size_t>(item.before_face, face_number.size()); ++face)
      if (face_number[face] != no_index) ++faces_before;
    item.before_face = faces_before;
    const std::uint32_t first = item.first, count = item.count;
    item.first = static_cast<std::uint32_t>(out.vertices.size());
    for (std::uint32_t i = first; i < first + count; ++i) {
      std::int64_t vertex = elements.vertices[i];
      if (vertex >= file_end) {
        vertex = past_new_end(vertex, file_end, new_end);
      } else if (vertex >= 0) {
        if (vertex >= old_end || vertex_number[static_cast<std::size_t>(vertex)] == no_index) continue;
        vertex = vertex_number[static_cast<std::size_t>(vertex)];
      }
      out.vertices.push_back(vertex);
      if (!elements.texcoords.empty()) out.texcoords.push_back(elements.texcoords[i]);
    }
    item.count = static_cast<std::uint32_t>(out.vertices.size()) - item.first;
    const std::uint32_t least = item.is_points ? 1 : 2;
    if (item.count < count && item.count < least) {
      out.vertices.resize(item.first);
      if (!elements.texcoords.empty()) out.texcoords.resize(item.first);
    } else {
      out.items.push_back(item);
    }
  }
  return out;
}

std::vector<Vertex> used_beside_the_mesh(const MeshFile& source, std::span<const QuarantinedFace> quarantine,
                                         std::size_t file_vertices) {
  std::vector<std::int64_t> numbers = vertices_named(source.properties);
  for (const QuarantinedFace& face : quarantine)
    numbers.insert(numbers.end(), face.corners.begin(), face.corners.end());
  numbers.insert(numbers.end(), source.elements.vertices.begin(), source.elements.vertices.end());
  return existing_vertices(numbers, file_vertices);
}

MeshFile edited_file(const MeshFile& source, const Mesh& mesh, const FileTables& tables) {
  MeshFile file = source;
  CompactMesh compact = to_indexed(mesh, tables, used_beside_the_mesh(source, tables.quarantine, mesh.file_vertices()));
  const std::size_t new_vertices = compact.mesh.positions.size();
  file.elements =
      renumbered(source.elements, compact.vertex_number, compact.face_number, mesh.file_vertices(), new_vertices);
  file.properties = renumbered(source.properties, compact.vertex_number, compact.face_number, mesh.file_vertices(),
                               new_vertices, compact.mesh.face_count());
  file.kept_vertices = compact.kept_vertices;
  file.wires = wires_beside(file.elements, mesh, compact.vertex_number);
  file.mesh = std::move(compact.mesh);
  return file;
}

void drop_unused_values(MeshFile& file) {
  IndexedMesh& mesh = file.mesh;
  const auto may_be_of_vertices = [&](const CornerValues& values) {
    return !has_pools(file) && values.pool.size() == mesh.positions.size();
  };
  std::vector<std::uint32_t> no_lines;
  if (!may_be_of_vertices(mesh.texcoords))
    drop_unused(mesh.texcoords, mesh.quarantine, &QuarantinedFace::texcoords, file.elements.texcoords);
  if (!may_be_of_vertices(mesh.normals))
    drop_unused(mesh.normals, mesh.quarantine, &QuarantinedFace::normals, no_lines);
}

}  // namespace ryosen
