#include "ryosen/base/resource_limits.h"

#include <malloc.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <climits>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/split_list.h"

namespace ryosen {
namespace {

struct Limit {
  std::string name;
  std::uint64_t whole = 0, used = 0;
  std::uint64_t MemoryNeed::*counts = nullptr;

  std::uint64_t left() const { return whole - std::min(whole, used); }
};

// Word `i` of /proc/self/statm, in bytes: 0 is the address space, 5 the writable memory.
std::uint64_t own_size(unsigned i) {
  std::ifstream file("/proc/self/statm");
  std::uint64_t pages = 0;
  for (unsigned k = 0; k <= i; ++k) file >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void add_own_limit(std::vector<Limit>& limits, decltype(RLIMIT_AS) resource, const char* name, unsigned word,
                   std::uint64_t MemoryNeed::*counts) {
  rlimit limit;
  if (::getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    limits.push_back({name, limit.rlim_cur, own_size(word), counts});
}

void add_own_limits(std::vector<Limit>& limits) {
  add_own_limit(limits, RLIMIT_AS, "ulimit -v", 0, &MemoryNeed::addresses);
  add_own_limit(limits, RLIMIT_DATA, "ulimit -d", 5, &MemoryNeed::data);
}

std::optional<std::uint64_t> number_in(const std::string& path) {
  std::ifstream file(path);
  std::uint64_t number = 0;  // stays unread where the file says "max"
  return file >> number ? std::optional(number) : std::nullopt;
}

// What the system takes back from the group's cache of files when it needs room.
std::uint64_t reclaimable_in(const std::string& path) {
  std::ifstream file(path);
  constexpr std::string_view second[] = {"inactive_file", "active_file", "slab_reclaimable"};
  constexpr std::string_view first[] = {"total_inactive_file", "total_active_file"};
  std::uint64_t number = 0, of_second = 0, of_first = 0;  // version 1 also names those of the group alone
  for (std::string word; file >> word >> number;) {
    if (std::find(std::begin(second), std::end(second), word) != std::end(second)) of_second += number;
    if (std::find(std::begin(first), std::end(first), word) != std::end(first)) of_first += number;
  }
  return of_first > 0 ? of_first : of_second;
}

// A line of the list: ID:CONTROLLERS:GROUP, without controllers in version 2.
struct GroupLine {
  std::string_view controllers, group;
};

std::optional<GroupLine> split_group_line(std::string_view line) {
  const std::size_t first = line.find(':');
  if (first == std::string_view::npos) return std::nullopt;
  const std::size_t second = line.find(':', first + 1);
  if (second == std::string_view::npos) return std::nullopt;
  return GroupLine{line.substr(first + 1, second - first - 1), line.substr(second + 1)};
}

bool concern_memory(std::string_view controllers) {
  for (const std::string_view controller : split_list(controllers))
    if (controller == "memory") return true;
  return false;
}

// The control group of this process (version 2, or of memory in version 1), and all that it lies in.
void add_group_limits(std::vector<Limit>& limits, const ControlGroups& groups) {
  struct Files {
    const char *folder, *whole, *used;
  };
  std::ifstream list(groups.list);
  for (std::string line; std::getline(list, line);) {
    const auto parts = split_group_line(line);
    if (!parts || (!parts->controllers.empty() && !concern_memory(parts->controllers))) continue;
    const Files files = parts->controllers.empty()
                            ? Files{"", "/memory.max", "/memory.current"}
                            : Files{"/memory", "/memory.limit_in_bytes", "/memory.usage_in_bytes"};
    std::string group(parts->group);
    while (true) {
      if (group.ends_with('/')) group.pop_back();
      const std::string folder = groups.root + files.folder + group;
      const auto whole = number_in(folder + files.whole), used = number_in(folder + files.used);
      constexpr std::uint64_t none = std::uint64_t{1} << 60;  // version 1 writes a huge number
      if (whole && used && *whole < none)
        limits.push_back({"the control group (cgroup)", *whole,
                          *used - std::min(*used, reclaimable_in(folder + "/memory.stat")), &MemoryNeed::resident});
      if (group.find('/') == std::string::npos) break;
      group.resize(group.rfind('/'));
    }
  }
}

std::vector<Limit> memory_limits(const ControlGroups& groups) {
  std::vector<Limit> limits;
  add_own_limits(limits);
  add_group_limits(limits, groups);
  return limits;
}

}  // namespace

bool is_reserving_limited() {
  std::vector<Limit> limits;
  add_own_limits(limits);
  return !limits.empty();
}

void reserve_little_where_limited() {
  if (!is_reserving_limited()) return;
#ifdef __GLIBC__
  ::mallopt(M_ARENA_MAX, 1);
#endif
  // A stack that cannot grow later ends the program, so it grows now.
  constexpr std::size_t stack = std::size_t{1} << 19, page = 1 << 12;
  rlimit limit;
  if (::getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur < 2 * stack) return;
  [[maybe_unused]] volatile char room[stack];
  for (std::size_t i = 0; i < stack; i += page) room[i] = 0;
}

bool may_fit_in_memory(double bytes) {
  const double all = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  if (!(bytes <= all)) return false;
  const auto need = static_cast<std::uint64_t>(bytes);
  return !lack_of_memory({}, {need, need, need});
}

std::string memory_text(std::uint64_t bytes) {
  const double mib = static_cast<double>(bytes) / (1 << 20);
  if (mib < 1024) return std::to_string(std::llround(std::ceil(mib))) + " MiB";
  const auto tenths = static_cast<std::uint64_t>(std::ceil(mib / 102.4));
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GiB";
}

std::optional<Failure> lack_of_memory(const Text& what, const MemoryNeed& need, const ControlGroups& groups) {
  for (const Limit& limit : memory_limits(groups)) {
    if (limit.left() >= need.*limit.counts) continue;
    const std::string wanted = memory_text(need.*limit.counts), left = memory_text(limit.left()),
                      whole = memory_text(limit.whole);
    return make_failure(ExitCode::out_of_memory, "out_of_memory",
                        {what.en + " needs about " + wanted + " more memory, and " + limit.name + " leaves " + left +
                             " of its " + whole + "; raise that limit.",
                         what.ja + "には、あと約 " + wanted + " のメモリが必要ですが、" + limit.name + " の " + whole +
                             " の残りは " + left + " です。上限を上げてください。"});
  }
  return std::nullopt;
}

bool can_start_threads(unsigned count) {
  static std::atomic<bool> may_end;
  may_end = false;
  const auto wait = [](void*) -> void* {
    may_end.wait(false);
    return nullptr;
  };
  pthread_attr_t small;
  if (pthread_attr_init(&small) != 0) return false;
  pthread_attr_setstacksize(&small, std::max<std::size_t>(PTHREAD_STACK_MIN, std::size_t{1} << 16));
  std::vector<pthread_t> threads;
  threads.reserve(count);
  for (pthread_t thread; threads.size() < count && pthread_create(&thread, &small, wait, nullptr) == 0;)
    threads.push_back(thread);
  pthread_attr_destroy(&small);
  may_end = true;
  may_end.notify_all();
  for (const pthread_t thread : threads) pthread_join(thread, nullptr);
  return threads.size() == count;
}

}  // namespace ryosen
