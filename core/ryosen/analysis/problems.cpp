#include "ryosen/analysis/problems.h"

#include <algorithm>

#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"

namespace ryosen {

namespace {

const QuarantinedFace* find_quarantined(std::span<const QuarantinedFace> quarantine, std::uint32_t face) {
  const auto place = std::lower_bound(quarantine.begin(), quarantine.end(), face,
                                      [](const QuarantinedFace& q, std::uint32_t f) { return q.face < f; });
  return place != quarantine.end() && place->face == face ? &*place : nullptr;
}

bool is_alive(const Mesh& mesh, Face f) { return mesh.exists(f) && mesh.is_alive(f); }

std::vector<Element> elements_of(const ProblemRow& row, Neighbourhood& around, const ProblemSets& sets,
                                 std::span<const QuarantinedFace> quarantine) {
  std::vector<Element> elements;
  if (row.kind == ProblemKind::boundary_loop) {
    const BoundaryLoops loops = find_boundary_loops(around, sets.of(row.kind));
    for (std::size_t i = 0; i < loops.size(); ++i) elements.emplace_back(edge(loops[i].front()));
  } else if (row.quarantined) {
    if (row.kind == ProblemKind::quarantined_face) elements.reserve(quarantine.size());
    for (const QuarantinedFace& face : quarantine)
      if (row.quarantined(face, around.mesh().file_vertices())) elements.emplace_back(Face(face.face));
  } else if (row.kind == ProblemKind::ring) {
    const Mesh& mesh = around.mesh();
    elements.reserve(mesh.live().rings);
    sets.of(row.kind).for_each([&](std::uint32_t i) {
      for (std::uint32_t r = mesh.first_ring(Face(i)); r != no_index; r = mesh.ring(r).next)
        elements.emplace_back(Face(i));
    });
  } else {
    elements.reserve(sets.count(row.kind));
    sets.of(row.kind).for_each([&](std::uint32_t i) { elements.push_back(row.element(i)); });
  }
  return elements;
}

Face last_face_at(const Mesh& mesh, Vertex v) {
  Face last;
  for_each_face_at(mesh, v, [&](Face f) {
    if (!last || f > last) last = f;
  });
  return last;
}

void add_that_more_are_left(Problem& found) {
  const std::string listed = std::to_string(found.intersections.pairs.size());
  const std::string all = std::to_string(found.intersections.count);
  found.text.en += " Of " + all + " pairs " + listed + " are listed.";
  found.text.ja += all + " 組のうち " + listed + " 組を挙げています。";
}

}  // namespace

std::vector<Problem> find_problems(const Mesh& mesh, const ProblemSets& sets, const FileFaces& file,
                                   SelfIntersections intersections) {
  Neighbourhood around(mesh);
  std::vector<Problem> problems;
  for (const ProblemRow& row : problem_table()) {
    Problem problem{row.kind, elements_of(row, around, sets, file.quarantine), {}, {}, 0, {}};
    if (row.kind == ProblemKind::self_intersection) {
      problem.elements.assign(intersections.faces.begin(), intersections.faces.end());
      problem.intersections = std::exchange(intersections, {});
    }
    if (problem.elements.empty()) continue;
    problem.where = place_of(mesh, problem.elements.front(), file);
    problem.line = line_of(mesh, problem.kind, problem.elements.front(), file);
    problem.text = row.sentence(problem.count());
    if (!problem.intersections.is_all()) add_that_more_are_left(problem);
    problems.push_back(std::move(problem));
  }
  return problems;
}

std::optional<glm::dvec3> place_of(const Mesh& mesh, Element element, const FileFaces& file) {
  std::vector<glm::dvec3> points;
  if (element.kind != Element::Kind::face || is_alive(mesh, element.face())) {
    for_each_vertex(mesh, element, [&](Vertex v) { points.push_back(mesh.position(v)); });
  } else if (const QuarantinedFace* q = find_quarantined(file.quarantine, element.index)) {
    for (std::int64_t corner : q->corners)
      if (corner >= 0 && corner < mesh.file_vertices() && mesh.is_alive(Vertex(corner)))
        points.push_back(mesh.position(Vertex(corner)));
  }
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& p : points) mean += p / static_cast<double>(points.size());
  if (points.empty() || !is_finite(mean)) return std::nullopt;
  return mean;
}

std::uint64_t line_of(const Mesh& mesh, ProblemKind kind, Element element, const FileFaces& file) {
  Face face;
  switch (element.kind) {
    case Element::Kind::vertex:
      if (file.vertex_lines && row_of(kind).is_of_the_vertex)
        return file.vertex_lines->line(point(mesh, element.vertex()).index);
      face = last_face_at(mesh, element.vertex());
      break;
    case Element::Kind::halfedge:
      face = Neighbourhood(mesh).last_face(element.halfedge());
      break;
    case Element::Kind::edge:
      face = Neighbourhood(mesh).last_face(halfedge(element.edge()));
      break;
    case Element::Kind::face:
      face = element.face();
      if (is_alive(mesh, face)) break;
      if (const QuarantinedFace* q = find_quarantined(file.quarantine, face.index)) return q->line;
      return 0;
  }
  return face && face.index < file.lines.size() ? file.lines[face.index] : 0;
}

std::string name_on_points(const Mesh& mesh, Element element) {
  const auto number = [](Vertex v) { return std::to_string(v.index); };
  switch (element.kind) {
    case Element::Kind::vertex:
      return "v" + number(point(mesh, element.vertex()));
    case Element::Kind::face:
      return "f" + std::to_string(element.index);
    case Element::Kind::halfedge: {
      const Halfedge h = element.halfedge();
      return number(point(mesh, mesh.from(h))) + "-" + number(point(mesh, mesh.to(h)));
    }
    case Element::Kind::edge:
      break;
  }
  const auto [a, b] = ends(mesh, element.edge());
  const Vertex p = point(mesh, a), q = point(mesh, b);
  return number(std::min(p, q)) + "-" + number(std::max(p, q));
}

}  // namespace ryosen
