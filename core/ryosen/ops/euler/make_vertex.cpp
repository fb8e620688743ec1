#include "ryosen/ops/euler/make_vertex.h"

#include <cassert>

#include "ryosen/ops/lines/arguments.h"

namespace ryosen {

Parsed<MakeVertex> MakeVertex::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  const MakeVertex op{in.place()};
  return in.result(op);
}

std::string MakeVertex::command(const Mesh&) const { return "make_vertex " + format_place(position); }

OpEffect MakeVertex::apply(Edit& edit) const {
  OpEffect effect;
  effect.created.push_back(edit.add_vertex(position));
  return effect;
}

}  // namespace ryosen
