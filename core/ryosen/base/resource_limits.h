// What the system lets this process have: memory and threads.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ryosen/base/result.h"

namespace ryosen {

// Bytes that something will take in addition to what the process has.
struct MemoryNeed {
  std::uint64_t addresses = 0;  // of address space, which ulimit -v counts
  std::uint64_t data = 0;       // of writable memory, which ulimit -d counts
  std::uint64_t resident = 0;   // of memory in use, which control groups count
};
inline MemoryNeed operator+(const MemoryNeed& a, const MemoryNeed& b) {
  return {a.addresses + b.addresses, a.data + b.data, a.resident + b.resident};
}

// Whether ulimit -v or -d limits the memory of this process, which counts what is reserved too.
bool is_reserving_limited();

// Where they do, lets the allocator reserve no more than it uses (each thread may reserve 64 MiB otherwise), and the
// stack take what it needs. Before the first thread.
void reserve_little_where_limited();

// Where the system tells of control groups; another place for tests.
struct ControlGroups {
  std::string list = "/proc/self/cgroup";  // those of this process
  std::string root = "/sys/fs/cgroup";
};

// The failure out_of_memory, which names `what` ("Drawing"), its need and the limit, where a limit leaves less than
// that; none where no limit does, which is no promise. O(1); allocates little.
std::optional<Failure> lack_of_memory(const Text& what, const MemoryNeed& need, const ControlGroups& groups = {});

// Whether the machine has so much memory and no limit leaves less: no promise either.
bool may_fit_in_memory(double bytes);

// "300 MiB", "2.4 GiB".
std::string memory_text(std::uint64_t bytes);

// Whether so many threads can be had at the same time; starts and ends them.
bool can_start_threads(unsigned count);

// The answer to std::bad_alloc.
inline constexpr std::string_view out_of_memory_en =
    "There is not enough memory; allow more (ulimit -v), close other programs, or take a smaller mesh.";
inline constexpr std::string_view out_of_memory_ja =
    "メモリが足りません。上限（ulimit -v）を上げるか、他のプログラムを閉じるか、小さいメッシュを使ってください。";

inline Failure out_of_memory() {
  return make_failure(ExitCode::out_of_memory, "out_of_memory",
                      {std::string(out_of_memory_en), std::string(out_of_memory_ja)});
}

}  // namespace ryosen
