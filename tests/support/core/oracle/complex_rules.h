// Whether what an operator did to a list with rings, wires and fans was legal.
#pragma once

#include "tests/support/core/oracle/complex_operators.h"

namespace ryosen::oracle {

// The rules of a verdict. Local operators are judged on separated lists by all of them; Euler operators may leave
// several fans and change boundary loops and components.
bool is_legal_local(const ComplexFacts& before, const Outcome& outcome);
bool is_legal_euler(const ComplexFacts& before, const Outcome& outcome);
// For lists of points that are read anew afterwards: no new fault, and the same edges with three or more faces or with
// faces in one direction.
bool is_legal_on_points(const ComplexFacts& before, const Outcome& outcome);

}  // namespace ryosen::oracle
