#include "ryosen/ops/euler/separate_edge.h"

#include <cassert>

#include "ryosen/mesh/rings.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/point_in_edge.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter separate_edge_parameters[] = {
    with_words({"edge", "Edge", "稜線", "the edge that gets a vertex", "頂点を入れる稜線"},
               required(edge<&SeparateEdge::halfedge>("A-B"))),
    with_words({"at", "Fraction along the edge", "割合",
                "where the vertex lies, from 0 at A to 1 at B (in the middle if it is left out)",
                "頂点の位置。A が 0、B が 1 の割合（省くと中央）"},
               optional(number<&SeparateEdge::along>("t")))};

}  // namespace

constinit const OpInfo SeparateEdge::info{.id = "separate_edge",
                                          .name_en = "Divide edge",
                                          .name_ja = "稜線分割",
                                          .line = {.lists = {separate_edge_parameters}},
                                          .help_en = "puts a vertex into an edge without cutting faces",
                                          .help_ja = "面を切らずに稜線の途中に頂点を入れる",
                                          .target = OpTargetKind::edge,
                                          .group = OpGroup::euler,
                                          .aliases = "semv",
                                          .topology = Topology::kept,
                                          .subject = Subject::points};

Verdict SeparateEdge::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, halfedge, verdict)) return verdict;
  if (is_bridge(mesh, halfedge)) verdict.refuse(Rule::loop, {edge(halfedge), mesh.face(halfedge)});
  return verdict;
}

std::vector<Reason> SeparateEdge::warnings(const Mesh&) const {
  std::vector<Reason> reasons;
  warn_of_place(halfedge, along, reasons);
  return reasons;
}

OpEffect SeparateEdge::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  OpEffect effect;
  put_point_into(edit, halfedge, along, CutTriangles::no, effect);
  return effect;
}

}  // namespace ryosen
