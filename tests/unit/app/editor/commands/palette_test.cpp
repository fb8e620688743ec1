#include "app/editor/commands/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "app/editor/commands/command_syntax.h"
#include "app/editor/session/asking.h"
#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> session_with_cube() {
  auto document = Document::open(test::asset("cube.obj"));
  EXPECT_TRUE(document);
  return std::make_unique<Session>(std::move(document).value());
}

PaletteEntry entry_of(std::string_view line) {
  for (const PaletteEntry& entry : palette_entries())
    if (entry.line == line) return entry;
  ADD_FAILURE() << line;
  return {};
}

std::string first_for(std::string_view typed) {
  const std::vector<PaletteEntry> found = find_in_palette(typed);
  return found.empty() ? "" : found[0].line;
}

TEST(palette, has_every_line_once) {
  std::set<std::string> lines;
  for (const PaletteEntry& entry : palette_entries()) {
    EXPECT_TRUE(lines.insert(entry.line).second) << entry.line;
    EXPECT_FALSE(entry.name.en.empty() || entry.name.ja.empty()) << entry.line;
    EXPECT_TRUE(call_of(entry.line)) << entry.line;
  }
  for (const CommandRow* row : command_table()) EXPECT_TRUE(lines.contains(std::string(row->id))) << row->id;
}

TEST(palette, finds_by_any_word_in_either_language_best_first) {
  EXPECT_EQ(first_for("collapse"), "collapse");
  EXPECT_EQ(first_for("COLLAPSE EDGE"), "collapse");
  EXPECT_EQ(first_for("edge collapse"), "collapse");
  EXPECT_EQ(first_for("稜線削除"), "collapse");
  EXPECT_EQ(first_for("histor"), "panel history");
  EXPECT_EQ(first_for("履歴"), "panel history");
  EXPECT_EQ(first_for("mean curvature"), "colours mean_curvature");
  EXPECT_EQ(first_for("平均曲率"), "colours mean_curvature");
  EXPECT_EQ(first_for("stop comparing"), "compare off");
  EXPECT_EQ(first_for("比較を終える"), "compare off");
  EXPECT_TRUE(find_in_palette("no such thing").empty());
  EXPECT_EQ(find_in_palette("").size(), palette_entries().size());
  for (const PaletteEntry& entry : find_in_palette("boundary")) {
    std::string all = entry.line + entry.name.en + entry.help.en;
    std::transform(all.begin(), all.end(), all.begin(), [](unsigned char c) { return std::tolower(c); });
    EXPECT_NE(all.find("boundary"), all.npos) << entry.line;
  }
}

// How near a name is to what begins with a word: its own beginning, that of one of its words, the inside of one.
int nearness(const PaletteEntry& entry, const std::string& word) {
  std::string names[] = {entry.line, entry.name.en, entry.name.ja, entry.help.en, entry.help.ja};
  int best = 3;
  for (std::string& text : names) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
      const bool begins_name = at == 0 && &text < &names[3];
      const bool begins_word = at == 0 || !std::isalnum(static_cast<unsigned char>(text[at - 1]));
      best = std::min(best, begins_name ? 0 : begins_word ? 1 : 2);
    }
  }
  return best;
}

TEST(palette, has_the_beginnings_of_names_first_and_the_insides_of_words_last) {
  std::set<std::string> words;
  for (const PaletteEntry& entry : palette_entries())
    for (std::size_t at = 0; at + 3 <= entry.name.en.size(); at += 4)
      if (std::all_of(&entry.name.en[at], &entry.name.en[at] + 3, [](char c) { return c >= 'a' && c <= 'z'; }))
        words.insert(entry.name.en.substr(at, 3));
  words.insert("ext");
  ASSERT_GT(words.size(), 100u);
  for (const std::string& word : words) {
    const std::vector<PaletteEntry> found = find_in_palette(word);
    for (std::size_t i = 1; i < found.size(); ++i)
      EXPECT_LE(nearness(found[i - 1], word), nearness(found[i], word))
          << word << ": " << found[i - 1].line << " before " << found[i].line;
  }
  EXPECT_EQ(find_in_palette("ext")[0].line, "extrude");
  EXPECT_EQ(find_in_palette("ext")[1].line, "extrude_edges");
  EXPECT_EQ(find_in_palette("ext")[2].line, "gesture extrude") << "as the tables have them";
}

