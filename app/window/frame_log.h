// What the window tells those who test or time it, where RYOSEN_FRAME_LOG names a file: a line for each presented
// frame.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "ryosen/base/message.h"

namespace ryosen {

class Session;
struct Layout;
class FrameLog {
 public:
  FrameLog();

  // With the panel that lies over the view meanwhile.
  void reading(const Layout& layout, const std::filesystem::path& file);
  void progress(double share);
  // The pixels that were drawn, the time that took, what is shown, and what was said of the last command.
  void frame(const Session& session, const Text& said, std::int64_t pixels, double took_ms);

 private:
  std::ofstream log_;
  std::uint64_t frames_ = 0;
};

}  // namespace ryosen
