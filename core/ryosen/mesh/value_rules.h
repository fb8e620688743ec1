// How an element gets its attribute values from the elements that it comes from.
//
//              copies                       divides                       unites
//   blend      weighted mean                that of the source            weighted mean
//   first      of the first source          that of the source            of the first source
//   greatest   largest of the sources       that of the source            largest of the sources
//   sum        of a single source; the      its share of the source,      the sum of all sources
//              default between several      integers by remainders
//   own        what the function of the attribute makes of them; a copy of one source is its value
//
// Collapse and weld unite points and the edges that come to lie on each other; unite_edge unites two edges, dissolve
// and unite_loop faces. Splits of all kinds divide. A swap keeps the value of the edge. What else is new has the
// default or copies what it stands beside.
//
// Only floats and doubles have means; `blend` of integers and booleans is `first`. A row of numbers goes number by
// number. The points of a mesh share their value among their copies, and so does an undirected edge among its halves
// that are cut apart.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ryosen/mesh/columns.h"

namespace ryosen {

// A derived value, from the values of a column at these indices, at least one, and as many weights, which add up to 1.
// A mean of equal values is equal to them, bit for bit. Sources without weight count only where values are united, and
// never in a mean; what lies between several takes no sum of them, wherever it lies. `value` has the words of the
// column's type.
void derive_value(const AttributeColumn& column, std::span<const std::uint32_t> sources,
                  std::span<const double> weights, Derivation derivation, std::span<std::uint32_t> value);

// The values of parts that a source is divided into by shares, one after the other. Shares need not add up to 1; where
// they add up to nothing or are not finite, parts are equal. Sums of integers stay: what rounding leaves goes to the
// parts with the largest remainders, of equal ones to the first.
std::vector<std::uint32_t> divide_value(const AttributeColumn& column, std::uint32_t source,
                                        std::span<const double> shares);

}  // namespace ryosen
