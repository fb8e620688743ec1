// Lets allocations of this program (operator new) fail.
#pragma once

namespace ryosen::test {

enum class Failing { once, from_then_on };

// The nth allocation from now on, counted from 1 over all threads, throws std::bad_alloc.
void fail_allocation(long nth, Failing failing);
// Returns whether any failed, and lets all succeed again.
bool fail_no_more();
// Allocations since the last call of fail_allocation(), those that failed included.
long counted_allocations();
// Blocks that are allocated and not released.
long living_blocks();

}  // namespace ryosen::test
