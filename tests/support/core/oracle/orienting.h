// What orienting may do to a list of polygons, judged face by face.
#pragma once

#include <string>

#include "tests/support/core/oracle/polygons.h"

namespace ryosen::oracle {

// Empty, or what `after` has that orienting `before` must not give: another face than the old one or its turn about the
// first corner; on a component that can be oriented a misoriented pair, or more faces turned than not, or the lowest of
// as many; on another one a face turned without fewer misoriented pairs, or a patch or face whose turn would leave
// still fewer. Components are of faces alone with another one on a pair. Corners that a face names twice are not
// understood.
std::string wrong_orienting(const PolygonList& before, const PolygonList& after);

}  // namespace ryosen::oracle
