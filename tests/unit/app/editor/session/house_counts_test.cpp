// Counts of the sources that may only fall: each test fails where its count is not its bound. Lower the bound with the
// count; no change may raise one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/support/app/program.h"

namespace ryosen {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view session_header = "app/editor/session/session.h";

const fs::path& root() {
  static const fs::path folder = fs::path(RYOSEN_SOURCE_DIR);
  return folder;
}

// The text of a file by its path from the root or, as headers of the library are included, from core; else empty.
const std::string& text_of(const std::string& file) {
  static std::map<std::string, std::string> texts;
  const auto [entry, is_new] = texts.try_emplace(file);
  for (const fs::path& folder : {root(), root() / "core"})
    if (is_new && fs::exists(folder / file)) entry->second = test::read_file(folder / file);
  return entry->second;
}

// How often a word occurs, not as a part of a longer one.
std::size_t count_word(const std::string& text, const std::string& word) {
  const auto is_of_word = [&](std::size_t at) {
    return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '_');
  };
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
    if (!is_of_word(at + word.size()) && (at == 0 || !is_of_word(at - 1))) ++found;
  return found;
}

std::size_t lines_of(const std::string& file) {
  const std::string& text = text_of(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

// Paths of the program's sources relative to the root, with this extension.
std::vector<std::string> files_of_app(const std::string& extension) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(root() / "app"))
    if (entry.path().extension() == extension) files.push_back(fs::relative(entry.path(), root()).generic_string());
  return files;
}

const std::vector<std::string>& includes_of(const std::string& file) {
  static std::map<std::string, std::vector<std::string>> includes;
  const auto [entry, is_new] = includes.try_emplace(file);
  if (!is_new) return entry->second;
  constexpr std::string_view directive = "#include \"";
  const std::string& text = text_of(file);
  for (std::size_t at = text.find(directive); at != text.npos; at = text.find(directive, at)) {
    at += directive.size();
    entry->second.push_back(text.substr(at, text.find('"', at) - at));
  }
  return entry->second;
}

// All headers of the project that a file includes, also through others.
std::set<std::string> included_by(const std::string& file) {
  std::set<std::string> found;
  std::vector<std::string> open{file};
  while (!open.empty()) {
    const std::string next = open.back();
    open.pop_back();
    for (const std::string& header : includes_of(next))
      if (found.insert(header).second) open.push_back(header);
  }
  return found;
}

// The text of the class from its public part to its private part.
std::string public_part_of_session() {
  const std::string& text = text_of(std::string(session_header));
  const std::size_t begin = text.find(" public:", text.find("class Session {"));
  return text.substr(begin, text.find(" private:", begin) - begin);
}

// Declarations without parentheses, apart from those in braces and template arguments.
std::size_t data_members_in(const std::string& body) {
  static const std::regex no_member("^\\s*(public:)?\\s*(using|static|struct|class|enum|friend)\\b");
  const std::string text = std::regex_replace(body, std::regex("//[^\n]*"), "");
  std::size_t members = 0;
  int braces = 0, angles = 0, parentheses = 0;
  std::string declaration;
  for (const char c : text) {
    if (c == '{') ++braces;
    if (c == '<' && braces == 0) ++angles;
    if (braces + angles == 0) declaration += c;
    if (c == '}') --braces;
    if (c == '>' && braces == 0) --angles;
    if (braces == 0) parentheses += (c == '(') - (c == ')');
    const bool is_function = declaration.find('(') != std::string::npos;
    if (braces + angles + parentheses > 0 || !(c == ';' || (c == '}' && is_function))) continue;
    if (!is_function && !std::regex_search(declaration, no_member)) ++members;
    declaration.clear();
  }
  return members;
}

TEST(house_counts, public_data_members_of_the_session) { EXPECT_EQ(data_members_in(public_part_of_session()), 13u); }

TEST(house_counts, no_struct_of_the_program_has_over_20_data_members) {
  static const std::regex head("\\nstruct (\\w+)[^;{(]*\\{");
  std::size_t structs = 0;
  for (const std::string& file : files_of_app(".h")) {
    const std::string& text = text_of(file);
    for (std::sregex_iterator found(text.begin(), text.end(), head), end; found != end; ++found) {
      const std::size_t begin = static_cast<std::size_t>(found->position() + found->length());
      EXPECT_LE(data_members_in(text.substr(begin, text.find("\n};", begin) - begin)), 20u)
          << file << " " << found->str(1);
      ++structs;
    }
  }
  EXPECT_GT(structs, 80u);
}

TEST(house_counts, lines_of_the_header_of_the_session) { EXPECT_EQ(lines_of(std::string(session_header)), 129u); }

// `Session& name` before a comma or the end of the list.
TEST(house_counts, parameters_of_the_type_session) {
  std::size_t parameters = 0;
  for (const char* extension : {".h", ".cpp"})
    for (const std::string& file : files_of_app(extension)) {
      const std::string& text = text_of(file);
      constexpr std::string_view type = "Session& ";
      for (std::size_t at = text.find(type); at != text.npos; at = text.find(type, at + 1)) {
        const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", at + type.size());
        const bool is_longer = at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1]));
        if (!is_longer && end > at + type.size() && (text[end] == ',' || text[end] == ')')) ++parameters;
      }
    }
  EXPECT_EQ(parameters, 142u);
}

TEST(house_counts, lines_of_sources_that_reach_the_session) {
  std::size_t lines = 0;
  for (const std::string& file : files_of_app(".cpp"))
    if (included_by(file).contains(std::string(session_header))) lines += lines_of(file);
  EXPECT_EQ(lines, 8937u);
}

// Other files ask it (shown.h).
TEST(house_counts, one_file_begins_and_ends_trials) {
  for (const char* extension : {".h", ".cpp"})
    for (const std::string& file : files_of_app(extension)) {
      if (file == "app/editor/shown/shown.cpp") continue;
      for (const char* name : {"end_trial", "show_on_trial"}) EXPECT_EQ(count_word(text_of(file), name), 0u) << file;
      EXPECT_EQ(count_word(text_of(file), "document_->try_out"), 0u) << file;
      EXPECT_EQ(count_word(text_of(file), "document().try_out"), 0u) << file;
    }
}

}  // namespace
}  // namespace ryosen
