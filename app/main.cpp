#include "app/cli/run.h"

int main(int argc, char** argv) { return static_cast<int>(ryosen::cli::run({argv + 1, argv + argc})); }
