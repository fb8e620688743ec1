// `help json`: every key and code that the program prints, with its meaning.
#pragma once

#include "app/cli/console.h"

namespace ryosen::cli {

void show_contract(const Console& console);

}  // namespace ryosen::cli
