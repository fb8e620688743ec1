// The two READMEs name the same commands of the program, subcommands and flags; what one shows, the other does too.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "app/cli/subcommand_table.h"
#include "app/editor/commands/commands.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

// Whatever stands between backticks or in a block of code, one text each; lines of blocks each for itself.
std::vector<std::string> code_in(const std::string& markdown) {
  std::vector<std::string> code;
  std::istringstream lines(markdown);
  bool is_block = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      is_block = !is_block;
    } else if (is_block) {
      code.push_back(line.substr(0, line.find('#')));
    } else {
      std::size_t begin = line.find('`');
      while (begin != line.npos) {
        const std::size_t end = line.find('`', begin + 1);
        if (end == line.npos) break;
        code.push_back(line.substr(begin + 1, end - begin - 1));
        begin = line.find('`', end + 1);
      }
    }
  }
  return code;
}

// Commands of scripts, subcommands as "ryosen check", and flags.
std::set<std::string> named_in(const std::string& markdown) {
  std::set<std::string> named;
  for (const std::string& text : code_in(markdown)) {
    std::istringstream words(text);
    std::vector<std::string> all;
    for (std::string word; words >> word;) all.push_back(word);
    if (all.empty()) continue;
    if (all[0] == "ryosen" && all.size() > 1 && cli::find_subcommand(all[1])) named.insert("ryosen " + all[1]);
    if (find_command_row(all[0])) named.insert(all[0]);
    if (all[0] == "ryosen" || all[0].starts_with("--"))
      for (const std::string& word : all)
        if (word.starts_with("--")) named.insert(word.substr(0, word.find('=')));
  }
  return named;
}

// But for the numbers, which stand in full in one language.
std::string readme(const char* name, const std::string& numbers) {
  const std::string all = test::read_file(std::string(RYOSEN_SOURCE_DIR) + "/" + name);
  const std::size_t end = all.find("\n## " + numbers + "\n");
  EXPECT_NE(end, all.npos) << name;
  return all.substr(0, end);
}

TEST(readme, in_japanese_names_what_the_english_one_names) {
  const std::set<std::string> english = named_in(readme("README.md", "Numbers")),
                              japanese = named_in(readme("README.ja.md", "数値"));
  EXPECT_GT(english.size(), 80u);
  for (const std::string& name : english) EXPECT_TRUE(japanese.contains(name)) << "missing in README.ja.md: " << name;
  for (const std::string& name : japanese) EXPECT_TRUE(english.contains(name)) << "missing in README.md: " << name;
}

}  // namespace
}  // namespace ryosen
