#include "ryosen/indexed/indexed.h"

#include <gtest/gtest.h>

#include <random>

namespace ryosen {
namespace {

TEST(line_runs, give_back_every_line) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::uint64_t> lines;
    LineRuns whole;
    std::uint64_t lines_before = 0;
    for (std::uint32_t file = 0; file < 3; ++file) {
      LineRuns part;
      std::uint64_t line = 0;
      for (std::uint32_t i = 0; i < random() % 20; ++i) {
        line += random() % 3 == 0 ? 1 + random() % 4 : 1;
        part.add(line);
        lines.push_back(lines_before + line);
      }
      whole.append(part, lines_before);
      lines_before += line + random() % 3;
    }
    for (std::uint32_t i = 0; i < lines.size(); ++i) ASSERT_EQ(whole.line(i), lines[i]) << "seed " << seed << " " << i;
    EXPECT_EQ(whole.line(static_cast<std::uint32_t>(lines.size())), 0u);
  }
}

TEST(line_runs, go_on_after_another_part_was_added) {
  LineRuns lines, next;
  lines.add(3);
  next.add(1);
  lines.append(next, 10);
  lines.add(12);
  lines.add(20);
  for (const auto& [element, line] : {std::pair(0u, 3u), {1u, 11u}, {2u, 12u}, {3u, 20u}})
    EXPECT_EQ(lines.line(element), line) << element;
}

}  // namespace
}  // namespace ryosen
