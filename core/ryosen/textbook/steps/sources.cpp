#include "ryosen/textbook/steps/sources.h"

#include <array>
#include <span>

#include "ryosen/base/rows.h"

namespace ryosen::steps {

namespace {

struct Shown {
  std::string_view id;
  Source source;
};

constexpr std::array shown{
    Shown{"make_vertex", {"002", "section 5, MakeVertex, figure 2", "5 節 MakeVertex（図 2）"}},
    Shown{"remove_vertex", {"002", "section 5, RemoveVertex, figure 2", "5 節 RemoveVertex（図 2）"}},
    Shown{"move_vertex", {"002", "section 5, MoveVertex, figure 3", "5 節 MoveVertex（図 3）"}},
    Shown{"make_edge", {"002", "section 5, MakeEdge, figure 4", "5 節 MakeEdge（図 4）"}},
    Shown{"delete_edge", {"002", "section 5, DeleteEdge, figure 4", "5 節 DeleteEdge（図 4）"}},
    Shown{"make_loop", {"002", "section 5, MakeLoop, figure 5", "5 節 MakeLoop（図 5）"}},
    Shown{"delete_loop", {"002", "section 5, DeleteLoop, figure 5", "5 節 DeleteLoop（図 5）"}},
    Shown{"separate_loop", {"002", "section 5, SeparateLoop, figure 6", "5 節 SeparateLoop（図 6）"}},
    Shown{"unite_loop", {"002", "section 5, UniteLoop, figure 6", "5 節 UniteLoop（図 6）"}},
    Shown{"separate_edge", {"002", "section 5, SeparateEdge, figure 7", "5 節 SeparateEdge（図 7）"}},
    Shown{"unite_edge", {"002", "section 5, UniteEdge, figure 7", "5 節 UniteEdge（図 7）"}},
    Shown{"make_ring", {"000", "section 2, H of the Euler-Poincare formula", "2 節 オイラー・ポアンカレの式の H"}},
    Shown{"unite_ring", {"000", "section 2, H of the Euler-Poincare formula", "2 節 オイラー・ポアンカレの式の H"}},
    Shown{"collapse", {"000", "section 5, figure 12", "5 節 図 12"}},
    Shown{"swap", {"000", "section 5, figure 13", "5 節 図 13"}},
    Shown{"split", {"003", "edge split", "辺細分"}},
};

constexpr std::array forms_shown{
    Shown{"triangle_soup", {"000", "section 3, table 1", "3 節 表 1"}},
    Shown{"polygon_set", {"002", "section 2.1, polygon set", "2.1 節 ポリゴンセット"}},
    Shown{"indexed_face_set",
          {"000", "section 3, table 2: all faces are looked through", "3 節 表 2（全ての面を探索）"}},
    Shown{"face_adjacency", {"000", "section 3, table 3: from face to face", "3 節 表 3（面から隣接面へ）"}},
    Shown{"winged_edge", {"000", "section 3, table 4", "3 節 表 4"}},
    Shown{"halfedge", {"000", "section 3, table 5", "3 節 表 5"}},
    Shown{"halfedge_edges", {"000", "section 3, tables 5 and 6", "3 節 表 5・6"}},
    Shown{"halfedge_outside", {"000", "section 3, table 5 with footnote 9", "3 節 表 5・脚注 9"}},
    Shown{"halfedge_outside_edges", {"000", "section 3, table 6 with footnote 9", "3 節 表 6・脚注 9"}},
    Shown{"halfedge_loop", {"002", "section 4, states in a fixed number of steps", "4 節 形状状態参照"}},
    Shown{"opposite_map", {"003", "operations of halfedges", "半辺の操作"}},
    Shown{"opposite_array",
          {"003", "operations of halfedges; the arrays are this program's", "半辺の操作（配列は本プログラムの追加）"}},
    Shown{"dcel", {"004", "sections 15.2 and 15.3", "15.2・15.3 節"}},
};

std::optional<Source> source_in(std::span<const Shown> rows, std::string_view id) {
  const Shown* const row = find_row(rows, id);
  return row ? std::optional(row->source) : std::nullopt;
}

}  // namespace

std::optional<Source> source_of_form(std::string_view id) { return source_in(forms_shown, id); }

std::optional<Source> source_of_operator(std::string_view id) { return source_in(shown, id); }

}  // namespace ryosen::steps
