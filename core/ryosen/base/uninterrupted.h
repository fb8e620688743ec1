// Where a signal may end the program: anywhere, except in short sections that finish what they have begun.
#pragma once

#include <cstdint>

namespace ryosen {

// While one lives, end_where_allowed() only leaves a note, and the last one to go ends the program then. Sections may
// nest and may be on several threads. Costs two atomic additions; allocates nothing.
class Uninterrupted {
 public:
  // print: may be held up by a slow reader, so that a signal need not wait for it for ever.
  enum class Section : std::uint32_t { file = 1, print = 1u << 16 };

  explicit Uninterrupted(Section section) noexcept;
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;

 private:
  Section section_;
};

// What ends the program. It is called on any thread, also within a signal handler, while no section is under way, but
// one that prints where `is_printing`, and none can begin; where it returns, the program goes on. Without one no signal
// ends anything.
using End = void (*)(bool is_printing);
void set_end(End end) noexcept;

// Ends the program now, or behind the sections under way. May be called within a signal handler.
enum class Patience { for_all_sections, for_files };
void end_where_allowed(Patience patience) noexcept;

}  // namespace ryosen
