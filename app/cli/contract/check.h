// What `check` prints.
#pragma once

#include "app/cli/contract/shared_shapes.h"

namespace ryosen::cli {

inline constexpr JsonKey check_keys[] = {
    {"file", "string", "The file, as it was named.", "指定されたとおりのファイル名。"},
    {"format", "string", "Its format.", "ファイルの形式。", ids_of(Ids::formats)},
    {"status", "string", "warnings where there is a problem or a message of severity warning.",
     "問題または警告のメッセージがあれば warnings。", words("ok warnings")},
    {"vertices", "integer", "Vertices of the file; of STL after welding.", "ファイルの頂点数（STL では縫合後）。"},
    {"corners", "integer", "Corners of all faces of the file; of STL before welding.",
     "ファイルの面の角の総数（STL では縫合前）。"},
    {"faces", "integer", "Faces of the file, quarantined ones too.", "ファイルの面数（隔離された面を含む）。"},
    {"lines", "integer", "Line elements of the file; absent where it has none.",
     "ファイルの線の要素の数。なければ省く。", optional()},
    {"points", "integer", "Point elements of the file; absent where it has none.",
     "ファイルの点の要素の数。なければ省く。", optional()},
    {"edges", "integer", "Edges that usable faces have, between points, whatever their direction.",
     "使える面の稜線数（二点間、向きによらない）。"},
    {"triangles", "integer", "Faces of three corners, quarantined ones too.", "三角形の数（隔離された面を含む）。"},
    {"quads", "integer", "Faces of four corners, quarantined ones too.", "四角形の数（隔離された面を含む）。"},
    {"polygons", "integer", "Faces of five or more corners, quarantined ones too.",
     "五角以上の面の数（隔離された面を含む）。"},
    {"quarantined", "integer", "Faces that cannot take part in the mesh.", "隔離された面の数。"},
    {"rings", "integer", "Inner loops of faces.", "面の穴（リング）の数。"},
    {"boundary_edges", "integer", "Edges of one face.", "境界の稜線数。"},
    {"boundary_loops", "integer", "Boundary loops.", "境界ループの数。"},
    {"nonmanifold_edges", "integer", "Edges of three or more faces.", "非多様体の稜線数。"},
    {"max_edge_faces", "integer", "The most faces at one edge.", "一本の稜線に接する面の最大数。"},
    {"nonmanifold_vertices", "integer", "Vertices whose faces form no single fan, or where a non-manifold edge ends.",
     "非多様体の頂点数。"},
    {"bowtie_vertices", "integer", "Vertices where several fans of faces meet.", "複数の面の扇が集まる頂点の数。"},
    {"misoriented_edges", "integer", "Edges whose two faces are turned against each other.", "向きの不一致な稜線数。"},
    {"degenerate_repeat", "integer", "Quarantined faces that visit a vertex twice.",
     "同じ頂点を繰り返すため隔離された面の数。"},
    {"degenerate_area", "integer", "Faces whose corners lie on a line.", "面積ゼロの面の数。"},
    {"duplicate_faces", "integer", "Faces with the same vertices as an earlier one.", "重複面の数。"},
    {"hanging_pairs", "integer", "Pairs of triangles back to back that hang on one edge at most.",
     "縮退（背中合わせの三角形）の組の数。"},
    {"isolated_vertices", "integer", "Vertices that no face and no line uses.",
     "孤立頂点（面も線も使わない頂点）の数。"},
    {"nonfinite_vertices", "integer", "Vertices with a coordinate that is no finite number.",
     "座標が有限でない頂点の数。"},
    {"components", "integer", "Connected parts.", "連結成分の数。"},
    {"euler_characteristic", "integer", "Vertices that faces use, minus edges, plus faces, minus rings.",
     "オイラー標数（面が使う頂点 − 稜線 + 面 − リング）。"},
    {"genus", "integer or null", "Genus; null where the mesh is not manifold and orientable, or empty.",
     "種数。多様体で向き付け可能でないとき、または空のとき null。"},
    {"manifold", "boolean", "Whether there is no non-manifold edge and no bowtie vertex.", "多様体か。"},
    {"closed", "boolean", "Whether there are faces, and two at every edge.",
     "閉じているか（どの稜線にも二つの面がある）。"},
    {"orientable", "boolean", "Whether the faces can be turned so that all neighbours agree.",
     "隣り合う面の向きをすべて揃えられるか。"},
    {"bounds", "array of array of number or null",
     "Smallest and largest coordinates of faces, each x y z; null where no face has finite coordinates.",
     "面の座標の最小と最大（それぞれ x y z）。有限の座標の面がないとき null。"},
    {"area", "number or null", "Area of all faces with finite coordinates; null where it is too large for a number.",
     "座標が有限な面の面積の和。数に収まらないとき null。"},
    {"volume", "number or null",
     "Volume; null where the mesh is not closed, manifold and consistently oriented with finite coordinates.",
     "体積。閉じた多様体で、向きが揃い、座標が有限でないとき null。"},
    {"kind", "string", "What the mesh is, in one word.", "メッシュの種類。", ids_of(Ids::mesh_kinds)},
    {"kind_reason", "object", "Why, with the element that shows it.", "その理由と、それを示す要素。",
     objects(sentence_shape)},
    {"hash", "string", "Of places and connectivity; equal for equal meshes on every machine.",
     "位置と接続のハッシュ値。同じメッシュならどの環境でも同じ。"},
    {"problems", "array of object", "What is wrong, and what is worth to know.", "問題と注意すべきこと。",
     objects(problem_shape)},
    {"messages", "array of object", "What reading had to say.", "読み込み時のメッセージ。", objects(message_shape)},
};
inline constexpr Shape check_shape{"check", "One per file.", "ファイルごとに一行。", check_keys};

inline constexpr const Shape* check_lines[] = {&check_shape};
inline constexpr ExitCode check_exits[] = {ExitCode::found_problems, ExitCode::input_missing, ExitCode::input_malformed,
                                           ExitCode::some_inputs_failed};
inline constexpr Contract check_contract{check_lines, check_exits};

}  // namespace ryosen::cli
