#include "ryosen/ops/euler/make_vertex.h"

#include <cassert>

#include "ryosen/ops/parameters/member_values.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter make_vertex_parameters[] = {with_words(
    {"at", "Position", "座標", "where the vertex lies", "頂点の座標"}, required(position<&MakeVertex::position>()))};

}  // namespace

constinit const OpInfo MakeVertex::info{.id = "make_vertex",
                                        .name_en = "Make vertex",
                                        .name_ja = "頂点生成",
                                        .line = {.lists = {make_vertex_parameters}},
                                        .help_en = "makes an isolated vertex at a position",
                                        .help_ja = "指定した位置に孤立頂点を置く",
                                        .target = OpTargetKind::none,
                                        .group = OpGroup::euler,
                                        .aliases = "mvs",
                                        .on_selection = OnSelection::none};

OpEffect MakeVertex::apply(Edit& edit) const {
  const Vertex made = edit.add_vertex(position);
  edit.fresh(made);
  return {.created = {made}};
}

}  // namespace ryosen
