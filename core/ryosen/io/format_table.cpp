// The table of file formats.
#include <algorithm>
#include <cassert>
#include <utility>

#include "ryosen/io/formats.h"
#include "ryosen/io/obj.h"
#include "ryosen/io/off.h"
#include "ryosen/io/ply.h"
#include "ryosen/io/stl.h"
#include "ryosen/io/txt.h"
#include "ryosen/io/xyz.h"

namespace ryosen {
namespace {

constexpr Holds per_vertex_values = Holds::vertex_texcoords | Holds::vertex_normals | Holds::vertex_colours;

Holds obj_holds(Encoding) {
  return Holds::polygons | per_vertex_values | Holds::corner_texcoords | Holds::third_texcoord | Holds::corner_normals |
         Holds::groups | Holds::names | Holds::missing_colours | Holds::weights | Holds::elements | Holds::quarantine |
         Holds::any_vertex_colours | Holds::vertices | Holds::comments | Holds::doubles | Holds::wide_numbers;
}

Holds off_holds(Encoding) {
  return Holds::polygons | per_vertex_values | Holds::missing_colours | Holds::face_colours | Holds::any_face_colours |
         Holds::quarantine | Holds::vertices | Holds::comments | Holds::doubles | Holds::wide_numbers;
}

Holds ply_holds(Encoding encoding) {
  const Holds numbers = encoding == Encoding::ascii ? Holds::doubles | Holds::wide_numbers : Holds::doubles;
  return numbers | Holds::polygons | per_vertex_values | Holds::corner_texcoords | Holds::face_colours |
         Holds::quarantine | Holds::any_vertex_colours | Holds::vertices | Holds::properties | Holds::facet_attributes |
         Holds::comments;
}

Holds stl_holds(Encoding encoding) {
  const Holds both = Holds::flat_triangles;
  return encoding == Encoding::ascii ? both | Holds::groups | Holds::doubles | Holds::free_facets
                                     : both | Holds::facet_attributes | Holds::first_comment;
}

Holds txt_holds(Encoding) { return Holds::odd_triangles | Holds::vertices | Holds::doubles; }

// The built-in rows, followed by the added ones.
std::deque<Format>& all_formats() {
  static std::deque<Format> table = {
      {"obj",
       {"Wavefront OBJ", "Wavefront OBJ"},
       {".obj"},
       looks_like_obj,
       read_obj,
       [](const MeshFile& file, Encoding) { return write_obj(file); },
       obj_holds},
      {"ply",
       {"PLY (ascii, binary)", "PLY(テキスト、バイナリー)"},
       {".ply"},
       looks_like_ply,
       read_ply,
       write_ply,
       ply_holds,
       {{"ply-little", Encoding::binary_little}, {"ply-big", Encoding::binary_big}, {"ply-ascii", Encoding::ascii}}},
      {"off",
       {"OFF (COFF, NOFF, STOFF)", "OFF(COFF、NOFF、STOFF)"},
       {".off", ".coff", ".noff", ".stoff"},
       looks_like_off,
       read_off,
       [](const MeshFile& file, Encoding) { return write_off(file); },
       off_holds},
      {"stl",
       {"STL (ascii, binary)", "STL(テキスト、バイナリー)"},
       {".stl"},
       looks_like_stl,
       read_stl,
       write_stl,
       stl_holds,
       {{"stl-binary", Encoding::binary_little}, {"stl-ascii", Encoding::ascii}},
       false,
       true},
      {"txt",
       {"indexed triangle list", "三角形の番号リスト"},
       {".txt"},
       looks_like_txt,
       read_txt,
       [](const MeshFile& file, Encoding) { return write_txt(file); },
       txt_holds,
       {},
       true},
      {.id = "xyz",
       .name = {"list of points", "点の座標リスト"},
       .extensions = {".xyz"},
       .sniff = looks_like_xyz,
       .read = read_xyz,
       .shares_name = true,
       .may_be_empty = true},
  };
  return table;
}

}  // namespace

const std::deque<Format>& formats() { return all_formats(); }

bool is_unread_extension(std::string_view extension) {
  constexpr std::string_view unread[] = {".glb", ".gltf", ".fbx", ".3mf", ".dae", ".3ds"};
  return std::find(std::begin(unread), std::end(unread), extension) != std::end(unread) &&
         !format_of_extension("x" + std::string(extension));
}

ScopedFormat::ScopedFormat(Format format) {
  assert(!find_format(format.id) && "the id of a format is its own");
  row_ = &all_formats().emplace_back(std::move(format));
}

ScopedFormat::~ScopedFormat() {
  assert(row_ == &all_formats().back() && "the format that was added last goes first");
  all_formats().pop_back();
}

}  // namespace ryosen
