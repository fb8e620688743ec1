#include "ryosen/algo/repair/orient_faces.h"

#include <algorithm>
#include <string>

#include "ryosen/algo/repair/detach_nonmanifold.h"
#include "ryosen/algo/repair/pair_faces.h"
#include "ryosen/algo/repair/turn_outwards.h"
#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/count_text.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/orient.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/turn_faces.h"

namespace ryosen {

namespace {

std::vector<Element> misoriented_edges(const Mesh& m) {
  Neighbourhood around(m, Neighbourhood::Reach::whole);
  const auto is_misoriented = row_of(ProblemKind::misoriented_edge).edge;
  std::vector<Element> edges;
  for (std::uint32_t i = 0; i < m.edge_slots(); ++i)
    if (m.is_alive(Edge(i)) && is_misoriented(around, Edge(i))) edges.emplace_back(Edge(i));
  return edges;
}

// Whether turning the face would make it and another triangle on its points a hanging pair.
bool would_hang(Neighbourhood& around, Face f) {
  const Mesh& m = around.mesh();
  if (corner_count(m, f) != 3 || !equal_face(m, f)) return false;
  std::size_t of_two_alike = 0;
  for (Halfedge h : halfedges_around(m, f)) of_two_alike += around.edge(h).is_misoriented();
  return of_two_alike >= 2;
}

// First so that neighbours agree, then outwards.
std::vector<bool> faces_to_turn(const Mesh& m, Progress& progress) {
  std::vector<bool> turned = turned_by_orient(m);
  Neighbourhood around(m);
  for (std::uint32_t f = 0; f < turned.size(); ++f) turned[f] = turned[f] && !would_hang(around, Face(f));
  const bool agrees = std::find(turned.begin(), turned.end(), true) == turned.end();
  const std::vector<bool> outwards = agrees ? faces_to_turn_outwards(m, progress)
                                            : faces_to_turn_outwards(Mesh(turn_faces(m, turned).columns), progress);
  for (std::size_t f = 0; f < outwards.size(); ++f) turned[f] = turned[f] != outwards[f];
  return turned;
}

}  // namespace

std::size_t count_turned_wrong(const Mesh& mesh, Progress& progress) {
  const std::vector<bool> turned = faces_to_turn_outwards(mesh, progress);
  return static_cast<std::size_t>(std::count(turned.begin(), turned.end(), true));
}

AlgorithmResult orient_faces(Edit& edit, const AlgorithmInput&, Progress& progress) {
  const Mesh& m = edit.mesh();
  AlgorithmResult result;
  const std::vector<bool> turned = faces_to_turn(m, progress);
  if (progress.is_cancelled()) return {};
  if (std::find(turned.begin(), turned.end(), true) != turned.end()) {
    TurnedMesh now = turn_faces(m, turned);
    if (is_torn(m, Mesh(now.columns))) {
      Mesh apart = m;
      Edit on_apart(apart, nullptr);
      detach_nonmanifold(on_apart, {}, progress);
      on_apart.commit();
      const std::vector<bool> turned_apart = faces_to_turn(apart, progress);
      if (progress.is_cancelled()) return {};
      now = turn_faces(apart, turned_apart);
    }
    result.changed = now.effect.changed.size();
    edit.replace(std::move(now.columns));
  }
  std::vector<Element> left = misoriented_edges(edit.mesh());
  result.left = left.size();
  add_left(result.left_for,
           {"the surface has one side only there, or its faces would lie back to back",
            "そこでは曲面に表裏がないか、裏返すと面が背中合わせに重なるため"},
           std::move(left));
  result.text =
      count_text(result.changed, "One face was turned round or joined to a neighbour",
                 "# faces were turned round or joined to their neighbours", "面を # 枚、裏返すか隣の面とつなぎました");
  if (const std::string n = std::to_string(result.left); result.left > 0) {
    result.text.en += "; " + n + (result.left == 1 ? " edge stays" : " edges stay") + " misoriented";
    result.text.ja += "（向きの揃わない稜線 " + n + "）";
  }
  result.text.en += ".";
  result.text.ja += "。";
  return result;
}

}  // namespace ryosen
