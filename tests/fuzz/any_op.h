// Operators made from bytes, with arguments that live, are dead, are none or were never there.
#pragma once

#include "ryosen/ops/all.h"
#include "tests/fuzz/bytes.h"

namespace ryosen::fuzz {

Vertex any_vertex(const Mesh& mesh, Bytes& bytes);
Halfedge any_halfedge(const Mesh& mesh, Bytes& bytes);
Face any_face(const Mesh& mesh, Bytes& bytes);
glm::dvec3 any_place(const Mesh& mesh, Bytes& bytes);

// An operator of the list with arguments in its members, or as a click on a target or a script line makes it. None
// where the line is not understood; `line` is then what was read.
std::optional<AnyOp> any_op(const Mesh& mesh, Bytes& bytes, std::string& line);

// The operator with its arguments by slot, whatever they are.
std::string by_slots(const AnyOp& op);

}  // namespace ryosen::fuzz