// `move` alone is what scripts say of the pointer.
TEST(palette, finds_what_is_called_so_before_words_of_scripts) {
  EXPECT_EQ(first_for("move"), "translate");
  EXPECT_EQ(first_for("Scale"), "scale");
  EXPECT_EQ(first_for("move_vertex"), "move_vertex");
}

// Whoever looks for something does not know what it is called in scripts.
TEST(palette, every_entry_is_named_in_words) {
  for (const PaletteEntry& entry : palette_entries()) {
    EXPECT_NE(entry.name.ja, entry.line);
    EXPECT_EQ(entry.name.en.find_first_of("|["), std::string::npos) << entry.name.en;
    EXPECT_TRUE(entry.name.en != entry.line || entry.line.find_first_of("0123456789_") == std::string::npos)
        << entry.line;
  }
  EXPECT_EQ(entry_of("compare").name.en, "Shows the mesh of a file beside the open one, by the same camera");
  EXPECT_EQ(entry_of("compare").name.ja, "ファイルのメッシュを同じ視点で隣に並べる");
}

TEST(palette, shows_the_syntax_of_what_is_begun) {
  const std::vector<PaletteEntry> found = find_in_palette("split 0-1");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].line, "split");
  EXPECT_EQ(found[0].syntax, "A-B [t|X,Y,Z]");
}

TEST(palette, works_on_what_is_selected_or_asks_for_it) {
  const auto session = session_with_cube();
  EXPECT_EQ(choice_of(session->findings(), session->selecting, entry_of("poke")).line, "tool poke");
  EXPECT_EQ(choice_of(session->findings(), session->selecting, entry_of("make_edge")).line, "ask make_edge");
  EXPECT_EQ(choice_of(session->findings(), session->selecting, entry_of("undo")).line, "undo");
  EXPECT_EQ(choice_of(session->findings(), session->selecting, entry_of("translate")).line, "values translate");
  const PaletteChoice open = choice_of(session->findings(), session->selecting, entry_of("open"));
  EXPECT_EQ(open.kind, PaletteChoice::Kind::begin);
  EXPECT_EQ(open.line, "open ");
  session->run("select f0 f1");
  EXPECT_EQ(choice_of(session->findings(), session->selecting, entry_of("poke")).line, "poke selected");
  EXPECT_EQ(choice_of(session->findings(), session->selecting, entry_of("make_edge")).line, "ask make_edge")
      << "faces are no ends of an edge";
}

TEST(palette, measures_what_is_selected_or_asks_for_it_and_keeps_what_goes_on_as_it_was_typed) {
  const auto session = session_with_cube();
  EXPECT_EQ(choice_of(session->findings(), session->selecting, entry_of("measure")).line, "ask measure");
  session->run("select 0-1");
  EXPECT_EQ(choice_of(session->findings(), session->selecting, entry_of("measure")).line, "measure selected");
  const std::vector<PaletteEntry> found = find_in_palette("measure sel");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].line, "measure");
  EXPECT_EQ(found[1].line, "measure selected");
}

// Nothing that is offered is a line that could not be said.
TEST(palette, every_choice_is_a_line) {
  const auto session = session_with_cube();
  for (const char* selected : {"select none", "select f0", "select v0 v1", "select 0-1"}) {
    session->run(selected);
    for (const PaletteEntry& entry : palette_entries()) {
      const PaletteChoice choice = choice_of(session->findings(), session->selecting, entry);
      if (choice.kind == PaletteChoice::Kind::run)
        EXPECT_FALSE(fault_of_command(choice.line)) << choice.line;
      else
        EXPECT_TRUE(choice.line.ends_with(' ')) << choice.line;
    }
  }
}

}  // namespace
}  // namespace ryosen
