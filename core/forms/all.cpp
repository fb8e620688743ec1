#include "core/forms/all.h"

#include <array>

#include "core/forms/dcel.h"
#include "core/forms/face_adjacency.h"
#include "core/forms/halfedge.h"
#include "core/forms/halfedge_loop.h"
#include "core/forms/indexed_face_set.h"
#include "core/forms/kernel.h"
#include "core/forms/opposite_array.h"
#include "core/forms/opposite_map.h"
#include "core/forms/polygon_set.h"
#include "core/forms/triangle_soup.h"
#include "core/forms/winged_edge.h"

namespace ryosen::forms {

namespace {

template <class T>
std::unique_ptr<Form> make(const Mesh& mesh) {
  return std::make_unique<T>(mesh);
}

constexpr std::uint32_t surface = one_vertex_per_point | one_fan_per_vertex | no_wires | no_rings;
constexpr std::uint32_t list = one_fan_per_vertex | no_wires | no_rings | no_bridges;

constexpr auto no_halfedges = HalfedgesOf::none;
constexpr auto of_faces = HalfedgesOf::faces;
constexpr auto all_of_mesh = HalfedgesOf::all;

constexpr std::array form_rows{
    FormRow{"triangle_soup", "triangle soup", "三角形スープ", "table 1", "表 1",
            list | triangles | no_isolated_vertices | different_places, false, no_halfedges, false, make<TriangleSoup>},
    FormRow{"polygon_set", "polygon set", "ポリゴンセット", "data structures, 2.1", "データ構造 2.1",
            list | no_isolated_vertices | different_places, false, no_halfedges, false, make<PolygonSet>},
    FormRow{"indexed_face_set", "indexed face set", "インデックスフェースセット", "table 2", "表 2", list, true,
            no_halfedges, false, make<IndexedFaceSet>},
    FormRow{"face_adjacency", "face adjacency", "面の隣接", "table 3", "表 3", surface | no_bridges, true, no_halfedges,
            false, make<FaceAdjacency>},
    FormRow{"winged_edge", "winged edge", "ウィングドエッジ", "table 4", "表 4", surface | no_bridges, true,
            no_halfedges, false, make<WingedEdge>},
    FormRow{"halfedge", "halfedge", "半稜線", "table 5", "表 5", surface, true, of_faces, false,
            make<HalfedgeForm<false, false>>},
    FormRow{"halfedge_edges", "halfedge, edge records", "半稜線＋稜線", "tables 5, 6", "表 5・6", surface, true,
            of_faces, false, make<HalfedgeForm<false, true>>},
    FormRow{"halfedge_outside", "halfedge, also outside", "半稜線（外側にも）", "table 5, footnote 9", "表 5・脚注 9",
            one_vertex_per_point | no_rings, true, all_of_mesh, false, make<HalfedgeForm<true, false>>},
    FormRow{"halfedge_outside_edges", "halfedge, also outside, edge records", "半稜線（外側にも）＋稜線",
            "table 6, footnote 9", "表 6・脚注 9", one_vertex_per_point | no_rings, true, all_of_mesh, false,
            make<HalfedgeForm<true, true>>},
    FormRow{"halfedge_loop", "halfedge, loops and parent edges", "半稜線（ループ・親稜線）", "data structures, 3",
            "データ構造 3", one_vertex_per_point | no_rings, true, all_of_mesh, false, make<HalfedgeLoop>},
    FormRow{"opposite_map", "opposites 3i+j in a map", "反対辺 3i+j（マップ）", "halfedges without a class",
            "半辺（クラスなし）", surface | triangles, true, of_faces, false, make<OppositeMap>},
    FormRow{"opposite_array", "opposites 3i+j in arrays", "反対辺 3i+j（配列）", "the same, in arrays", "同、配列",
            surface | triangles, true, of_faces, false, make<OppositeArray>},
    FormRow{"dcel", "DCEL", "DCEL", "chapter 15.2", "15.2 節", one_vertex_per_point, true, all_of_mesh, false,
            make<Dcel>},
    FormRow{"ryosen", "Ryosen", "Ryosen", "this program", "本プログラム", any_mesh, true, all_of_mesh, true,
            make<Kernel>},
};

}  // namespace

std::span<const FormRow> all_forms() { return form_rows; }

const FormRow* find_form(std::string_view id) {
  for (const FormRow& row : form_rows)
    if (row.id == id) return &row;
  return nullptr;
}

}  // namespace ryosen::forms
