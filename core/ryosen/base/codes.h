// The codes of messages: stable identifiers that scripts and tests may rely on, while sentences may change. To add one,
// write its row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>

namespace ryosen {

// The severities with which a code occurs.
enum class CodeSeverity : std::uint8_t { error, warning, error_or_warning, info };

struct CodeRow {
  std::string_view id;
  CodeSeverity severity;
  std::string_view en, ja;  // a general sentence; the single message is more specific
  // About a file that the mesh does not depend on: such a warning does not set the exit code of `check`.
  bool is_about_other_file = false;
};

namespace codes {

using enum CodeSeverity;

// Grouped by topic, alphabetical within a group.
inline constexpr CodeRow rows[] = {
    // The command line and the lines of scripts.
    {"bad_arguments", error, "The words behind a command do not fit it.", "コマンドの引数が正しくありません。"},
    {"bad_value", error, "The value of a flag cannot be used.", "フラグの値が使えません。"},
    {"element_unknown", error, "A name means no element that ever existed.",
     "名前に当たる要素が、存在したことがありません。"},
    {"flag_missing", error, "A flag needs another one.", "フラグが、別のフラグを必要とします。"},
    {"flag_repeated", error, "A flag is given twice.", "フラグが二度指定されています。"},
    {"flag_takes_no_value", error, "A flag that takes no value is given one.", "値を取らないフラグに値があります。"},
    {"flags_exclude", error, "Two flags exclude each other.", "同時に指定できないフラグがあります。"},
    {"line_malformed", error, "A line does not parse.", "行を解釈できません。"},
    {"name_ambiguous", error, "A name fits several elements.", "名前が複数の要素に当てはまります。"},
    {"operand_missing", error, "A command has too few operands.", "コマンドの引数が足りません。"},
    {"operand_too_many", error, "A command has too many operands.", "コマンドの引数が多すぎます。"},
    {"output_missing", error, "No output is named.", "出力先が指定されていません。"},
    {"unknown_command", error, "There is no such command.", "そのようなコマンドはありません。"},
    {"unknown_flag", error, "The command has no such flag.", "コマンドにそのようなフラグはありません。"},
    {"unknown_highlight", error, "There is no such highlight.", "そのような強調表示はありません。"},
    {"unknown_operator", error, "There is no such operator, or it does not work on an edge.",
     "そのような操作はないか、稜線に対する操作ではありません。"},
    {"unknown_tool", error, "There is no such tool.", "そのようなツールはありません。"},
    {"usage", error, "Flags are missing, or do not go together.", "フラグが足りないか、組み合わせられません。"},
    {"value_missing", error, "A flag has no value.", "フラグの値がありません。"},

    // Running the program.
    {"cancelled", error, "The command was interrupted.", "コマンドが中止されました。"},
    {"command_failed", error, "A command of a script failed.", "スクリプトのコマンドが失敗しました。"},
    {"image_sizes_differ", error, "The picture and the one to compare with have different sizes.",
     "比較する画像と大きさが異なります。"},
    {"internal_error", error, "The program itself is wrong.", "プログラム自体の誤りです。"},
    {"mesh_refused", error, "The mesh is none that an algorithm can be done on.",
     "アルゴリズムを適用できないメッシュです。"},
    {"no_display", error, "There is no display.", "ディスプレイがありません。"},
    {"no_render_backend", error, "Nothing was found that draws.", "描画する手段が見つかりません。"},
    {"out_of_memory", error, "There is not enough memory.", "メモリが足りません。"},
    {"pictures_differ", error, "The picture differs from the one to compare with.", "比較する画像と異なります。"},
    {"png_malformed", error, "A picture cannot be read as PNG.", "画像を PNG として読めません。"},
    {"refused", error_or_warning,
     "A command, or an output that --strict forbids, was refused; a warning where the run goes on.",
     "コマンドまたは --strict での書き出しが拒否されました（続行するときは警告）。"},
    {"shader_refused", error, "The graphics driver refuses a shader.",
     "グラフィックスドライバーがシェーダーを受け付けません。"},

    // Input files and folders.
    {"folder_empty", error, "A folder holds no mesh that can be read.", "フォルダに読めるメッシュがありません。"},
    {"folder_unreadable", error, "A folder cannot be read.", "フォルダを読めません。"},
    {"input_is_folder", error, "The input is a folder.", "入力がフォルダです。"},
    {"input_missing", error, "There is no such input.", "入力がありません。"},
    {"input_not_a_file", error, "The input is a pipe, a device or a socket.",
     "入力が通常のファイルではありません（パイプ、デバイス、ソケット）。"},
    {"input_unreadable", error, "The system does not let the input be read.", "入力を読めません。"},

    // File formats.
    {"binary_content", error, "The content is binary and of no known format.", "内容が未知のバイナリデータです。"},
    {"compressed_file", error, "The file is compressed.", "ファイルが圧縮されています。"},
    {"compressed_twice", error, "The content of a gzip file is itself a gzip file.",
     "gzip ファイルの中身がさらに gzip で圧縮されています。"},
    {"content_mismatch", error_or_warning,
     "The name says another format than the content; read by the content where there is a warning.",
     "ファイル名と内容の形式が異なります（警告のときは内容に従って読みます）。"},
    {"empty_file", error, "The file is empty.", "ファイルが空です。"},
    {"gzip_cut", error, "A gzip file ends too early.", "gzip ファイルが途中で終わっています。"},
    {"gzip_damaged", error, "A gzip file is damaged.", "gzip ファイルが壊れています。"},
    {"gzip_extra_data", error, "A gzip file goes on with something that is not compressed.",
     "gzip ファイルの終わりの後に、圧縮されていないデータがあります。"},
    {"gzip_too_large", error, "A gzip file holds more than is unpacked.",
     "gzip ファイルの中身が展開の上限を超えています。"},
    {"not_obj", error, "The content is not OBJ.", "内容が OBJ ではありません。"},
    {"not_off", error, "The content is not OFF.", "内容が OFF ではありません。"},
    {"not_ply", error, "The content is not PLY.", "内容が PLY ではありません。"},
    {"not_stl", error, "The content is not STL.", "内容が STL ではありません。"},
    {"nul_byte", error, "A text holds a NUL byte.", "テキストに NUL バイトがあります。"},
    {"unknown_format", error, "The format to read or to write is not known.", "読み書きする形式が決まりません。"},
    {"unsupported_dimension", error, "The points do not have three coordinates.", "点の座標が 3 個ではありません。"},
    {"unsupported_format", error, "The format is known and cannot be read.", "対応していない形式です。"},
    {"unsupported_version", error, "The version of the format cannot be read.", "対応していない版の形式です。"},
    {"utf16", error, "The text is UTF-16.", "テキストが UTF-16 です。"},
    {"wrong_byte_order", error, "The numbers make sense in the other byte order alone.",
     "数のバイト順が逆になっています。"},
    {"zeros", error, "The file holds zeros alone.", "ファイルがゼロだけです。"},

    // Headers and counts.
    {"count_behind_word", warning, "The first count stands right behind the first word.",
     "最初の個数が先頭の語の直後に空白なしで続いています。"},
    {"count_too_large", error, "A count is more than the file can hold.", "個数がファイルの大きさに収まりません。"},
    {"missing_element", error, "The head names no vertices.", "ヘッダーに頂点の要素がありません。"},
    {"missing_format", error, "The head names no encoding.", "ヘッダーに format の行がありません。"},
    {"missing_name", error, "A property of the head has no name.", "ヘッダーのプロパティに名前がありません。"},
    {"missing_property", error, "The head leaves out coordinates of vertices or corners of faces.",
     "頂点の座標または面の頂点のプロパティがありません。"},
    {"negative_count", error, "A count is negative.", "個数が負です。"},
    {"property_without_element", error, "A property of the head belongs to no element.",
     "プロパティが、どの要素にも属していません。"},
    {"repeated_element", error, "The head names an element twice.", "ヘッダーに同じ要素が二度あります。"},
    {"too_many_elements", error, "There is more than 32-bit numbers count.", "総数が 32 ビットの番号に収まりません。"},
    {"unknown_encoding", error, "The head names an unknown encoding.", "ヘッダーの符号化が未知のものです。"},
    {"unknown_type", error, "The head names an unknown type of number.", "ヘッダーの数の型が未知のものです。"},

    // Numbers, lines and elements of a file.
    {"element_index_out_of_range", warning, "A line or point names a vertex that does not exist.",
     "線または点の要素が、存在しない頂点を参照しています。"},
    {"extra_data", warning, "What stands behind the end of the mesh is left out.",
     "メッシュの終わりより後の部分を無視しました。"},
    {"extra_values", error_or_warning,
     "A line has more numbers than have a meaning; left out where there is a warning.",
     "行の数が多すぎます（警告のときは余分な数を無視）。"},
    {"face_too_few_corners", warning, "A face has fewer than three corners; it is set aside.",
     "面の角が 3 個に足りません（隔離）。"},
    {"facet_many_corners", warning, "A facet of STL has more than three corners; it is kept as one face.",
     "STL の面の角が 3 個より多くあります（1 つの面として保持）。"},
    {"index_out_of_range", warning, "A face names a vertex that does not exist; it is set aside.",
     "面が、存在しない頂点を参照しています（隔離）。"},
    {"material_library_missing", warning, "A material library is not there.", "マテリアルファイルがありません。", true},
    {"material_library_no_file", warning, "A material library is a folder, a pipe or a device.",
     "マテリアルファイルが、フォルダ、パイプ、デバイスのいずれかです。", true},
    {"material_library_outside", warning, "A material library outside the model's folder is not looked at.",
     "モデルのフォルダの外にあるマテリアルファイルは開きません。", true},
    {"material_library_unknown", warning, "The folder of a material library may not be read.",
     "マテリアルファイルのフォルダを読めません。", true},
    {"material_library_unnamed", warning, "A line mtllib names no file.", "mtllib の行にファイル名がありません。"},
    {"missing_endsolid", warning, "The last solid of STL has no end.", "STL の最後の solid に endsolid がありません。"},
    {"missing_number", error, "A line has too few numbers.", "行の数が足りません。"},
    {"no_faces", warning, "The file has no faces.", "ファイルに面がありません。"},
    {"no_vertices", warning, "The file has no vertices.", "ファイルに頂点がありません。"},
    {"nonfinite_number", warning, "A number is not finite.", "有限でない数があります。"},
    {"normal_index_out_of_range", warning, "A corner names a normal that does not exist.",
     "角が、存在しない法線を参照しています。"},
    {"number_out_of_type", error, "A number does not fit its type.", "数が型に収まりません。"},
    {"points_without_z", info, "The vertices of a file have no z; it is 0.", "頂点に z がないため、0 としました。"},
    {"read_by_words", warning, "Numbers do not stand line by line; they were read word by word.",
     "数が行ごとに並んでいないため、語の並びとして読みました。"},
    {"repeated_corner", warning, "A face visits a vertex twice; it is set aside.",
     "面が同じ頂点を二度通ります（隔離）。"},
    {"rounded_number", warning, "A number is rounded to its type.", "数を型に合わせて丸めました。"},
    {"short_face", error, "A list has fewer numbers than it announces.", "リストの数が、示された個数に足りません。"},
    {"texture_index_out_of_range", warning, "A corner names a texture coordinate that does not exist.",
     "角が、存在しないテクスチャ座標を参照しています。"},
    {"tristrips_kept", warning, "Lists of vertices in a further element of PLY are kept and not read as faces.",
     "PLY のその他の要素にある頂点のリストは面として読まず、そのまま保持します。"},
    {"unexpected_end", error_or_warning, "The file ends too early; what is there is read where there is a warning.",
     "ファイルが途中で終わっています（警告のときは、ある分を読みます）。"},
    {"unknown_keyword", error_or_warning,
     "A word is not understood; its line is left out, in a PLY header kept as it is, where there is a warning.",
     "語を解釈できません（警告のときは、その行を無視するか、PLY のヘッダーではそのまま保持）。"},
    {"unreadable_index", error, "What should be a whole number is none.", "整数として読めません。"},
    {"unreadable_number", error, "What should be a number is none.", "数として読めません。"},
    {"welded", info, "Corners at equal places became one vertex.", "同じ位置の角を一つの頂点にまとめました。"},
    {"zero_based", error, "Faces count vertices from 0 where the format counts from 1.",
     "1 から数える形式で、頂点の番号が 0 から始まっています。"},

    // What an output format cannot represent; the message gives the count.
    {"keeps_vertices", warning, "Removed vertices stay in the file, as something beside the mesh uses them.",
     "削除した頂点が、メッシュ以外の要素に使われるためファイルに残ります。"},
    {"loses_comments", warning, "Comments are lost.", "コメントが失われます。"},
    {"loses_elements", warning, "Lines and points are lost.", "線と点の要素が失われます。"},
    {"loses_exact_colours", warning, "Colours brighter than white, or between two bytes, are rounded.",
     "白より明るい色と、バイトでは表せない色が丸められます。"},
    {"loses_extra_elements", warning, "Further elements of PLY are lost.", "PLY のその他の要素が失われます。"},
    {"loses_face_colours", warning, "Colours of faces are lost.", "面の色が失われます。"},
    {"loses_groups", warning, "Names of groups are lost.", "グループ名が失われます。"},
    {"loses_head", warning, "The head of binary STL is lost.", "バイナリ STL の先頭部分が失われます。"},
    {"loses_isolated_vertices", warning, "Vertices without a face are lost.", "面に属さない頂点が失われます。"},
    {"loses_libraries", warning, "Material libraries are lost.", "マテリアルファイルの指定が失われます。"},
    {"loses_large_numbers", warning, "Coordinates become infinite in single precision.",
     "座標が単精度では無限大になります。"},
    {"loses_materials", warning, "Names of materials are lost.", "マテリアル名が失われます。"},
    {"loses_missing_colours", warning, "Vertices without a colour become white.", "色のない頂点が白になります。"},
    {"loses_normals", warning, "Normals are lost.", "法線が失われます。"},
    {"loses_objects", warning, "Names of objects are lost.", "オブジェクト名が失われます。"},
    {"loses_polygons", warning, "Faces of more than three corners are cut into triangles.",
     "4 頂点以上の面が三角形に分割されます。"},
    {"loses_precision", warning, "Coordinates are rounded to single precision.", "座標が単精度に丸められます。"},
    {"loses_properties", warning, "Further properties of PLY are lost.", "PLY のその他のプロパティが失われます。"},
    {"loses_quarantined", warning, "Quarantined faces are lost.", "隔離された面が失われます。"},
    {"loses_rings", warning, "Faces with rings are cut into triangles.", "穴のある面が三角形に分割されます。"},
    {"loses_small_numbers", warning, "Coordinates become 0 in single precision.", "座標が単精度では 0 になります。"},
    {"loses_smoothing", warning, "Smoothing groups are lost.", "スムージンググループが失われます。"},
    {"loses_texcoords", warning, "Texture coordinates are lost.", "テクスチャ座標が失われます。"},
    {"loses_third_texcoord", warning, "Third numbers of texture coordinates are lost.",
     "テクスチャ座標の 3 番目の数が失われます。"},
    {"loses_topology", warning, "Points at equal places become one, points at no place fall apart.",
     "同じ位置の点が一つになり、位置のない点がばらばらになります。"},
    {"loses_unread_lines", warning, "Lines that reading left out are not written.",
     "読み込み時に解釈できなかった行は書き出されません。"},
    {"loses_unread_rest", warning, "What stood behind the end of the mesh is not written.",
     "メッシュの終わりより後の部分は書き出されません。"},
    {"loses_unread_values", warning, "Numbers that reading left out or rounded are not written as they were.",
     "読み込み時に無視した、または丸めた数は、元のとおりには書き出されません。"},
    {"loses_vertex_colours", warning, "Colours of vertices are lost.", "頂点の色が失われます。"},
    {"loses_weights", warning, "Weights of vertices are lost.", "頂点の重みが失われます。"},
    {"loses_wires", warning, "Edges without a face are lost or become lines.",
     "面を持たない稜線が失われるか、線になります。"},

    // Outputs.
    {"input_would_be_replaced", error, "An output is a file that the run reads; --overwrite allows it.",
     "出力が、この実行で読み込むファイルを置き換えます（--overwrite で許可）。"},
    {"name_hides_format", error, "Under its name the output would not be read as its format again.",
     "その名前では、書き出す形式として読み直せません。"},
    {"output_is_folder", error, "The output is a folder.", "出力先がフォルダです。"},
    {"output_not_durable", error, "The output is written, and may not survive a power cut.",
     "書き出しましたが、停電が起きると残らないかもしれません。"},
    {"output_not_writable", error, "The output cannot be written.", "出力を書き込めません。"},
    {"output_would_be_replaced", error, "An output is one that the run has written before; --overwrite allows it.",
     "出力が、この実行で先に書き出したファイルを置き換えます（--overwrite で許可）。"},
};

}  // namespace codes

inline std::span<const CodeRow> code_table() { return codes::rows; }

// The code of a message. Constructed from a literal; an unknown code does not compile.
class Code {
 public:
  consteval Code(const char* id) : index_(find(id)) {}

  const CodeRow& row() const { return codes::rows[index_]; }
  constexpr operator std::string_view() const { return codes::rows[index_].id; }
  // Comparison with literals, and in tests with parsed text.
  friend constexpr bool operator==(Code a, Code b) { return a.index_ == b.index_; }
  friend constexpr bool operator==(Code a, std::string_view b) { return codes::rows[a.index_].id == b; }
  friend constexpr bool operator==(Code a, const char* b) { return codes::rows[a.index_].id == b; }

 private:
  static consteval std::size_t find(std::string_view id) {
    for (std::size_t i = 0; i < std::size(codes::rows); ++i)
      if (codes::rows[i].id == id) return i;
    throw "a code that ryosen/base/codes.h does not have";
  }

  std::size_t index_;
};

}  // namespace ryosen
