// What an operator would be called with on the selection, and whether it may be done: what menus and the palette offer.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/ops/all.h"

namespace ryosen {

class Findings;
class Selecting;

// The elements that an operator works on where it is told `selected`: the selection; where it takes none of that and
// all that is seen of some kind is selected, all that is seen of the kind that it takes, faces before edges before
// vertices. O(selection), and O(mesh) only in the second case.
Elements worked_on(const Findings& findings, const Selecting& selecting, const OpInfo& op,
                   std::span<const std::string_view> arguments);

// The elements that it takes with these arguments behind each, in their order; all of them where one alone is not
// enough.
Elements elements_taken(const OpInfo& op, const Elements& elements, std::span<const std::string_view> arguments);

// The operator on the selection, of those that take all of it at once, with these arguments behind its elements; or why
// there is none.
ParsedOp op_on_selection(const Findings& findings, const Selecting& selecting, const OpInfo& op,
                         std::span<const std::string_view> arguments);

// Whether what is selected, or a part of it, can be what an operator works on with these arguments behind each.
bool fits_selection(const Findings& findings, const Selecting& selecting, const OpInfo& op,
                    std::span<const std::string_view> arguments = {});

// Whether an operator may be done on a selection that fits it, or any of its calls; else why the first may not. Of a
// large selection, and of what is united one by one, it is not known before: it may be.
struct Offer {
  bool may_be = true;
  std::vector<Text> why_not = {};
};
// Cost: that of at most 64 verdicts.
Offer offer_on_selection(const Findings& findings, const Selecting& selecting, const OpInfo& op);

}  // namespace ryosen
