// Where the source texts say what is played: one place for the names of their listings. A line counts from the first
// one of its listing as it is printed, blank lines included.
#pragma once

#include "ryosen/textbook/steps/step.h"

namespace ryosen::steps {

// Text 000.
constexpr Source code_2(int line) { return {"000", "program code 2", "プログラムコード 2", line}; }
constexpr Source code_3(int line) { return {"000", "program code 3", "プログラムコード 3", line}; }
constexpr Source code_4(int line) { return {"000", "program code 4", "プログラムコード 4", line}; }
inline constexpr Source collapse_and_swap_figures{"000", "section 5, figures 12 and 13", "5 節 図 12・13"};
inline constexpr Source euler_text{"000", "section 2, the Euler-Poincare formula", "2 節 オイラー・ポアンカレの式"};
inline constexpr Source hash_text{"000", "section 4, a hash", "4 節「ハッシュの使用」"};
inline constexpr Source vertex_lists_text{"000", "section 4, links from vertices",
                                          "4 節「頂点→ハーフエッジのリンクの利用」"};
inline constexpr Source matrix_text{"000", "section 4, a matrix", "4 節「行列を使う」"};
// Text 002.
inline constexpr Source problem_2{"002", "section 4, problem 2", "4 節 問題 2"};
inline constexpr Source loop_text{"002", "section 4, corners of a loop", "4 節 ループの角数"};
// Text 003: the first listing that fills opps, and the whole one behind the text.
constexpr Source map_code(int line) {
  return {"003", "building the halfedges, the listing that fills opps", "半辺データ構造の構築、opps を作るコード",
          line};
}
constexpr Source split_code(int line) {
  return {"003", "the whole source code, edge_split", "末尾のソースコード全体、edge_split", line};
}
// Text 004.
inline constexpr Source hull_text{"004", "section 15.2, use for the hull", "15.2 節「凸包での利用」"};
inline constexpr Source inner_loops_text{"004", "section 15.2, inner_components", "15.2 節 inner_components"};
inline constexpr Source horizon_text{"004", "section 15.3, the horizon", "15.3 節「ホライゾンの取得」"};

// Where the texts ask a form for its neighbours; none for one of this program alone.
std::optional<Source> source_of_form(std::string_view id);

// Where the texts show an operator; none for one of this program alone.
std::optional<Source> source_of_operator(std::string_view id);

}  // namespace ryosen::steps
