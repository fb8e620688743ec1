// An operator on many elements: once for each of them, judged when its turn comes, or once with all of them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/progress.h"
#include "ryosen/ops/all.h"

namespace ryosen {

struct EachResult {
  std::size_t done = 0;
  std::size_t calls = 0;  // that it took: fewer than done where several elements have one subject
  std::size_t gone = 0;   // deleted before their turn
  std::size_t ends = 0;   // vertices that were left with two edges and went too (OpInfo::takes_ends_along)
  struct Refused {
    Rule rule;  // the first that it breaks
    std::vector<Element> elements;
  };
  std::vector<Refused> refused;       // by rule, in the order in which they came up
  std::vector<Element> others;        // of a kind that the operator does not take
  NameError error = NameError::none;  // of arguments that cannot be: then nothing was done
  Text sentence = {};

  std::size_t refusals() const {
    std::size_t sum = 0;
    for (const Refused& r : refused) sum += r.elements.size();
    return sum;
  }
};

// Whether the operator takes an element of this kind in the place of its first argument, with the others behind it.
bool takes(const OpInfo& op, Element::Kind kind, std::span<const std::string_view> arguments);

// The elements of a selection that an operator is called with, in their order, and the others. Those that it takes;
// where these are too few, what its row has in place of what is selected (OpInfo::in_place_of), and then there are no
// others.
struct CalledWith {
  std::vector<Element> taken, others;
  bool is_in_place = false;
};
// How many it takes at least: two where one goes into another.
std::size_t least_taken(const OpInfo& op);
CalledWith called_with(const Mesh& mesh, const OpInfo& op, std::span<const Element> elements,
                       std::span<const std::string_view> arguments);

// Within one edit, in ascending order of kinds and slots, whatever their order is; a halfedge is the edge in its
// direction. Edges with the same subject (op.h) are one: what is done for the first is done for all. With
// OnSelection::into_last each element but the last is called together with the last, which comes first, or with what
// has taken its place; vertices that edges join to it come first, along these, so that a patch of a surface is not
// pinched. `mid` is then the middle of all these vertices. Those that stand in place of others are asked again as long
// as that does anything, and count as done where they have gone with another one. Ends that are taken along go last, in
// ascending order. `strict`: warnings refuse too. Cost: that of the calls. Cancelled: the edit is not to be committed.
EachResult apply_to_each(Edit& edit, const OpInfo& op, std::span<const Element> elements,
                         std::span<const std::string_view> arguments, bool strict, Progress& progress);

}  // namespace ryosen
