// Colours of a simplified surface, fitted to those of the surface as it was.
#pragma once

#include "ryosen/algo/simplify/near_samples.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// Gives the vertices that stand for others or have moved the colours by which the squared differences from the colours
// of the samples, summed over their areas, are least, within the range of the colours of the input. Colours that
// already fit stay to the bit, and so do vertices that something keeps in their place. O(samples).
void fit_colours(Edit& edit, const CollapseSurface& surface, const NearSamples& samples, const Mesh& input);

}  // namespace ryosen
