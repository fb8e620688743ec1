// Outer borders of flat sheets, which are no holes: a patch would only double the sheet.
#pragma once

#include "ryosen/algo/repair/rims.h"

namespace ryosen {

// Gives WhyOpen::flat_sheet to the holes that are to be tried and are the outer border of a sheet: the faces that are
// joined to its rim over edges lie in the plane of the rim like the rim itself, and a patch would face the other way,
// so that nothing would be enclosed. O(faces).
void tell_flat_sheets(const Mesh& mesh, const Rims& rims, std::vector<Hole>& holes);

}  // namespace ryosen
