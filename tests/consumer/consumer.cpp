// What a program that uses the library does. consumer IN A-B OUT: loads IN, walks around A, asks whether edge A-B may
// collapse, collapses it where it may, undoes that, and saves OUT.
#include <iostream>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/collapse_edge.h"

int main(int count, char** arguments) {
  if (count != 4) return 2;
  ryosen::Result<ryosen::MeshFile> file = ryosen::read_mesh_file(arguments[1]);
  if (!file) return std::cerr << file.failure().message.text.en << '\n', 1;
  const ryosen::FileTables tables = ryosen::file_tables(file->mesh);
  ryosen::Mesh mesh = ryosen::from_indexed(std::move(file->mesh));

  const ryosen::Named<ryosen::Halfedge> edge = ryosen::find_edge(mesh, arguments[2]);
  if (!edge.ok()) return std::cerr << edge.sentence.en << '\n', 1;
  std::cout << "ring:";
  for (const ryosen::Vertex v : ryosen::neighbours(mesh, mesh.from(edge.element))) std::cout << ' ' << name_of(mesh, v);

  const ryosen::CollapseEdge collapse{edge.element};
  const ryosen::Verdict verdict = collapse.check(mesh);
  for (const ryosen::Reason& reason : verdict.reasons) std::cout << "\nrefused: " << ryosen::text_of(reason.rule).id;
  if (verdict.legal()) {
    ryosen::Journal journal;
    ryosen::Edit edit(mesh, &journal);
    collapse.apply(edit);
    edit.commit();
    std::cout << "\ncollapsed: V " << mesh.live().vertices << ", E " << mesh.live().edges;
    journal.undo(mesh);
  }
  std::cout << "\nat the end: V " << mesh.live().vertices << ", E " << mesh.live().edges << '\n';
  file->mesh = ryosen::to_indexed(mesh, tables).mesh;
  return ryosen::write_mesh_file(arguments[3], file.value()).ok() ? 0 : 1;
}
