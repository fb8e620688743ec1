// Holds another opinion on the operations of a mesh against the oracle's.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/support/core/oracle/operators.h"

namespace ryosen::oracle {

// One operation on which the two do not agree.
struct Disagreement {
  PolygonList mesh;
  Operation operation;
  bool oracle_legal = false;
  bool other_legal = false;
  Reasons reasons;  // the oracle's
};

std::string to_text(const Disagreement& disagreement);

// Asks `other_legal` for every operation of operations_of(points): each kind, each face at each edge, both directions.
// The operation names points and a face, so the other side can find its halfedge: the one from -> to on that face's
// edge.
std::vector<Disagreement> compare(const PolygonList& points, const std::function<bool(const Operation&)>& other_legal);

}  // namespace ryosen::oracle
