#include "ryosen/indexed/indexed.h"
#include "ryosen/base/sort_unique.h"

#include <algorithm>
#include <unordered_set>

namespace ryosen {
namespace {

// The out-of-range vertex number to report: the first negative one, else the largest.
std::int64_t stray_corner(const CompactList<std::int64_t>& corners) {
  for (const std::int64_t corner : corners)
    if (corner < 0) return corner;
  return corners.empty() ? -1 : *std::max_element(corners.begin(), corners.end());
}

std::int64_t repeated_corner(const CompactList<std::int64_t>& corners) {
  std::unordered_set<std::int64_t> seen;
  for (const std::int64_t corner : corners)
    if (!seen.insert(corner).second) return corner;
  return -1;
}

}  // namespace

Text QuarantinedFace::cause() const {
  const std::string name = "f" + std::to_string(face);
  if (code == "face_too_few_corners") {
    const std::string count = std::to_string(corners.size());
    return {"Face " + name + " is set aside: it has " + count + (corners.size() == 1 ? " corner" : " corners") +
                " and a face needs at least 3.",
            "面 " + name + " は隔離されています: 頂点が " + count + " 個しかありません(3 個以上必要です)。"};
  }
  if (code == "index_out_of_range") {
    const std::int64_t stray = stray_corner(corners);
    if (stray < 0) {
      return {"Face " + name + " is set aside: it names a vertex before the first one.",
              "面 " + name + " は隔離されています: 最初の頂点より前の番号を参照しています。"};
    }
    const std::string vertex = "v" + std::to_string(stray);
    return {"Face " + name + " is set aside: it names vertex " + vertex + ", which does not exist.",
            "面 " + name + " は隔離されています: 存在しない頂点 " + vertex + " を参照しています。"};
  }
  const std::string vertex = "v" + std::to_string(repeated_corner(corners));
  return {"Face " + name + " is set aside: it visits vertex " + vertex + " more than once.",
          "面 " + name + " は隔離されています: 頂点 " + vertex + " を 2 回以上通ります。"};
}

bool QuarantinedFace::has_corners_within(std::size_t vertices) const {
  return std::all_of(corners.begin(), corners.end(), [vertices](std::int64_t corner) {
    return corner >= 0 && static_cast<std::uint64_t>(corner) < vertices;
  });
}

std::optional<std::vector<std::uint32_t>> per_vertex(const IndexedMesh& mesh, const CornerValues& values) {
  if (values.pool.empty() || values.index.size() != mesh.corners.size()) return std::nullopt;
  const std::size_t count = mesh.positions.size();
  std::vector<std::uint32_t> out(count, no_index);
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const std::uint32_t index = values.index[i];
    if (index >= values.pool.size()) return std::nullopt;
    std::uint32_t& known = out[mesh.corners[i]];
    if (known == no_index) known = index;
    if (known != index && values.pool[known] != values.pool[index]) return std::nullopt;
  }
  for (std::size_t v = 0; v < count; ++v)
    if (out[v] == no_index && values.pool.size() == count) out[v] = static_cast<std::uint32_t>(v);
  if (std::all_of(out.begin(), out.end(), [](std::uint32_t index) { return index == no_index; })) return std::nullopt;
  return out;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_of_faces(const IndexedMesh& mesh) {
  using Ends = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Ends> edges, ways;
  edges.reserve(mesh.corners.size());
  auto bridged = mesh.bridged.begin();
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const std::span<const std::uint32_t> corners = mesh.face(f);
    const bool has_bridges = bridged != mesh.bridged.end() && *bridged == f;
    if (has_bridges) ++bridged;
    ways.clear();
    for (std::size_t i = 0; i < corners.size(); ++i)
      ways.emplace_back(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]);
    if (has_bridges) std::sort(ways.begin(), ways.end());
    for (const Ends& way : ways)
      if (!has_bridges || !std::binary_search(ways.begin(), ways.end(), Ends{way.second, way.first}))
        edges.push_back(std::minmax({way.first, way.second}));
  }
  sort_unique(edges);
  return edges;
}

}  // namespace ryosen
