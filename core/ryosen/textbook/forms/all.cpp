#include "ryosen/textbook/forms/all.h"

#include <array>

#include "ryosen/base/rows.h"
#include "ryosen/textbook/forms/dcel.h"
#include "ryosen/textbook/forms/face_adjacency.h"
#include "ryosen/textbook/forms/halfedge.h"
#include "ryosen/textbook/forms/halfedge_loop.h"
#include "ryosen/textbook/forms/indexed_face_set.h"
#include "ryosen/textbook/forms/kernel.h"
#include "ryosen/textbook/forms/opposite_array.h"
#include "ryosen/textbook/forms/opposite_map.h"
#include "ryosen/textbook/forms/polygon_set.h"
#include "ryosen/textbook/forms/triangle_soup.h"
#include "ryosen/textbook/forms/winged_edge.h"

namespace ryosen::forms {

namespace {

template <class T>
std::unique_ptr<Form> make(const Mesh& mesh) {
  return std::make_unique<T>(mesh);
}

template <bool outside, bool edge_records>
std::unique_ptr<Form> make_halfedges(const Mesh& mesh) {
  return std::make_unique<HalfedgeForm>(mesh, outside, edge_records);
}

constexpr std::uint32_t surface = one_vertex_per_point | one_fan_per_vertex | no_wires | no_rings;
constexpr std::uint32_t list = one_fan_per_vertex | no_wires | no_rings | no_bridges;

constexpr auto no_halfedges = HalfedgesOf::none;
constexpr auto of_faces = HalfedgesOf::faces;
constexpr auto all_of_mesh = HalfedgesOf::all;

constexpr std::array form_rows{
    FormRow{"triangle_soup", "triangle soup", "三角形スープ", "text 000, table 1", "テキスト 000 表 1",
            list | triangles | no_isolated_vertices | different_places, false, no_halfedges, false, make<TriangleSoup>},
    FormRow{"polygon_set", "polygon set", "ポリゴンセット", "text 002, section 2.1", "テキスト 002 の 2.1 節",
            list | no_isolated_vertices | different_places, false, no_halfedges, false, make<PolygonSet>},
    FormRow{"indexed_face_set", "indexed face set", "インデックスフェースセット", "text 000, table 2",
            "テキスト 000 表 2", list, true, no_halfedges, false, make<IndexedFaceSet>},
    FormRow{"face_adjacency", "face adjacency", "面の隣接", "text 000, table 3", "テキスト 000 表 3",
            surface | no_bridges, true, no_halfedges, false, make<FaceAdjacency>},
    FormRow{"winged_edge", "winged edge", "ウィングドエッジ", "text 000, table 4", "テキスト 000 表 4",
            surface | no_bridges, true, no_halfedges, false, make<WingedEdge>},
    FormRow{"halfedge", "halfedge", "半稜線", "text 000, table 5", "テキスト 000 表 5", surface, true, of_faces, false,
            make_halfedges<false, false>},
    FormRow{"halfedge_edges", "halfedge, edge records", "半稜線＋稜線", "text 000, tables 5, 6", "テキスト 000 表 5・6",
            surface, true, of_faces, false, make_halfedges<false, true>},
    FormRow{"halfedge_outside", "halfedge, also outside", "半稜線（外側にも）", "text 000, table 5, footnote 9",
            "テキスト 000 表 5・脚注 9", one_vertex_per_point | no_rings, true, all_of_mesh, false,
            make_halfedges<true, false>},
    FormRow{"halfedge_outside_edges", "halfedge, also outside, edge records", "半稜線（外側にも）＋稜線",
            "text 000, table 6, footnote 9", "テキスト 000 表 6・脚注 9", one_vertex_per_point | no_rings, true,
            all_of_mesh, false, make_halfedges<true, true>},
    FormRow{"halfedge_loop", "halfedge, loops and parent edges", "半稜線（ループ・親稜線）", "text 002, section 3",
            "テキスト 002 の 3 節", one_vertex_per_point | no_rings, true, all_of_mesh, false, make<HalfedgeLoop>},
    FormRow{"opposite_map", "opposites 3i+j in a map", "反対辺 3i+j（マップ）", "text 003, the map opps",
            "テキスト 003 のマップ opps", surface | triangles, true, of_faces, false, make<OppositeMap>},
    FormRow{"opposite_array", "opposites 3i+j in arrays", "反対辺 3i+j（配列）", "text 003, the same in arrays",
            "テキスト 003、同じものを配列で", surface | triangles, true, of_faces, false, make<OppositeArray>},
    FormRow{"dcel", "DCEL", "DCEL", "text 004, section 15.2", "テキスト 004 の 15.2 節", one_vertex_per_point, true,
            all_of_mesh, false, make<Dcel>},
    FormRow{"ryosen", "Ryosen", "Ryosen", "this program", "本プログラム", any_mesh, true, all_of_mesh, true,
            make<Kernel>},
};

}  // namespace

std::span<const FormRow> all_forms() { return form_rows; }

const FormRow* find_form(std::string_view id) { return find_row(form_rows, id); }

}  // namespace ryosen::forms
