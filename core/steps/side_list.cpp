#include "core/steps/side_list.h"

#include "core/base/sort_unique.h"
#include "core/mesh/circulate.h"
#include "core/mesh/names.h"

namespace ryosen::steps {

SideList::SideList(const Mesh& mesh) : all_faces(mesh.live().faces) {
  offsets.push_back(0);
  for (std::uint32_t f = 0; f < mesh.face_slots() && faces.size() < most_faces; ++f) {
    if (!mesh.is_alive(Face(f))) continue;
    for (const Halfedge h : loop(mesh, mesh.halfedge(Face(f)))) {
      sides.push_back({mesh.copy_point(mesh.from(h)).index, mesh.copy_point(mesh.to(h)).index,
                       static_cast<std::uint32_t>(faces.size()), h});
      points.emplace_back(sides.back().from);
    }
    faces.emplace_back(f);
    all_triangles = all_triangles && sides.size() - offsets.back() == 3;
    offsets.push_back(static_cast<std::uint32_t>(sides.size()));
  }
  sort_unique(points);
}

std::string SideList::name(std::uint32_t side) const { return slot_name(sides[side].halfedge); }

std::uint32_t SideList::next(std::uint32_t side) const {
  const std::uint32_t f = sides[side].face;
  return side + 1 < offsets[f + 1] ? side + 1 : offsets[f];
}

std::uint32_t SideList::prev(std::uint32_t side) const {
  const std::uint32_t f = sides[side].face;
  return side > offsets[f] ? side - 1 : offsets[f + 1] - 1;
}

Text SideList::remark() const {
  if (faces.size() == all_faces) return {};
  const std::string n = std::to_string(faces.size()), all = std::to_string(all_faces);
  return {"Only the first " + n + " of " + all + " faces are played.",
          "最初の " + n + " 面だけを再生します（全 " + all + " 面）。"};
}

std::optional<Text> why_no_side_list(const Mesh& mesh) {
  if (mesh.live().faces == 0)
    return Text{"There is no face to begin with; open a mesh with faces.",
                "面がありません。面のあるメッシュを開いてください。"};
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f)
    if (mesh.is_alive(Face(f)) && mesh.has_rings(Face(f))) {
      const std::string name = "f" + std::to_string(f);
      return Text{
          "The texts' lists hold faces with one loop; " + name + " has a ring: join it by a bridge (unite_ring) first.",
          "テキストの面はループが一つです。" + name +
              " にはリングがあります（先に unite_ring で橋をかけてください）。"};
    }
  return {};
}

}  // namespace ryosen::steps
