#include "ryosen/analysis/mesh_kind.h"

#include <array>
#include <optional>
#include <string>

#include "ryosen/analysis/problems.h"
#include "ryosen/analysis/shells.h"
#include "ryosen/base/enum_table.h"

namespace ryosen {

namespace {

constexpr std::array<MeshKindRow, enum_count<MeshKind>> kind_rows{{
    {MeshKind::non_manifold, "non_manifold", "not manifold", "非多様体"},
    {MeshKind::one_sided, "one_sided", "one-sided", "裏表のない曲面"},
    {MeshKind::misoriented, "misoriented", "misoriented", "向きの不一致"},
    {MeshKind::surface, "surface", "surface", "曲面"},
    {MeshKind::inside_out, "inside_out", "inside out", "裏返し"},
    {MeshKind::solid, "solid", "solid", "立体"},
    {MeshKind::wires, "wires", "wires", "線"},
    {MeshKind::points, "points", "points", "点"},
    {MeshKind::empty, "empty", "empty", "空"},
}};

static_assert(rows_are_in_order(kind_rows, &MeshKindRow::kind),
              "the table has one row per kind, in the order of the enumeration");

// The lowest element of a kind of problem, by its name.
std::string first_of(const Mesh& mesh, const ProblemSets& sets, ProblemKind kind) {
  const std::uint32_t i = sets.of(kind).nth(0);
  return name_on_points(mesh, row_of(kind).element(i));
}

std::string face_name(Face f) { return "f" + std::to_string(f.index); }

KindOfMesh without_faces(const Mesh& mesh, const ProblemSets& sets, std::uint64_t lines) {
  const ElementCounts counts = sets.counts_on_points(mesh);
  const std::string edges = std::to_string(counts.edges), vertices = std::to_string(counts.vertices);
  if (counts.edges > 0 || lines > 0) {
    const std::string comma_en = counts.edges > 0 && lines > 0 ? ", " : "", comma_ja = comma_en.empty() ? "" : "、";
    Text found = counts.edges > 0 ? Text{"edges: " + edges, "稜線は " + edges + " 本"} : Text();
    if (lines > 0) {
      found.en += comma_en + "lines: " + std::to_string(lines);
      found.ja += comma_ja + "線は " + std::to_string(lines) + " 本";
    }
    return {MeshKind::wires,
            {"There is no usable face; " + found.en + ".", "使える面がありません。" + found.ja + "です。"}};
  }
  if (counts.vertices > 0)
    return {MeshKind::points,
            {"There is no usable face and no edge; vertices: " + vertices + ".",
             "面も稜線もありません。頂点は " + vertices + " 個です。"}};
  return {MeshKind::empty, {"There is neither face, edge nor vertex.", "面も稜線も頂点もありません。"}};
}

std::optional<KindOfMesh> if_not_manifold(Neighbourhood& around, const ProblemSets& sets) {
  const Mesh& mesh = around.mesh();
  if (sets.count(ProblemKind::nonmanifold_edge) > 0) {
    const Edge e(sets.of(ProblemKind::nonmanifold_edge).nth(0));
    const std::string name = name_on_points(mesh, e), faces = std::to_string(around.edge(halfedge(e)).faces());
    return KindOfMesh{MeshKind::non_manifold,
                      {"Edge " + name + " carries " + faces + " faces.",
                       "稜線 " + name + " に " + faces + " 枚の面が接しています。"}};
  }
  if (sets.count(ProblemKind::nonmanifold_vertex) == 0) return std::nullopt;
  const Vertex v(sets.of(ProblemKind::nonmanifold_vertex).nth(0));
  const std::string name = name_on_points(mesh, v), fans = std::to_string(around.fans(v));
  return KindOfMesh{MeshKind::non_manifold,
                    {"The faces at " + name + " form " + fans + " fans.",
                     name + " の周りの面が " + fans + " つの扇に分かれています。"}};
}

std::optional<KindOfMesh> if_faces_disagree(Neighbourhood& around, const ProblemSets& sets) {
  const Mesh& mesh = around.mesh();
  if (sets.count(ProblemKind::misoriented_edge) == 0) return std::nullopt;
  if (const Halfedge twist = find_twist(around)) {
    const std::string name = name_on_points(mesh, edge(twist));
    return KindOfMesh{
        MeshKind::one_sided,
        {"A walk over edge " + name + " comes back turned over.", "稜線 " + name + " を通って一周すると裏返ります。"}};
  }
  const std::string name = first_of(mesh, sets, ProblemKind::misoriented_edge);
  return KindOfMesh{MeshKind::misoriented,
                    {"The two faces at edge " + name + " are turned against each other; orient turns them.",
                     "稜線 " + name + " の両側の面の向きが食い違っています。orient で揃えます。"}};
}

// A point of a face without a finite place.
Vertex lost_corner(Neighbourhood& around, const ProblemSets& sets) {
  Vertex lost;
  sets.of(ProblemKind::nonfinite_vertex).for_each([&](std::uint32_t i) {
    if (!lost && around.fans(Vertex(i)) > 0) lost = Vertex(i);
  });
  return lost;
}

std::optional<KindOfMesh> if_open(Neighbourhood& around, const ProblemSets& sets) {
  const Mesh& mesh = around.mesh();
  if (sets.count(ProblemKind::boundary_loop) > 0) {
    const std::string name = first_of(mesh, sets, ProblemKind::boundary_loop);
    return KindOfMesh{
        MeshKind::surface,
        {"Edge " + name + " has a face on one side only.", "稜線 " + name + " の片側にしか面がありません。"}};
  }
  const Vertex lost = lost_corner(around, sets);
  if (!lost) return std::nullopt;
  const std::string name = name_on_points(mesh, lost);
  return KindOfMesh{MeshKind::surface,
                    {"A coordinate of " + name + " is not a finite number, so inside and outside are not known.",
                     name + " の座標が有限の数でなく、内側と外側を決められません。"}};
}

KindOfMesh of_shells(const Shells& shells) {
  for (const Shell& shell : shells.all) {
    const std::string name = face_name(shell.first);
    if (shell.turned == 0)
      return {MeshKind::surface,
              {"The shell of " + name + " encloses no volume.", name + " を含む閉じた殻に体積がありません。"}};
  }
  if (shells.meeting) {
    const std::string f = face_name(shells.meeting->first), g = face_name(shells.meeting->second);
    return {MeshKind::surface,
            {"Two shells cross or touch: faces " + f + " and " + g + " meet.",
             "二つの殻が交わるか接しています。面 " + f + " と " + g + " が出会います。"}};
  }
  for (const Shell& shell : shells.all) {
    const bool is_hollow = shell.depth % 2 == 1;
    if ((shell.turned < 0) == is_hollow) continue;
    const std::string name = face_name(shell.first), depth = std::to_string(shell.depth);
    if (shell.depth == 0)
      return {MeshKind::inside_out,
              {"The faces of the shell of " + name + " look inwards.", name + " を含む殻の面が内側を向いています。"}};
    return {MeshKind::inside_out,
            {"The shell of " + name + " lies at depth " + depth + " inside others and its faces look " +
                 (is_hollow ? "outwards, not inwards." : "inwards, not outwards."),
             name + " を含む殻は深さ " + depth + " で他の殻の内部にあり、面が" +
                 (is_hollow ? "内側でなく外側" : "外側でなく内側") + "を向いています。"}};
  }
  const std::string count = std::to_string(shells.all.size());
  if (shells.all.size() == 1)
    return {MeshKind::solid, {"The faces are closed and look outwards.", "面が閉じていて、外側を向いています。"}};
  return {MeshKind::solid,
          {"All " + count + " shells are closed and their faces look out of the solid.",
           count + " 個の殻がすべて閉じていて、面が立体の外を向いています。"}};
}

}  // namespace

std::span<const MeshKindRow> mesh_kind_table() { return kind_rows; }
const MeshKindRow& row_of(MeshKind kind) { return kind_rows[static_cast<std::size_t>(kind)]; }

bool is_kind_evident(const Mesh& mesh, const ProblemSets& sets) {
  if (mesh.live().faces == 0 || sets.count(ProblemKind::nonmanifold_vertex) > 0) return true;
  return sets.count(ProblemKind::misoriented_edge) == 0 && sets.count(ProblemKind::boundary_loop) > 0;
}

KindOfMesh find_kind(const Mesh& mesh, const ProblemSets& sets, std::uint64_t lines) {
  if (mesh.live().faces == 0) return without_faces(mesh, sets, lines);
  Neighbourhood around(mesh, is_kind_evident(mesh, sets) ? Neighbourhood::Reach::local : Neighbourhood::Reach::whole);
  if (const auto kind = if_not_manifold(around, sets)) return *kind;
  if (const auto kind = if_faces_disagree(around, sets)) return *kind;
  if (const auto kind = if_open(around, sets)) return *kind;
  return of_shells(find_shells(around));
}

}  // namespace ryosen
