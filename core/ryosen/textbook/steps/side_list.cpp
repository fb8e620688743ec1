#include "ryosen/textbook/steps/side_list.h"

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/names.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::steps {

SideList::SideList(const Mesh& mesh) : all_faces(mesh.live().faces) {
  offsets.push_back(0);
  for (std::uint32_t f = 0; f < mesh.face_slots() && faces.size() < most_faces; ++f) {
    if (!mesh.is_alive(Face(f))) continue;
    add_loop(mesh, mesh.halfedge(Face(f)));
    for (const Halfedge ring : forms::inner_loops(mesh, Face(f))) {
      add_loop(mesh, ring);
      has_rings = true;
    }
    faces.emplace_back(f);
    all_triangles = all_triangles && sides.size() - offsets.back() == 3;
    offsets.push_back(static_cast<std::uint32_t>(sides.size()));
  }
  sort_unique(points);
}

void SideList::add_loop(const Mesh& mesh, Halfedge start) {
  const auto first = static_cast<std::uint32_t>(sides.size());
  for (const Halfedge h : loop(mesh, start)) {
    const auto side = static_cast<std::uint32_t>(sides.size());
    sides.push_back({mesh.copy_point(mesh.from(h)).index, mesh.copy_point(mesh.to(h)).index,
                     static_cast<std::uint32_t>(faces.size()), h, side + 1, side - 1});
    points.emplace_back(sides.back().from);
  }
  sides[first].prev = static_cast<std::uint32_t>(sides.size()) - 1;
  sides.back().next = first;
}

std::vector<std::uint32_t> SideList::rings_of(std::uint32_t face) const {
  std::vector<std::uint32_t> starts;
  for (std::uint32_t side = offsets[face] + 1; side < offsets[face + 1]; ++side)
    if (sides[side].prev >= side) starts.push_back(side);
  return starts;
}

std::string SideList::name(std::uint32_t side) const { return slot_name(sides[side].halfedge); }

Text SideList::remark() const {
  Text rings;
  if (has_rings)
    rings = {"The texts' lists hold faces with one loop; rings are listed behind it, as text 004's inner components.",
             "テキストの面はループが一つです。リングはその後に並べます（テキスト 004 の inner_components）。"};
  if (faces.size() == all_faces) return rings;
  const std::string n = std::to_string(faces.size()), all = std::to_string(all_faces);
  const Text part{"Only the first " + n + " of " + all + " faces are played.",
                  "最初の " + n + " 面だけを再生します（全 " + all + " 面）。"};
  return rings.en.empty() ? part : part + Text{" ", ""} + rings;
}

std::optional<Text> why_no_side_list(const Mesh& mesh) {
  if (mesh.live().faces == 0)
    return Text{"There is no face to begin with; open a mesh with faces.",
                "面がありません。面のあるメッシュを開いてください。"};
  return {};
}

}  // namespace ryosen::steps
