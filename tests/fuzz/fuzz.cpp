// The program that a fuzzer drives. RYOSEN_FUZZ_TARGET names the target that gets the inputs.
#include <functional>
#include <vector>

#include "tests/fuzz/failure.h"
#include "tests/fuzz/reading.h"
#include "tests/fuzz/targets/targets.h"

namespace ryosen::fuzz {
namespace {

struct Target {
  std::string name;  // that of its corpus, too
  std::function<void(Input)> run;
};

// Includes a target for the reader of each format, named by its id.
std::vector<Target> target_table() {
  std::vector<Target> targets{
      {"gz", fuzz_gzip}, {"hull", fuzz_hull}, {"ops", fuzz_ops}, {"round_trip", fuzz_round_trip}};
  for (const Format& format : formats())
    targets.push_back({std::string(format.id), [&format](Input input) {
                         read_any(format, {reinterpret_cast<const char*>(input.data()), input.size()});
                       }});
  return targets;
}

// The target that the environment names; otherwise lists all and ends the program.
Target chosen_target() {
  const char* name = std::getenv("RYOSEN_FUZZ_TARGET");
  const std::vector<Target> targets = target_table();
  for (const Target& target : targets)
    if (name && target.name == name) return target;
  std::cerr << (name ? "unknown target " + std::string(name) : "no target") << "; set RYOSEN_FUZZ_TARGET to one of:";
  for (const Target& target : targets) std::cerr << ' ' << target.name;
  std::cerr << std::endl;
  std::exit(2);
}

const Target& target() {
  static const Target chosen = chosen_target();
  return chosen;
}

}  // namespace
}  // namespace ryosen::fuzz

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  ryosen::fuzz::target();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ryosen::fuzz::target().run({data, size});
  return 0;
}
