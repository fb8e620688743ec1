#include "core/steps/sources.h"

#include <array>

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
    Shown{"collapse", {"000", "figure 12", "図 12"}},
    Shown{"swap", {"000", "figure 13", "図 13"}},
    Shown{"split", {"003", "edge split", "辺細分"}},
};

}  // namespace

std::optional<Source> source_of_operator(std::string_view id) {
  for (const Shown& row : shown)
    if (row.id == id) return row.source;
  return {};
}

}  // namespace ryosen::steps
