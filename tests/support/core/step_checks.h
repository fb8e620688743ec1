// What holds for everything that is played step by step.
#pragma once

#include "ryosen/textbook/steps/sequence.h"

namespace ryosen::test {

// Forward to the end and back to the start the mesh has its hashes again, in any order; the same step is the same each
// time; captions, sources and marks are whole; the rows of the kernel's tables are what changed between the meshes, and
// a delta is what changed of the kernel's own sum.
void expect_plays(steps::Sequence& sequence);

}  // namespace ryosen::test
