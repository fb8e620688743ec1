#include "app/editor/textbook/figures.h"

#include "app/editor/commands/text/words.h"
#include "ryosen/base/rows.h"
#include "ryosen/io/formats.h"

namespace ryosen {

namespace {

constexpr Figure figure_rows[] = {
    {"000-3", "Figure 3: a tetrahedron", "図3：四面体",
     "The text gives the counts V 4, E 6, F 4; it is drawn with equal edges.",
     "本文の数 V 4、E 6、F 4 から。稜線の長さは等しくした。"},
    {"000-4a", "Figure 4, left: a cube", "図4（左）：立方体", "The text gives V 8, E 12, F 6.",
     "本文の数 V 8、E 12、F 6 から。"},
    {"000-4b", "Figure 4, middle: a cube with one through-hole", "図4（中央）：貫通穴が一つの立方体",
     "The text gives V 16, E 24, F 10, H 2, g 1: a square hole through two faces, which become rings.",
     "本文の数 V 16、E 24、F 10、H 2、g 1 から。二つの面を貫く四角い穴とした。"},
    {"000-4c", "Figure 4, right: a cube with two through-holes", "図4（右）：貫通穴が二つの立方体",
     "The text gives V 24, E 36, F 14, H 4, g 2: two such holes side by side.",
     "本文の数 V 24、E 36、F 14、H 4、g 2 から。同じ穴を二つ並べた。"},
    {"000-5a", "Figure 5, left: a surface with a boundary", "図5（左）：境界付き多様体",
     "The text asks for one or two faces at each edge: a bent sheet of 4 by 2 quads.",
     "稜線に面が一つか二つという条件から。曲がった 4 × 2 の四角形の面とした。"},
    {"000-5b", "Figure 5, right: three faces at an edge", "図5（右）：非多様体",
     "The text has an edge with three or more faces in the middle: the sheet flat, with a wall along its middle.",
     "中央の稜線に三つ以上の面という条件から。平らな面の中央に壁を立てた。"},
    {"000-11", "Figure 11: a torus as an indexed list", "図11：トーラスの頂点と面の列",
     "The first vertices and faces are in the text. They lie on a circle of radius 30 about (-70, 0, 0), 16 to a turn; "
     "448 "
     "vertices are then 28 such circles about the Y axis, and the first face says which way they go on.",
     "本文にある最初の頂点は (-70, 0, 0) を中心とする半径 30 の円を 16 等分した点。448 頂点から Y "
     "軸のまわりに 28 個、最初の面から回る向きが決まる。"},
    {"000-12", "Figure 12: the edge 0-1 collapses", "図12：稜線削除（0-1）",
     "From program code 4: the halfedges (1) to (3) and (4) to (6) are the first two faces, (7) to (10) lie around "
     "them; "
     "each "
     "end has six neighbours.",
     "プログラムコード 4 から。半稜線 (1)〜(3) と (4)〜(6) が最初の二面、(7)〜(10) がその外側。両端の次数は 6。"},
    {"000-13", "Figure 13: the edge 0-1 is swapped", "図13：稜線交換（0-1）", "As figure 12.", "図12 と同じ。"},
    {"000-14", "Figure 14: the edge 0-1 may not collapse", "図14：稜線削除で問題が生じる稜線（0-1）",
     "The rule above it: three vertices are neighbours of both ends. The third, v2, lies outside the triangle that "
     "holds "
     "v3, so that two triangles would hang on one edge.",
     "図の上の規則から。両端に共通する隣接頂点が三つあり、三つ目の v2 は v3 "
     "のある三角形の外側。削除すると二つの三角形が一つの稜線にぶら下がる。"},
    {"000-15", "Figure 15: the edge 0-1 may not be swapped", "図15：稜線交換で問題が生じる稜線（0-1）",
     "The rule above it: the new ends, v2 and v3, are joined by an edge already.",
     "図の上の規則から。交換後の両端 v2 と v3 がすでに稜線で結ばれている。"},
    {"002-1", "Figure 1: one loop with three edges", "図1：ループ L1 の三角形",
     "The table below it: v1 to v3, e1 to e3, h1 to h6, L1 are a triangle.",
     "図の下の表の v1〜v3、e1〜e3、h1〜h6、L1 から。"},
    {"002-sample", "The sample program's triangle", "サンプルプログラムの三角形",
     "Its coordinates stand in the listing.", "座標はプログラムにある。"},
    {"003-image22", "image22: two faces", "image22：二つの面",
     "The text gives five edges, six halfedges, and a vertical edge in the middle. Faces run clockwise in this text: "
     "they "
     "are seen from behind.",
     "本文の稜線 5、半稜線 6、中央の縦線から。このテキストの面は時計回りなので、裏から見ることになる。"},
    {"003-image24", "image24: the halfedges 11 and 21", "image24：半稜線 11 と 21",
     "The faces 3 and 7 lie side by side, and the opposite of 11 is 21; the faces beside them are ours.",
     "面 3 と 7 が隣り合い、11 の対が 21。残りの面は補った。"},
    {"003-image32", "image32: an edge before its split", "image32：辺細分の前（内部）",
     "The listing of image34 names v0 to v3; it splits the halfedge 0, from v3 to v0.",
     "image34 のコードの v0〜v3 から。半稜線 0（v3 → v0）を細分する。"},
    {"003-image36", "image36: a boundary edge before its split", "image36：辺細分の前（境界）",
     "The listing names v0 to v2; it splits the halfedge 0, from v2 to v0.",
     "コードの v0〜v2 から。半稜線 0（v2 → v0）を細分する。"},
    {"003-image41", "image41: the hexagon", "image41：正六角形",
     "Face i is (i + 1, i + 2, centre 0): so the numbers that the text reports after its splits come out.",
     "面 i は (i + 1, i + 2, 中心 0)。細分後に本文の番号になるのはこの並び。"},
    {"003-image42", "image42: after the split at halfedge 1", "image42：半稜線 1 の細分の後",
     "The text's split of image41 by hand.", "image41 を本文の手順で細分したもの。"},
    {"003-image43", "image43: after the split at halfedge 4", "image43：半稜線 4 の細分の後",
     "The same again; the opposite of 1 is 3, and 24 is a boundary.", "さらに細分したもの。1 の対は 3、24 は境界。"},
};

}  // namespace

std::span<const Figure> figures() { return figure_rows; }

const Figure* find_figure(std::string_view id) { return find_row(figure_rows, id); }

std::string figure_ids() { return joined_ids(figure_rows); }

Result<MeshFile> mesh_of_figure(const Figure& figure) {
  const FigureFile* const file = find_row(figure_files(), figure.id);
  return read_mesh(file->bytes, *find_format(file->format));
}

}  // namespace ryosen
