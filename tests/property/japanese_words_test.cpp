// One word for one thing in all Japanese sentences of the program: those of its tables and those made where they are
// said.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace ryosen::test {
namespace {

struct RetiredWord {
  const char* word;
  const char* said_now;
};

constexpr RetiredWord retired_words[] = {
    {"辺", "稜線"},       {"エッジ", "稜線 or 半稜線"}, {"除けて", "隔離"},
    {"除外", "隔離"},     {"縮退し", "面積ゼロの面"},   {"縮退面", "面積ゼロの面"},
    {"半辺", "半稜線"},   {"退化", "面積ゼロの面"},     {"つぶれた", "面積ゼロの面"},
    {"フリップ", "交換"},
};

// Other words that hold one of them, what the source texts themselves call an operator or a form, and their headings.
constexpr const char* words_that_stay[] = {"周辺",
                                           "辺細分",
                                           "反対辺",
                                           "ウィングドエッジ",
                                           "頂点→ハーフエッジのリンクの利用",
                                           "半辺データ構造の構築",
                                           "半辺の操作",
                                           "半辺（クラスなし）"};

std::vector<std::string> faults_of(std::string line) {
  for (const std::string word : words_that_stay)
    for (std::size_t at; (at = line.find(word)) != line.npos;) line.replace(at, word.size(), "_");
  std::vector<std::string> faults;
  for (const RetiredWord& retired : retired_words)
    if (line.find(retired.word) != line.npos) faults.push_back(retired.word + std::string(" is ") + retired.said_now);
  return faults;
}

TEST(japanese_words, retired_ones_are_found) {
  EXPECT_EQ(faults_of("二つの辺が交わります").size(), 1u);
  EXPECT_EQ(faults_of("半稜線の反対辺を辺細分のあと稜線の周辺で探す").size(), 0u);
  EXPECT_EQ(faults_of("ハーフエッジ").size(), 1u);
  EXPECT_EQ(faults_of("面が縮退し、除外されます").size(), 2u);
  EXPECT_EQ(faults_of("縮退（背中合わせの三角形）").size(), 0u);
}

TEST(japanese_words, are_the_same_for_the_same_thing_everywhere) {
  std::size_t japanese_lines = 0;
  for (const char* folder : {"core", "render", "app"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(RYOSEN_SOURCE_DIR "/" + std::string(folder))) {
      const std::string kind = entry.path().extension().string();
      if (kind != ".h" && kind != ".cpp" && kind != ".def") continue;
      std::ifstream in(entry.path());
      std::size_t number = 0;
      for (std::string line; std::getline(in, line); japanese_lines += line.find("\xe3\x81") != line.npos) {
        ++number;
        for (const std::string& fault : faults_of(line))
          ADD_FAILURE() << entry.path() << ":" << number << ": " << fault;
      }
    }
  }
  EXPECT_GT(japanese_lines, 500u) << "sentences have been looked at";
}

}  // namespace
}  // namespace ryosen::test
