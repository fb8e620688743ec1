// Every #include of the library and the program, held against the list of floors in arrows.txt: a folder includes only
// what the list allows it, and that lies on a floor below its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace ryosen {
namespace {

namespace fs = std::filesystem;

// Arrows of the list that point upwards; no change may raise it.
constexpr std::size_t known_back_arrows = 7;

constexpr const char* list_path = "tests/unit/house/arrows.txt";

struct Floor {
  std::string name;
  std::map<std::string, bool> below;  // what it may include; true: marked as a back arrow
};

// An include that shows an arrow: "a.cpp includes b.h".
using Arrows = std::map<std::pair<std::string, std::string>, std::string>;

std::vector<Floor> read_list() {
  std::vector<Floor> floors;
  std::ifstream file(fs::path(RYOSEN_SOURCE_DIR) / list_path);
  EXPECT_TRUE(file) << list_path;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string word;
    if (line[0] != ' ' && words >> word) floors.push_back({word, {}});
    while (words >> word) {
      const bool is_back = word[0] == '!';
      const bool is_new = floors.back().below.try_emplace(word.substr(is_back), is_back).second;
      EXPECT_TRUE(is_new) << floors.back().name << " lists " << word << " twice";
    }
  }
  return floors;
}

// The name in the list of a file, given by its path as includes write it: that of its folder, unless the list has it by
// itself, as "session/owners.h" or "ops/op.*".
std::string floor_of(const std::string& file, const std::vector<Floor>& floors) {
  for (const Floor& floor : floors) {
    const std::string_view name = floor.name;
    if (name == file || (name.ends_with('*') && file.starts_with(name.substr(0, name.size() - 1)))) return floor.name;
  }
  return fs::path(file).parent_path().generic_string();
}

// Calls visit(file, header) for each include of a file of the project, with both paths as includes write them.
template <class Visit>
void for_each_include(Visit visit) {
  const fs::path source(RYOSEN_SOURCE_DIR);
  const struct { fs::path folder, root; } trees[] = {{"core/ryosen", "core"}, {"render", ""}, {"app", ""}};
  for (const auto& tree : trees)
    for (const auto& entry : fs::recursive_directory_iterator(source / tree.folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp" && extension != ".in") continue;
      const std::string file = fs::relative(entry.path(), source / tree.root).generic_string();
      std::ifstream text(entry.path());
      for (std::string line; std::getline(text, line);) {
        constexpr std::string_view directive = "#include \"";
        if (!line.starts_with(directive)) continue;
        const std::string header = line.substr(directive.size(), line.rfind('"') - directive.size());
        const bool is_there = fs::exists(source / header) || fs::exists(source / "core" / header);
        EXPECT_TRUE(is_there) << file << " includes " << header << ", which is no path from a root";
        visit(file, header);
      }
    }
}

Arrows find_arrows(const std::vector<Floor>& floors) {
  Arrows arrows;
  for_each_include([&](const std::string& file, const std::string& header) {
    const std::string from = floor_of(file, floors), to = floor_of(header, floors);
    if (from != to) arrows.try_emplace({from, to}, file + " includes " + header);
  });
  return arrows;
}

TEST(arrows, every_include_is_allowed_and_every_allowed_one_is_used) {
  const std::vector<Floor> floors = read_list();
  Arrows arrows = find_arrows(floors);
  EXPECT_GT(arrows.size(), 300u);
  for (const Floor& floor : floors)
    for (const auto& [to, is_back] : floor.below)
      EXPECT_TRUE(arrows.erase({floor.name, to}))
          << floor.name << " includes nothing of " << to << " any more; remove it from " << list_path;
  for (const auto& [arrow, example] : arrows)
    ADD_FAILURE() << arrow.first << " must not include " << arrow.second << " (" << list_path << "): " << example;
}

TEST(arrows, point_to_floors_below) {
  std::map<std::string, std::size_t> height;
  const std::vector<Floor> floors = read_list();
  for (const Floor& floor : floors) EXPECT_TRUE(height.emplace(floor.name, height.size()).second) << floor.name;
  const Arrows arrows = find_arrows(floors);
  std::size_t back_arrows = 0;
  for (const Floor& floor : floors)
    for (const auto& [to, is_back] : floor.below) {
      ASSERT_TRUE(height.contains(to)) << floor.name << " lists " << to << ", which is no floor of " << list_path;
      const auto example = arrows.find({floor.name, to});
      EXPECT_TRUE((height[to] > height[floor.name]) == is_back)
          << floor.name << " lies " << (is_back ? "above " : "below ") << to
          << (example == arrows.end() ? "" : ": " + example->second);
      back_arrows += is_back;
    }
  EXPECT_EQ(back_arrows, known_back_arrows) << "lower the bound with the count";
}

}  // namespace
}  // namespace ryosen
