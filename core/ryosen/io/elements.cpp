#include "ryosen/io/elements.h"

#include <algorithm>

#include "ryosen/base/sort_unique.h"

namespace ryosen {

ElementTotals totals_of(const MeshFile& file) {
  ElementTotals totals;
  for (const LineElement& item : file.elements.items) ++(item.is_points ? totals.points : totals.lines);
  for (const PropertyTable& table : file.properties.tables) {
    const bool has_ends = std::any_of(table.properties.begin(), table.properties.end(), [](const Property& p) {
      return p.role == PropertyRole::vertex_number && !p.is_list;
    });
    if (table.kind == TableKind::other && has_ends) totals.lines += table.rows;
  }
  return totals;
}

std::vector<Vertex> vertices_on_lines(const MeshFile& file, std::size_t file_vertices) {
  std::vector<Vertex> on_lines;
  const auto add = [&](std::int64_t number) {
    if (number >= 0 && number < static_cast<std::int64_t>(file_vertices))
      on_lines.emplace_back(static_cast<std::uint32_t>(number));
  };
  const std::vector<std::int64_t>& vertices = file.elements.vertices;
  for (const LineElement& item : file.elements.items)
    if (!item.is_points) std::for_each_n(vertices.begin() + item.first, item.count, add);
  for (const std::int64_t number : vertices_named(file.properties)) add(number);
  sort_unique(on_lines);
  return on_lines;
}

ElementList renumbered(const ElementList& elements, std::span<const std::uint32_t> vertex_number,
                       std::span<const std::uint32_t> face_number, std::size_t old_vertices, std::size_t new_vertices) {
  const auto old_end = static_cast<std::int64_t>(std::min(old_vertices, vertex_number.size()));
  const auto file_end = static_cast<std::int64_t>(old_vertices), new_end = static_cast<std::int64_t>(new_vertices);
  ElementList out;
  std::size_t face = 0;
  std::uint32_t faces_before = 0;  // remaining faces below `face`
  for (LineElement item : elements.items) {
    for (; face < std::min<std::size_t>(item.before_face, face_number.size()); ++face) {
      if (face_number[face] != no_index) ++faces_before;
    }
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

}  // namespace ryosen
