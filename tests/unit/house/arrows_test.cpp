// Every #include of the library and the program, held against the list of floors in arrows.txt: a folder includes only
// what the list allows it, and that lies on a floor below its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace ryosen {
namespace {

namespace fs = std::filesystem;

constexpr const char* list_path = "tests/unit/house/arrows.txt";

struct Floor {
  std::string name;
  std::set<std::string> below;  // what it may include
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
    while (words >> word)
      EXPECT_TRUE(floors.back().below.insert(word).second) << floors.back().name << " lists " << word << " twice";
  }
  return floors;
}

// The name in the list of a file, given by its path as includes write it: that of its folder, unless the list has it by
// itself, as "session/owners.h", "ops/op.*" or "shown/*.h".
std::string floor_of(const std::string& file, const std::vector<Floor>& floors) {
  const std::string folder = fs::path(file).parent_path().generic_string();
  for (const Floor& floor : floors) {
    const std::string_view name = floor.name;
    const std::size_t star = name.find('*');
    const bool matches = star == name.npos
                             ? name == file
                             : file.starts_with(name.substr(0, star)) && file.ends_with(name.substr(star + 1)) &&
                                   name.starts_with(folder + "/");
    if (matches) return floor.name;
  }
  return folder;
}

// Calls visit(file, header) for each include of a file of the project, with both paths as includes write them; the
// header of a package is given in its angle brackets.
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
        constexpr std::string_view directive = "#include ";
        if (!line.starts_with(directive)) continue;
        if (line[directive.size()] == '<') {
          visit(file, line.substr(directive.size(), line.find('>') + 1 - directive.size()));
          continue;
        }
        if (line[directive.size()] != '"') continue;
        const std::string header = line.substr(directive.size() + 1, line.rfind('"') - directive.size() - 1);
        const bool is_there = fs::exists(source / header) || fs::exists(source / "core" / header);
        EXPECT_TRUE(is_there) << file << " includes " << header << ", which is no path from a root";
        visit(file, header);
      }
    }
}

Arrows find_arrows(const std::vector<Floor>& floors) {
  Arrows arrows;
  const auto is_listed = [&](const std::string& header) {
    return std::any_of(floors.begin(), floors.end(), [&](const Floor& floor) { return floor.name == header; });
  };
  for_each_include([&](const std::string& file, const std::string& header) {
    if (header[0] == '<' && !is_listed(header)) return;
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
    for (const std::string& to : floor.below)
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
  for (const Floor& floor : floors)
    for (const std::string& to : floor.below) {
      ASSERT_TRUE(height.contains(to)) << floor.name << " lists " << to << ", which is no floor of " << list_path;
      const auto example = arrows.find({floor.name, to});
      EXPECT_LT(height[to], height[floor.name])
          << floor.name << " lies below " << to << (example == arrows.end() ? "" : ": " + example->second);
    }
}

}  // namespace
}  // namespace ryosen
