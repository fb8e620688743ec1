#include "ryosen/ops/separate_fans.h"

#include <cassert>

#include "ryosen/mesh/copies.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter separate_fans_parameters[] = {
    with_words({"vertex", "Vertex", "頂点", "the vertex with several fans of faces", "面の扇が複数ある頂点"},
               required(vertex<&SeparateFans::vertex>("vN")))};

}  // namespace

constinit const OpInfo SeparateFans::info{.id = "separate_fans",
                                          .name_en = "Separate fans",
                                          .name_ja = "扇の分離",
                                          .line = {.lists = {separate_fans_parameters}},
                                          .help_en = "gives each fan of faces at a vertex a copy of its own",
                                          .help_ja = "頂点の面の扇ごとに複製の頂点を作る",
                                          .target = OpTargetKind::vertex,
                                          .group = OpGroup::join};

namespace {

std::vector<Vertex> with_several_fans(const Mesh& mesh, Vertex v) {
  std::vector<Vertex> found;
  for_each_copy(mesh, v, [&](Vertex copy) {
    if (fans_at(mesh, copy).size() > 1) found.push_back(copy);
  });
  return found;
}

}  // namespace

Verdict SeparateFans::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, vertex, verdict)) return verdict;
  if (with_several_fans(mesh, vertex).empty()) verdict.refuse(Rule::one_fan, {point(mesh, vertex)});
  return verdict;
}

OpEffect SeparateFans::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  Sheets sheets(edit);
  for (Vertex v : with_several_fans(edit.mesh(), vertex)) sheets.separate(v);
  const Vertex touched[] = {vertex};
  sheets.make_manifold(touched);
  return sheets.finish();
}

}  // namespace ryosen
