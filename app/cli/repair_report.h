// The report of a run of `repair`, as text and JSON.
#pragma once

#include <span>

#include "app/cli/repair_run.h"

namespace ryosen::cli {

// The rounds, each kind of finding of which the number is another now, and the loose pieces.
void print_repair(const RepairRun& run, const Console& console);

// The keys of repairs_keys.
void add_repair(Record<repair_shape>& json, const RepairRun& run, std::span<const Call> calls);

}  // namespace ryosen::cli
