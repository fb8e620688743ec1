#include "tests/fuzz/starts.h"

#include <functional>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/ops/all.h"
#include "tests/fuzz/failure.h"
#include "tests/support/core/shapes.h"

namespace ryosen::fuzz {
namespace {

using namespace test;

Start from_list(IndexedMesh list) {
  Start start;
  start.tables = file_tables(list);
  start.mesh = from_indexed(std::move(list));
  return start;
}

Start from_faces(const Polygons& faces) { return from_list(indexed(faces)); }

void run(Mesh& mesh, std::initializer_list<std::string_view> lines) {
  for (std::string_view line : lines) {
    const ParsedOp parsed = parse_line(mesh, line);
    expect(parsed.op && check(mesh, *parsed.op).legal(), "the start line " + std::string(line));
    Edit edit(mesh, nullptr);
    apply(edit, *parsed.op);
    edit.commit();
  }
}

// A square with a square ring, whose bridge is there or not, and a face in the ring.
Start plate(bool has_bridge) {
  IndexedMesh list = indexed({{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}, {4, 5, 6, 7}});
  list.positions = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};
  list.bridged = {0};
  Start start = from_list(std::move(list));
  if (has_bridge) run(start.mesh, {"unite_ring 0 4 f0"});
  return start;
}

// A box of quads with a square tunnel through it.
Start tunnel() {
  const Polygons faces{{0, 1, 2, 3, 0, 8, 11, 10, 9, 8},
                       {4, 7, 6, 5, 4, 12, 13, 14, 15, 12},
                       {0, 4, 5, 1},
                       {1, 5, 6, 2},
                       {2, 6, 7, 3},
                       {3, 7, 4, 0},
                       {8, 9, 13, 12},
                       {9, 10, 14, 13},
                       {10, 11, 15, 14},
                       {11, 8, 12, 15}};
  IndexedMesh list = indexed(faces);
  for (std::size_t i = 0; i < list.positions.size(); ++i) {
    const double side = i < 8 ? 3 : 1, z = i / 4 % 2 == 0 ? 1 : -1;
    list.positions[i] = {side * (i % 4 == 1 || i % 4 == 2 ? 1 : -1), side * (i % 4 < 2 ? -1 : 1), z};
  }
  list.bridged = {0, 1};
  return from_list(std::move(list));
}

// Two triangles and a quad with texture coordinates and normals that differ along one edge, materials and groups.
Start seamed() {
  IndexedMesh list = indexed({{0, 1, 2}, {2, 1, 3}, {3, 1, 4, 5}});
  list.texcoords.pool = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0}, {1, 1, 0}};
  list.texcoords.index = {0, 1, 2, 3, 4, 1, 0, no_index, 2, 2};
  list.texcoords.components = 2;
  list.normals.pool = {{0, 0, 1}, {0, 1, 0}};
  list.normals.index = {0, 0, 0, 1, 1, 1, 0, 1, 0, 1};
  list.materials = {{"red", "blue"}, {0, 1, no_index}};
  list.groups = {{"one"}, {0, no_index, 0}};
  list.vertex_colours.assign(6, {0.5, 0.25, 1, 1});
  return from_list(std::move(list));
}

Start with_quarantine() {
  IndexedMesh list = indexed({{0, 1, 2}, {}, {2, 1, 3}, {}}, 6);
  list.quarantine = {{1, 0, "repeated_corner", {0, 1, 0}, {}, {}, {}},
                     {3, 0, "index_out_of_range", {1, 2, 9}, {}, {}, {}}};
  return from_list(std::move(list));
}

// Wires of all kinds: a tip at a face, between two faces, a lone one, a cycle.
Start wires() {
  Start start = from_faces({{0, 1, 2}, {3, 4, 5}});
  run(start.mesh, {"make_vertex 1,2,3", "make_edge 0 6", "make_edge 1 3", "make_vertex 5,5,5", "make_vertex 6,5,5",
                   "make_vertex 6,6,5", "make_edge 7 8", "make_edge 8 9", "make_edge 9 7"});
  return start;
}

// Two fans at one vertex, as deleting the edges between them leaves them; and a copy without a face.
Start fans() {
  Start start = from_faces({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {6, 7, 8}, {8, 9, 10}});
  run(start.mesh, {"delete_loop f1", "delete_loop f5"});
  return start;
}

const std::vector<std::function<Start()>>& starts() {
  static const std::vector<std::function<Start()>> all{
      [] { return Start(); },
      [] { return from_faces(tetrahedron()); },
      [] { return from_faces(cube()); },
      [] { return from_faces(torus_grid(3, 3)); },
      [] { return from_faces(two_quads()); },
      [] { return from_faces(closed_fan(5)); },
      [] { return from_faces(bow_tie()); },
      [] { return from_faces(fin()); },
      [] { return from_faces(moebius_strip()); },
      [] { return from_faces(two_tetrahedra_on_an_edge()); },
      [] {
        return from_faces({{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {0, 2, 1}, {2, 0, 3}});
      },
      [] {
        return from_faces({{0, 1, 2, 3, 4, 5}, {2, 1, 6, 7}, {7, 3, 2}, {0, 5, 8}, {8, 1, 0}});
      },
      [] { return plate(false); },
      [] { return plate(true); },
      tunnel,
      seamed,
      with_quarantine,
      wires,
      fans,
  };
  return all;
}

}  // namespace

std::size_t start_count() { return starts().size(); }
Start start(std::size_t number) { return starts()[number](); }

}  // namespace ryosen::fuzz
