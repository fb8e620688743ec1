// What the table of the texts' places says shows each of them does so in a new window.
#include "app/editor/text_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/editor/playing.h"
#include "app/editor/script.h"
#include "app/editor/session.h"

namespace ryosen {
namespace {

TEST(text_places, are_each_shown_by_their_lines) {
  std::set<std::string_view> names;
  std::map<std::string_view, int> rows;
  for (const TextPlace& place : text_places()) {
    ++rows[place.text];
    EXPECT_TRUE(names.insert(place.place_en).second) << place.place_en;
    EXPECT_NE(place.where_en, place.where_ja);
    EXPECT_TRUE(place.where_en.ends_with('.')) << place.where_en;
    Session session(std::make_unique<Document>());
    bool plays = false;
    for (const ScriptLine& line : split_script(place.lines)) {
      const Outcome outcome = session.run(line.text);
      EXPECT_TRUE(outcome.done()) << line.text << ": " << outcome.sentence.en;
      plays |= line.text.starts_with("steps ");
    }
    ASSERT_EQ(session.player != nullptr, plays) << place.lines;
    if (plays) {
      EXPECT_GT(session.player->size(), 0u);
    }
    EXPECT_TRUE(place.lines.empty() || plays || session.mesh().live().faces > 0) << place.lines;
  }
  EXPECT_EQ(rows.size(), 4u);
  EXPECT_TRUE(std::is_sorted(text_places().begin(), text_places().end(),
                             [](const TextPlace& a, const TextPlace& b) { return a.text < b.text; }));
}

}  // namespace
}  // namespace ryosen
