#include "ryosen/base/uninterrupted.h"

#include <time.h>

#include <atomic>

namespace ryosen {
namespace {

constexpr std::uint32_t closed = ~std::uint32_t{0};  // the program is being ended
constexpr std::uint32_t file_sections = 0xffff;      // the lower half counts these, the upper one those that print

std::atomic<std::uint32_t> sections = 0;
std::atomic<bool> is_asked = false;
std::atomic<End> end_of_program = nullptr;
static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<End>::is_always_lock_free);

// Returns the number before. Waits while the program is being ended, which is for ever unless it goes on after all.
std::uint32_t add_to_sections(std::uint32_t difference) noexcept {
  std::uint32_t now = sections;
  while (now == closed || !sections.compare_exchange_weak(now, now + difference)) {
    if (now != closed) continue;
    constexpr timespec moment{0, 1'000'000};
    ::nanosleep(&moment, nullptr);
    now = sections;
  }
  return now;
}

}  // namespace

Uninterrupted::Uninterrupted(Section section) noexcept : section_(section) {
  add_to_sections(static_cast<std::uint32_t>(section));
}

Uninterrupted::~Uninterrupted() {
  const auto own = static_cast<std::uint32_t>(section_);
  if (add_to_sections(0 - own) == own && is_asked) end_where_allowed(Patience::for_all_sections);
}

void set_end(End end) noexcept { end_of_program = end; }

void end_where_allowed(Patience patience) noexcept {
  const End end = end_of_program;
  if (!end) return;
  is_asked = true;
  std::uint32_t now = sections;
  while (now == 0 || (patience == Patience::for_files && now != closed && (now & file_sections) == 0)) {
    if (!sections.compare_exchange_weak(now, closed)) continue;
    is_asked = false;
    end(now != 0);
    sections = now;
    return;
  }
}

}  // namespace ryosen
