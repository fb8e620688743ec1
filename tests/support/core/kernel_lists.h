// Carries lists of the oracle into the kernel and back.
#pragma once

#include <cstdint>
#include <map>

#include "ryosen/ops/all.h"
#include "tests/support/core/oracle/complex_operators.h"
#include "tests/support/core/oracle/operators.h"

namespace ryosen::test {

// The list connected, its points at random places that the seed decides.
Mesh kernel_mesh(const oracle::PolygonList& points, std::uint64_t seed);

// The mesh as a list over vertex slots, each copy for itself or each read as its point; the loops of a face with rings
// one behind the other.
oracle::PolygonList list_of(const Mesh& mesh, bool on_points);

// The halfedge from -> to of the edge at the face that the operation names, none where that face has no such side.
Halfedge halfedge_of(const Mesh& mesh, const oracle::Operation& operation);
AnyOp op_of(const Mesh& mesh, const oracle::Operation& operation);

// The mesh with rings, wires and fans, its vertices and faces by their slots. `places`: where each halfedge that has a
// face begins in the lists.
oracle::Complex complex_of(const Mesh& mesh, std::map<Halfedge, oracle::Place>* places = nullptr);

}  // namespace ryosen::test
